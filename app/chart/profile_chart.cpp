// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/chart/closed_forms.h"
#include "app/chart/study_charts.h"
#include "app/results/result_folder.h"
#include "app/results/state_file.h"
#include "render/view_text.h"
#include "solver/base/error.h"
#include "solver/scene/scene_reader.h"

namespace hydroscope {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

using States = std::vector<std::shared_ptr<const Snapshot>>;

States read_states(const std::filesystem::path& path) {
  const ResultFolder folder{path};
  const auto files = find_states(folder);
  const auto model = read_model(path, files.front());
  States states;
  for (const auto& file : files) states.push_back(read_state(file, model));
  return states;
}

/// The states nearest to the pressures, or the last one.
States choose_states(const States& all, const std::vector<double>& pressures) {
  if (pressures.empty()) return {all.back()};
  States chosen;
  for (const double wanted : pressures)
    chosen.push_back(*std::min_element(all.begin(), all.end(), [wanted](const auto& a, const auto& b) {
      return std::abs(a->pressure - wanted) < std::abs(b->pressure - wanted);
    }));
  return chosen;
}

/// Thickness over the angle, on the row of nodes at the smallest z.
ChartSeries make_profile(const Snapshot& state) {
  double low = state.points.front().z(), width = 0.0;
  for (const Vec3& x : state.points) low = std::min(low, x.z());
  for (const Vec3& x : state.points) width = std::max(width, x.head<2>().norm());
  std::vector<std::pair<double, double>> row;
  for (std::size_t i = 0; i < state.points.size(); ++i) {
    const Vec3& x = state.points[i];
    if (x.z() < low + 1e-6 * width) row.emplace_back(std::atan2(x.y(), x.x()) / kDegree, state.thickness[i]);
  }
  std::sort(row.begin(), row.end());
  ChartSeries series;
  for (const auto& [angle, thickness] : row) {
    series.x.push_back(angle);
    series.y.push_back(thickness);
  }
  return series;
}

ChartSeries make_form(const StudyProfile& profile, const Scene& scene, const ChartSeries& like,
                      double driver) {
  ChartSeries series{.colour = Rgb{60, 60, 60}, .line = ChartLine::kDashed};
  for (const double angle : like.x) {
    // An eighth tells all: the angle from the nearest flat's middle.
    const double folded = std::abs(angle - 90.0 * std::round(angle / 90.0));
    series.x.push_back(angle);
    series.y.push_back(calc_profile_form(profile.formula, scene, folded * kDegree, driver));
  }
  return series;
}

void add_run(LineChart& chart, const StudyCase& one, const StudyProfile& profile, const RunResult& run) {
  const HistoryTable history(ResultFolder{run.folder}.history());
  const Scene scene = read_scene(one.scene, run.run.overrides);
  for (const auto& state : choose_states(read_states(run.folder), profile.at_pressure)) {
    ChartSeries series = make_profile(*state);
    series.name = run.run.label + ", " + format_number(state->pressure) + " MPa";
    series.marker = ChartMarker::kCircle;
    series.marker_size = 8.0;
    if (!profile.formula.empty()) {
      const auto driver = history.find_at(profile.driver, "increment", state->increment);
      // Before the wall lies against the flats there is no corner to speak of.
      if (driver && *driver > 0.0 && *driver < scene.tube.radius) {
        chart.series.push_back(make_form(profile, scene, series, *driver));
        const bool is_first = std::none_of(chart.series.begin(), chart.series.end(),
                                           [](const ChartSeries& s) { return s.name == "closed form"; });
        if (is_first) chart.series.back().name = "closed form";
      }
    }
    chart.series.push_back(series);
  }
}

}  // namespace

StudyChart make_profile_chart(const CaseResult& result, const StudyProfile& profile) {
  LineChart chart;
  chart.title = profile.title.empty() ? result.one->title : profile.title;
  chart.x = {.title = "angle from the x axis [°]"};
  chart.y = {.title = "wall thickness [mm]"};
  const auto is_named = [&](const RunResult& run) {
    return std::find(profile.runs.begin(), profile.runs.end(), run.run.id) != profile.runs.end();
  };
  std::vector<const RunResult*> runs;
  for (const RunResult& run : result.runs)
    if (run.is_known && (profile.runs.empty() || is_named(run))) runs.push_back(&run);
  if (result.finest && result.finest->is_known && is_named(*result.finest)) runs.push_back(&*result.finest);
  for (const RunResult* run : runs) {
    try {
      add_run(chart, *result.one, profile, *run);
    } catch (const InputError& error) {
      chart.notes.push_back(run->run.label + ": " + error.what());
    }
  }
  return {result.one->name + "-" + profile.name, chart};
}

}  // namespace hydroscope
