// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/study_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "app/chart/pareto.h"
#include "app/results/result_folder.h"
#include "render/view_text.h"
#include "solver/scene/number_text.h"

namespace hydroscope {
namespace {

/// Titles of the columns of history.csv.
std::string find_column_title(const std::string& column) {
  static const std::map<std::string, std::string> titles = {
      {"increment", "increment [-]"},
      {"time_s", "process time [s]"},
      {"pressure_MPa", "pressure [MPa]"},
      {"residual", "out-of-balance force against the reference force [-]"},
      {"tangential_rest", "tangential rest against the contact force [-]"},
      {"n_contact", "nodes in contact [-]"},
      {"step_fraction", "accepted part of the increment [-]"}};
  const auto found = titles.find(column);
  if (found != titles.end()) return found->second;
  // q.NAME_UNIT: the unit is the end of the name.
  std::string name = column.substr(column.rfind("q.", 0) == 0 ? 2 : 0);
  for (const std::string unit : {"N_per_mm", "mm", "MPa", "N", "deg", "s"})
    if (name.size() > unit.size() + 1 &&
        name.compare(name.size() - unit.size() - 1, std::string::npos, "_" + unit) == 0) {
      const std::string shown = unit == "N_per_mm" ? "N/mm" : unit;
      return name.substr(0, name.size() - unit.size() - 1) + " [" + shown + "]";
    }
  return name;
}

bool is_chosen(const std::vector<std::string>& runs, const std::string& id) {
  return runs.empty() || std::find(runs.begin(), runs.end(), id) != runs.end();
}

/// Runs and the finest one, if it is asked for by name.
std::vector<const RunResult*> choose_runs(const CaseResult& result, const std::vector<std::string>& ids) {
  std::vector<const RunResult*> runs;
  for (const RunResult& run : result.runs)
    if (run.is_known && is_chosen(ids, run.run.id)) runs.push_back(&run);
  if (result.finest && result.finest->is_known && !ids.empty() && is_chosen(ids, result.finest->run.id))
    runs.push_back(&*result.finest);
  return runs;
}

std::string format_slope(double slope) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", std::abs(slope) < 0.005 ? 0.0 : slope);
  return text.data();
}

/// The settings of a run but for one axis.
std::string find_other_settings(const StudyCase& one, const RunResult& run, std::size_t axis) {
  std::string label;
  for (std::size_t i = 0; i < one.axes.size(); ++i)
    if (i != axis && one.axes[i].settings.size() > 1)
      label += (label.empty() ? "" : " / ") +
               one.axes[i].settings[static_cast<std::size_t>(run.run.settings[i])].label;
  return label;
}

/// A dashed line of the fitted slope through the middle of the points.
ChartSeries make_fit(const std::vector<double>& x, const std::vector<double>& y, double slope) {
  double sum_x = 0.0, sum_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum_x += std::log(x[i]);
    sum_y += std::log(y[i]);
  }
  const double n = static_cast<double>(x.size());
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  ChartSeries fit{.line = ChartLine::kDotted, .line_width = 2.5};
  for (const double at : {*low / 1.2, *high * 1.2}) {
    fit.x.push_back(at);
    fit.y.push_back(std::exp(sum_y / n + slope * (std::log(at) - sum_x / n)));
  }
  return fit;
}

}  // namespace

std::vector<StudyChart> make_history_charts(const CaseResult& result, const StudyHistory& history) {
  std::vector<StudyChart> charts;
  for (const std::string& column : history.columns) {
    LineChart chart;
    chart.title = history.title.empty() ? result.one->title : history.title;
    chart.x = {.title = find_column_title(history.x)};
    chart.y = {.title = find_column_title(column),
               .scale = history.is_log ? ChartScale::kLog : ChartScale::kLinear};
    for (const RunResult* run : choose_runs(result, history.runs)) {
      const std::filesystem::path file = ResultFolder{run->folder}.history();
      if (!std::filesystem::exists(file)) continue;
      const HistoryTable table(file);
      if (!table.has(column)) {
        chart.notes.push_back("no column " + column + " in " + run->run.id);
        continue;
      }
      chart.series.push_back({.name = run->run.label + (run->is_failed() ? " (failed)" : ""),
                              .x = table.column(history.x),
                              .y = table.column(column)});
    }
    charts.push_back({result.one->name + "-" + history.name + "-" + column, chart});
  }
  return charts;
}

StudyChart make_convergence_chart(const CaseResult& result, const StudyConvergence& convergence) {
  const StudyCase& one = *result.one;
  const auto found = std::find_if(one.axes.begin(), one.axes.end(),
                                  [&](const StudyAxis& axis) { return axis.name == convergence.axis; });
  const auto axis = static_cast<std::size_t>(found - one.axes.begin());
  LineChart chart;
  chart.title = convergence.title.empty() ? one.title : convergence.title;
  const std::string unit = found->label.find('[') == std::string::npos ? " [-]" : "";
  chart.x = {.title = (found->is_inverse ? "1 / " : "") + found->label + unit, .scale = ChartScale::kLog};
  chart.y = {.title = "error [%]", .scale = ChartScale::kLog};
  std::map<std::string, std::size_t> places;
  std::vector<ChartSeries> lines;
  for (const RunResult& run : result.runs) {
    if (run.run.settings.empty()) continue;
    const std::string others = find_other_settings(one, run, axis);
    const auto [place, is_new] = places.try_emplace(others, lines.size());
    // Lines that lie on each other are told apart by their markers.
    const std::vector<ChartMarker> markers = {ChartMarker::kCircle, ChartMarker::kRing,
                                              ChartMarker::kPlus,   ChartMarker::kCross,
                                              ChartMarker::kSquare, ChartMarker::kTriangle};
    if (is_new)
      lines.push_back({.name = others,
                       .marker = markers[lines.size() % markers.size()],
                       .marker_size = lines.size() % markers.size() == 0 ? 11.0 : 19.0});
    const double size = *found->settings[static_cast<std::size_t>(run.run.settings[axis])].size;
    if (run.is_failed()) {
      chart.failures.push_back({found->is_inverse ? 1.0 / size : size, run.run.label});
      chart.notes.push_back(run.run.label + ": " + run.cause);
      continue;
    }
    lines[place->second].x.push_back(found->is_inverse ? 1.0 / size : size);
    lines[place->second].y.push_back(std::max(run.error_percent, 1e-5));
  }
  chart.failure_title = "failed";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].colour = chart_colours()[i % chart_colours().size()];
    const double slope = fit_slope(lines[i].x, lines[i].y);
    if (std::isfinite(slope)) {
      ChartSeries fit = make_fit(lines[i].x, lines[i].y, slope);
      fit.colour = lines[i].colour;
      lines[i].name += (lines[i].name.empty() ? "slope " : ", slope ") + format_slope(slope);
      chart.series.push_back(fit);
    }
    chart.series.push_back(lines[i]);
  }
  if (!lines.empty()) chart.notes.push_back("dotted: fitted slopes");
  return {one.name + "-" + convergence.name, chart};
}

StudyChart make_plot_chart(const StudyPlot& plot) {
  const HistoryTable table(plot.file);
  LineChart chart;
  chart.title = plot.title;
  const auto scale = [](bool is_log) { return is_log ? ChartScale::kLog : ChartScale::kLinear; };
  chart.x = {.title = plot.x_title, .scale = scale(plot.is_x_log)};
  chart.y = {.title = plot.y_title.empty() ? plot.y.front() : plot.y_title, .scale = scale(plot.is_y_log)};
  for (const std::string& name : plot.y)
    chart.series.push_back(
        {.name = name, .x = table.column(plot.x), .y = table.column(name), .marker = ChartMarker::kCircle});
  if (plot.slope && !chart.series.empty() && !chart.series[0].x.empty()) {
    ChartSeries line{.name = "slope " + format_slope(*plot.slope),
                     .colour = Rgb{110, 110, 110},
                     .line = ChartLine::kDotted};
    const ChartSeries& first = chart.series[0];
    for (const double x : {first.x.front(), first.x.back()}) {
      line.x.push_back(x);
      line.y.push_back(first.y.front() * std::pow(x / first.x.front(), *plot.slope));
    }
    chart.series.push_back(line);
  }
  return {plot.name, chart};
}

std::vector<StudyChart> make_case_charts(const CaseResult& result) {
  const StudyCase& one = *result.one;
  std::vector<StudyChart> charts;
  if (!one.quantities.empty() && !result.runs.empty()) {
    if (one.is_timed) charts.push_back(make_error_chart(result, CostKind::kWall));
    charts.push_back(make_error_chart(result, CostKind::kFactorisations));
  }
  for (const StudyConvergence& convergence : one.convergences)
    charts.push_back(make_convergence_chart(result, convergence));
  for (const StudyHistory& history : one.histories)
    for (StudyChart& chart : make_history_charts(result, history)) charts.push_back(std::move(chart));
  for (const StudyProfile& profile : one.profiles) charts.push_back(make_profile_chart(result, profile));
  return charts;
}

std::string make_chart_csv(const LineChart& chart) {
  const auto quote = [](const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
  };
  std::string csv = "series,label,x,y\n";
  for (const ChartSeries& series : chart.series)
    for (std::size_t i = 0; i < series.x.size(); ++i)
      csv += quote(series.name) + "," + quote(series.labels.empty() ? "" : series.labels[i]) + "," +
             format_exact(series.x[i]) + "," + format_exact(series.y[i]) + "\n";
  for (const ChartFailure& failure : chart.failures)
    csv += "\"failed\"," + quote(failure.label) + "," + (failure.x ? format_exact(*failure.x) : "") + ",\n";
  return csv;
}

}  // namespace hydroscope
