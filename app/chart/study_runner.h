// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "app/chart/run_queue.h"
#include "app/chart/study_report.h"
#include "app/chart/study_result.h"

namespace hydroscope {

struct StudyOptions {
  std::string program;  ///< that runs scenes: this program itself
  std::filesystem::path output;
  int jobs = 1;
  std::array<int, 2> size{1600, 1000};  ///< [px] of a picture
  std::string theme = "light";
  bool takes_any = false;  ///< takes the runs that are there, whatever program and scene made them
};

/// Runs what a study asks for and has not been done: first all accuracy runs, then the timed ones alone.
/// Returns false when it was interrupted.
bool run_study(const Study& study, const StudyOptions& options, const std::atomic<bool>& stop);

/// What the runs left, compared.
std::vector<CaseResult> read_study_results(const Study& study, const StudyOptions& options);

/// Pictures, tables and report.md. Throws EnvironmentError.
void write_study(const Study& study, const std::vector<CaseResult>& results, const StudyOptions& options);

}  // namespace hydroscope
