// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "render/image/image.h"

namespace hydroscope {

/// What was looked at when something was found, in the order in which it is done.
enum class CheckStage {
  kSequence,  ///< every state there, in order of time
  kValues,    ///< the numbers of the sidecars
  kBalance,   ///< forces of one state among themselves
  kClasses,   ///< contact classes as drawn against those solved
  kPixels,    ///< pictures
};
const char* to_string(CheckStage stage);

/// One reason to reject.
struct Finding {
  CheckStage stage = CheckStage::kSequence;
  std::string view;  ///< empty: of all views
  int frame = 0;     ///< from 1; 0: of the whole sequence
  std::string text;
};

/// "values, contact-map, frame 3: counts.stick: 41 instead of 42"
std::string describe(const Finding& finding);

/// A picture that was rejected.
struct PictureFinding {
  std::string view;
  int frame = 0;
  std::string text;
  Image expected, got;
};

struct CheckReport {
  std::vector<Finding> findings;
  std::vector<PictureFinding> pictures;
  std::vector<std::string> notes;  ///< worth knowing, no reason to reject
  int frames = 0;                  ///< of each view
  int sidecars_compared = 0, pictures_compared = 0, class_passes = 0;
  std::string renderer;
  double largest_share_off = 0.0;  ///< of a picture's pixels
  int largest_difference = 0;      ///< of a channel of any pixel
  double least_likeness = 1.0;     ///< of any window
  bool is_same_renderer = true;
  double seconds = 0.0;

  bool is_passed() const { return findings.empty(); }
};

}  // namespace hydroscope
