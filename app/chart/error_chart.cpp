// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "app/chart/pareto.h"
#include "app/chart/study_charts.h"

namespace hydroscope {
namespace {

constexpr Rgb kBeside{85, 85, 85};     ///< runs beside the grid, whose colours mean something
constexpr double kLeastError = 1e-5;   ///< [%]: less is not told apart on the chart
constexpr std::size_t kMostNamed = 4;  ///< failed runs are numbered when there are more

const std::vector<ChartMarker>& markers() {
  static const std::vector<ChartMarker> all = {ChartMarker::kCircle,  ChartMarker::kSquare,
                                               ChartMarker::kDiamond, ChartMarker::kTriangle,
                                               ChartMarker::kDown,    ChartMarker::kPlus};
  return all;
}

Rgb find_colour(int setting) {
  return chart_colours()[static_cast<std::size_t>(std::max(setting, 0)) % chart_colours().size()];
}

/// The axes that tell points apart: colour by the first of more than one setting, marker by the second.
std::vector<int> find_telling_axes(const StudyCase& one) {
  std::vector<int> axes;
  for (std::size_t i = 0; i < one.axes.size(); ++i)
    if (one.axes[i].settings.size() > 1) axes.push_back(static_cast<int>(i));
  return axes;
}

int find_setting(const RunResult& run, const std::vector<int>& axes, std::size_t rank) {
  if (rank >= axes.size() || run.run.settings.empty()) return -1;
  return run.run.settings[static_cast<std::size_t>(axes[rank])];
}

/// What colours and markers stand for; a product of both would fill the legend.
void add_legend(LineChart& chart, const StudyCase& one, const std::vector<int>& axes) {
  for (std::size_t rank = 0; rank < std::min<std::size_t>(axes.size(), 2); ++rank) {
    const StudyAxis& axis = one.axes[static_cast<std::size_t>(axes[rank])];
    for (std::size_t i = 0; i < axis.settings.size(); ++i) {
      ChartSeries entry{.name = axis.label + ": " + axis.settings[i].label, .line = ChartLine::kNone};
      entry.colour = rank == 0 ? find_colour(static_cast<int>(i)) : Rgb{120, 120, 120};
      entry.marker = rank == 0 ? (axes.size() > 1 ? ChartMarker::kCircle : markers()[i % markers().size()])
                               : markers()[i % markers().size()];
      chart.series.push_back(entry);
    }
  }
}

void add_points(LineChart& chart, const CaseResult& result, CostKind kind, const std::vector<int>& axes) {
  int variant = 0;
  for (const RunResult& run : result.runs) {
    const int first = find_setting(run, axes, 0), second = find_setting(run, axes, axes.size() > 1 ? 1 : 0);
    const bool is_variant = run.run.settings.empty();
    const int shape = is_variant ? variant : second, shade = is_variant ? variant : first;
    if (is_variant) ++variant;
    if (run.is_failed()) continue;
    ChartSeries point{.x = {find_cost(run, kind)},
                      .y = {std::max(run.error_percent, kLeastError)},
                      .labels = {run.run.label},
                      .colour = is_variant && !axes.empty() ? kBeside : find_colour(shade),
                      .line = ChartLine::kNone};
    point.marker = markers()[static_cast<std::size_t>(std::max(shape, 0)) % markers().size()];
    point.marker_size = 15.0;
    chart.series.push_back(point);
  }
}

void add_front(LineChart& chart, const CaseResult& result, CostKind kind) {
  std::vector<CostPoint> points;
  for (const RunResult& run : result.runs)
    points.push_back(
        {run.is_failed() ? kUnknown : find_cost(run, kind), std::max(run.error_percent, kLeastError)});
  ChartSeries front{.name = "Pareto front", .colour = Rgb{110, 110, 110}, .line = ChartLine::kDashed};
  for (const std::size_t i : find_pareto_front(points)) {
    front.x.push_back(points[i].cost);
    front.y.push_back(points[i].error);
  }
  if (!front.x.empty()) chart.series.push_back(front);
}

void add_default(LineChart& chart, const CaseResult& result, CostKind kind) {
  for (const RunResult& run : result.runs)
    if (run.run.id == result.one->standard && !run.is_failed())
      chart.series.push_back({.name = "default",
                              .x = {find_cost(run, kind)},
                              .y = {std::max(run.error_percent, kLeastError)},
                              .colour = Rgb{20, 20, 20},
                              .line = ChartLine::kNone,
                              .marker = ChartMarker::kRing,
                              .marker_size = 30.0});
}

void add_elsewhere(LineChart& chart, const StudyCase& one, CostKind kind) {
  ChartSeries series{.name = "measured elsewhere",
                     .colour = Rgb{90, 40, 120},
                     .line = ChartLine::kNone,
                     .marker = ChartMarker::kCross,
                     .marker_size = 17.0};
  for (const StudyElsewhere& point : one.elsewhere) {
    const auto cost = kind == CostKind::kWall ? point.wall_s : point.factorisations;
    if (!cost) continue;
    series.x.push_back(*cost);
    series.y.push_back(std::max(*point.error_percent, kLeastError));
    series.labels.push_back(point.label);
  }
  if (!series.x.empty()) chart.series.push_back(series);
}

/// Crosses, and below the legend who failed of what; what failed of the same stands together.
void add_failures(LineChart& chart, const CaseResult& result, CostKind kind) {
  const auto count = static_cast<std::size_t>(std::count_if(
      result.runs.begin(), result.runs.end(), [](const RunResult& run) { return run.is_failed(); }));
  chart.failure_title = "failed";
  std::vector<std::pair<std::string, std::string>> causes;  // cause, and who
  for (const RunResult& run : result.runs) {
    if (!run.is_failed()) continue;
    const std::string number = std::to_string(chart.failures.size() + 1);
    const std::string name = count > kMostNamed ? number + " (" + run.run.label + ")" : run.run.label;
    ChartFailure failure{std::nullopt, count > kMostNamed ? number : run.run.label};
    const double cost = find_cost(run, kind);
    if (std::isfinite(cost) && cost > 0.0) failure.x = cost;
    chart.failures.push_back(failure);
    const auto same =
        std::find_if(causes.begin(), causes.end(), [&](const auto& c) { return c.first == run.cause; });
    if (same == causes.end())
      causes.emplace_back(run.cause, name);
    else
      same->second += ", " + name;
  }
  if (!causes.empty()) chart.notes.push_back("Failed:");
  for (const auto& [cause, who] : causes) chart.notes.push_back(who + ": " + cause);
}

std::string describe_error(const StudyCase& one) {
  std::string names;
  for (const StudyQuantity& quantity : one.quantities) names += (names.empty() ? "" : ", ") + quantity.label;
  return (one.is_rms ? "root mean square of the errors in " : "largest error in ") + names;
}

}  // namespace

double find_cost(const RunResult& run, CostKind kind) {
  if (kind == CostKind::kFactorisations) return run.factorisations;
  return run.walls.empty() && run.is_failed() ? run.own_wall : run.wall();
}

StudyChart make_error_chart(const CaseResult& result, CostKind kind) {
  const StudyCase& one = *result.one;
  LineChart chart;
  chart.title = one.title;
  chart.subtitle = describe_error(one);
  chart.x = {.title = kind == CostKind::kWall ? "wall time of solving [s]" : "factorisations [-]",
             .scale = ChartScale::kLog};
  chart.y = {.title = "error [%]", .scale = ChartScale::kLog};
  const std::vector<int> axes = find_telling_axes(one);
  add_legend(chart, one, axes);
  add_front(chart, result, kind);
  add_points(chart, result, kind, axes);
  add_default(chart, result, kind);
  add_elsewhere(chart, one, kind);
  add_failures(chart, result, kind);
  return {one.name + (kind == CostKind::kWall ? "-error-wall" : "-error-factorisations"), chart};
}

}  // namespace hydroscope
