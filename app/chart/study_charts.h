// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/chart/study_result.h"
#include "render/chart/line_chart.h"

namespace hydroscope {

/// A chart of a study, and what its files are called.
struct StudyChart {
  std::string name;  ///< of NAME.png and NAME.csv
  LineChart chart;
};

enum class CostKind { kWall, kFactorisations };
double find_cost(const RunResult& run, CostKind kind);

/// Error against cost, both logarithmic: the front, the default, points of other programs, what failed.
StudyChart make_error_chart(const CaseResult& result, CostKind kind);
/// Columns of history.csv, one chart a column.
std::vector<StudyChart> make_history_charts(const CaseResult& result, const StudyHistory& history);
/// Error against the numbers of one axis, a line for each setting of the others, with fitted slopes.
StudyChart make_convergence_chart(const CaseResult& result, const StudyConvergence& convergence);
/// Thickness over the angle in saved states.
StudyChart make_profile_chart(const CaseResult& result, const StudyProfile& profile);
/// Columns of any CSV file.
StudyChart make_plot_chart(const StudyPlot& plot);

/// All charts of a case that its results allow.
std::vector<StudyChart> make_case_charts(const CaseResult& result);

/// The numbers behind a chart: series, label, x, y.
std::string make_chart_csv(const LineChart& chart);

}  // namespace hydroscope
