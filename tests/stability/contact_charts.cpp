// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "solver/contact/friction.h"
#include "tests/stability/gallery_charts.h"

namespace hydroscope::stability {

LineChart chart_coarse_drum() {
  LineChart chart =
      make_chart("Drum of 15 degree facets, no friction", "time [s]", "tension out / tension in");
  chart.series.push_back(
      make_series("facet normals",
                  run_gallery("coarse-drum.toml", {"tool.drum.surface=facets", "tool.drum.normals=facet"}),
                  "time", "force_ratio", 0.2));
  chart.series.push_back(
      make_series("averaged, bent facets", run_gallery("coarse-drum.toml"), "time", "force_ratio", 0.2));
  chart.y.low = 0.88;
  chart.y.high = 1.16;
  return chart;
}

LineChart chart_force_loss() {
  LineChart chart =
      make_chart("A force carried along a quarter of a circle", "angle [deg]", "size of the force");
  for (const double step : {5.0, 2.0, 1.0, 0.5}) {
    std::vector<double> angle{0.0}, size{1.0};
    Vec3 force = Vec3::UnitX();
    for (int i = 1; i * step <= 90.0; ++i) {
      const double a = i * step * std::numbers::pi / 180.0;
      const Vec3 n(-std::sin(a), std::cos(a), 0.0);
      force -= n.dot(force) * n;
      angle.push_back(i * step);
      size.push_back(force.norm());
    }
    char name[40];
    std::snprintf(name, sizeof name, "cut off, %g deg a step", step);
    chart.series.push_back(make_series(name, angle, size));
  }
  std::vector<double> angle, size;
  Vec3 force = Vec3::UnitX();
  for (int i = 0; i <= 18; ++i) {
    const double a = 5.0 * i * std::numbers::pi / 180.0;
    force = transport_tangential(force, Vec3(-std::sin(a), std::cos(a), 0.0));
    angle.push_back(5.0 * i);
    size.push_back(force.norm());
  }
  chart.series.push_back(make_series("turned, 5 deg a step", angle, size));
  chart.y.low = 0.92;
  chart.y.high = 1.01;
  return chart;
}

LineChart chart_reversal() {
  LineChart chart =
      make_chart("Strip drawn on, back and on again, friction 0.2", "time [s]", "tension out / tension in");
  chart.series.push_back(make_series("one step behind",
                                     run_gallery("reversal.toml", {"contact.friction_law=one-step-behind"}),
                                     "time", "force_ratio", 0.3));
  chart.series.push_back(
      make_series("return mapping", run_gallery("reversal.toml"), "time", "force_ratio", 0.3));
  return chart;
}

LineChart chart_sharp_corner() {
  LineChart chart =
      make_chart("Strip drawn over a fillet of 2.4 mm, no friction", "time [s]", "tension out / tension in");
  const struct {
    const char* name;
    int lead_in, arc, lead_out;
  } meshes[] = {{"elements of 3 mm", 8, 1, 3}, {"1 mm", 24, 3, 9}, {"0.5 mm", 48, 6, 18}};
  for (const auto& mesh : meshes) {
    const History h =
        run_gallery("sharp-corner.toml", {"strip.elements_lead_in=" + std::to_string(mesh.lead_in),
                                          "strip.elements_arc=" + std::to_string(mesh.arc),
                                          "strip.elements_lead_out=" + std::to_string(mesh.lead_out)});
    chart.series.push_back(make_series(mesh.name, h, "time", "force_ratio", 0.3));
  }
  return chart;
}

LineChart chart_penalty() {
  LineChart chart = make_chart("Wall on a die at 30 MPa, contact and supports by a penalty", "penalty [N/mm]",
                               "penetration [mm]");
  ChartSeries depth = make_series("penetration", {}, {});
  depth.marker = ChartMarker::kCircle;
  chart.failure_title = "no equilibrium found";
  for (const double penalty : {1e2, 1e4, 1e6, 1e7, 1e8, 1e9, 1e10, 1e12}) {
    char value[40];
    std::snprintf(value, sizeof value, "contact.penalty_N_per_mm=%g", penalty);
    const History h =
        run_gallery("backed-wall.toml", {"load.pressure_MPa=[[0, 0], [1, 30]]", "contact.wall_stiffness=0",
                                         "contact.constraint=penalty", value});
    if (h.summary.outcome != Outcome::kCompleted) {
      chart.failures.push_back({penalty, ""});
      continue;
    }
    const auto& gap = h.states.back()->gap;
    depth.x.push_back(penalty);
    depth.y.push_back(-*std::min_element(gap.begin(), gap.end()));
  }
  chart.series.push_back(depth);
  chart.x.scale = chart.y.scale = ChartScale::kLog;
  chart.x.low = 1e1;
  chart.legend = LineChart::Legend::kNone;
  return chart;
}

LineChart chart_facet_noise() {
  LineChart chart =
      make_chart("Nodes that let go and touched again, on flat facets", "increment", "count so far");
  const struct {
    const char* name;
    std::vector<std::string> keys;
  } ways[] = {{"sign of the force, explicit", {"increment.correction=none", "contact.release=fluid"}},
              {"full rule, explicit", {"increment.correction=none"}},
              {"full rule, Newton (none)", {}}};
  for (const auto& way : ways) {
    std::vector<std::string> keys = way.keys;
    keys.emplace_back("increment.smallest=3e-4");
    const History h = run_gallery("facet-noise.toml", keys);
    ChartSeries series = make_series(way.name, {}, {});
    double count = 0.0;
    for (const IncrementReport& row : h.rows) {
      for (const ContactEvent& event : row.events) count += event.kind == EventKind::kRetouch ? 1.0 : 0.0;
      series.x.push_back(row.increment);
      series.y.push_back(count);
    }
    chart.series.push_back(series);
  }
  chart.y.scale = ChartScale::kLog;
  return chart;
}

}  // namespace hydroscope::stability
