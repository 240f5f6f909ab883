// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tests/stability/gallery_charts.h"

namespace hydroscope::stability {

namespace {

/// Mid-surface radius over z at the end.
ChartSeries make_profile(const std::string& name, const History& history) {
  std::vector<std::pair<double, double>> points;
  for (const Vec3& x : history.states.back()->points) points.emplace_back(x[2], x.head<2>().norm());
  std::sort(points.begin(), points.end());
  ChartSeries series = make_series(name, {}, {});
  for (std::size_t i = 0; i < points.size(); i += 2) {  // two nodes a ring
    series.x.push_back(points[i].first);
    series.y.push_back(points[i].second);
  }
  return series;
}

}  // namespace

LineChart chart_one_step_behind() {
  LineChart chart = make_chart("One step behind: R_safe too small and too large", "R_safe",
                               "residual; increments / 10 000");
  ChartSeries residual = make_series("median residual of the increments", {}, {}),
              count = make_series("number of increments / 10 000", {}, {});
  for (const double r_safe : {0.3, 0.4, 0.5, 1.0, 2.0, 5.0, 20.0, 200.0}) {
    const History h = run_gallery("one-step-behind.toml",
                                  {"increment.correction=one-step-behind", "increment.smallest=1e-3",
                                   "increment.r_safe=" + std::to_string(r_safe)});
    for (ChartSeries* s : {&residual, &count}) s->x.push_back(r_safe);
    residual.y.push_back(calc_median_residual(h));
    count.y.push_back(1e-4 * h.summary.increments);
  }
  residual.marker = ChartMarker::kCircle;
  count.marker = ChartMarker::kSquare;
  chart.series = {residual, count};
  chart.x.scale = chart.y.scale = ChartScale::kLog;
  ChartMark tolerance;
  tolerance.value = 1e-3;
  tolerance.label = "Newton: never above";
  chart.horizontal_marks.push_back(tolerance);
  chart.y.low = 5e-4;
  return chart;
}

LineChart chart_pressure_maximum() {
  LineChart chart = make_chart("Ring in plane strain", "mid radius [mm]", "pressure [MPa]");
  ChartSeries pressure = make_series(
      "pressure given", run_gallery("pressure-maximum.toml", {"load.control=pressure"}), "r_mm", "pressure");
  pressure.line_width = 5.0;
  chart.series = {pressure,
                  make_series("volume given", run_gallery("pressure-maximum.toml"), "r_mm", "pressure")};
  ChartSeries end = make_series("ends at the maximum", {pressure.x.back()}, {pressure.y.back()});
  end.marker = ChartMarker::kCircle;
  end.line = ChartLine::kNone;
  chart.series.push_back(end);
  chart.y.low = 12.0;
  chart.y.high = 18.0;
  return chart;
}

LineChart chart_thick_shell() {
  LineChart chart = make_chart("Tube of R/t = 5, perfectly plastic", "mid radius [mm]", "pressure [MPa]");
  const struct {
    const char *name, *surface, *stress;
  } ways[] = {{"inner face only", "inner", "off"},
              {"inner face and sigma33", "inner", "mean"},
              {"neither", "mid", "off"},
              {"sigma33 only", "mid", "mean"}};
  for (const auto& way : ways) {
    const History h =
        run_gallery("thick-shell.toml", {std::string("load.pressure_surface=") + way.surface,
                                         std::string("shell.through_wall_stress=") + way.stress});
    chart.series.push_back(make_series(way.name, h, "r_mm", "pressure"));
  }
  ChartMark limit;
  limit.value = 2.0 / std::numbers::sqrt3 * 240.0 * std::log(33.0 / 27.0);
  limit.label = "exact, of the tube as it began";
  chart.horizontal_marks.push_back(limit);
  chart.y.low = 40.0;
  chart.y.high = 64.0;
  chart.x.low = 30.0;
  return chart;
}

LineChart chart_wrinkling() {
  LineChart chart =
      make_chart("Tube pushed in by 6 mm, its clamped end on the right", "z [mm]", "mid radius [mm]");
  chart.series.push_back(make_profile(
      "2 MPa", run_gallery("wrinkling.toml", {"load.pressure_MPa=[[0.0, 0.0], [0.1, 2.0], [1.0, 2.0]]"})));
  chart.series.push_back(make_profile("8 to 12 MPa", run_gallery("wrinkling.toml")));
  ChartMark die;
  die.value = 33.5;
  die.label = "die, less half of the wall";
  chart.horizontal_marks.push_back(die);
  chart.y.low = 27.0;
  chart.y.high = 36.0;
  return chart;
}

}  // namespace hydroscope::stability
