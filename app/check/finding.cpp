// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check/finding.h"

namespace hydroscope {

const char* to_string(CheckStage stage) {
  switch (stage) {
    case CheckStage::kSequence:
      return "sequence";
    case CheckStage::kValues:
      return "values";
    case CheckStage::kBalance:
      return "balance";
    case CheckStage::kClasses:
      return "classes";
    case CheckStage::kPixels:
      return "pixels";
  }
  return "";
}

std::string describe(const Finding& finding) {
  std::string text = to_string(finding.stage);
  if (!finding.view.empty()) text += ", " + finding.view;
  if (finding.frame > 0) text += ", frame " + std::to_string(finding.frame);
  return text + ": " + finding.text;
}

}  // namespace hydroscope
