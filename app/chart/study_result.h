// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/chart/history_table.h"
#include "app/chart/run_record.h"
#include "app/chart/study_grid.h"
#include "solver/scene/scene.h"

namespace hydroscope {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// One quantity at one value of its driver.
struct ComparedValue {
  double at = kUnknown;     ///< of the driver; unknown: the end of the run
  double value = kUnknown;  ///< nan: the run did not come there
  double reference = kUnknown;
  double error_percent = kUnknown;
};

struct RunResult {
  StudyRun run;
  std::filesystem::path folder;
  bool is_known = false;  ///< it has been run
  std::string cause{};    ///< why it counts as failed; empty: it does not
  std::string outcome{};
  int exit_code = 0;
  double fraction = 0.0;  ///< of the process time that it came to
  int increments = 0;
  double factorisations = kUnknown;
  double own_wall = kUnknown;                        ///< [s] of solving in the accuracy run, beside others
  std::vector<double> walls{};                       ///< [s] of solving, timed alone
  std::vector<std::vector<ComparedValue>> values{};  ///< by quantity
  double error_percent = kUnknown;                   ///< largest, or root mean square, of all values

  bool is_failed() const { return !cause.empty(); }
  double wall() const;  ///< median of the timed ones; nan without
};

struct CaseResult {
  const StudyCase* one = nullptr;
  std::vector<RunResult> runs{};  ///< without the finest
  std::optional<RunResult> finest{};
};

double calc_median(std::vector<double> values);

/// What a finished run left in its folder. `end` is its record; nothing when it has not been run.
RunResult read_run_result(const StudyCase& one, const StudyRun& run, const std::filesystem::path& folder,
                          const std::optional<RunEnd>& end);

/// Seconds of solving in a run's summary.json: search, assembly, factorisation, solution, update. Nan
/// without a summary.
double read_solving_time(const std::filesystem::path& folder);

/// Fills in references and errors; a run that misses a value becomes a failed one.
void compare_case(CaseResult& result);

}  // namespace hydroscope
