// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/chart/machine.h"
#include "app/chart/study_result.h"

namespace hydroscope {

struct ReportFacts {
  Machine machine;
  std::string version;  ///< of the program
  std::string program_hash;
  std::string revision;  ///< of the folder that the study lies in; may be empty
  std::string renderer;
};

/// A case with the names of its pictures (without .png).
struct ReportedCase {
  const CaseResult* result = nullptr;
  std::vector<std::string> charts;
};

/// The report of a study, Markdown; pictures lie beside it.
std::string make_study_report(const Study& study, const std::vector<ReportedCase>& cases,
                              const std::vector<std::string>& plots, const ReportFacts& facts);

/// A line a run: settings, end, cost, error and every compared value.
std::string make_case_csv(const CaseResult& result);

/// A line a value: run, quantity, where, value, reference, error.
std::string make_values_csv(const CaseResult& result);

/// What there is to say of the default against the others, a sentence each.
std::vector<std::string> describe_default(const CaseResult& result);

}  // namespace hydroscope
