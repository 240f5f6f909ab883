// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the charts of docs/verification.md. Usage, in the project's folder: hydroscope_verification_charts
// FOLDER
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "render/chart/line_chart.h"
#include "render/image/png_file.h"
#include "tests/solver/curvature_slope.h"
#include "tests/verification/friction_die.h"
#include "tests/verification/obstacle_course.h"

namespace hydroscope::verification {
namespace {

LineChart make_obstacle_chart() {
  LineChart chart;
  chart.title = "Shell obstacle course";
  chart.subtitle = "distance of the displacement from its reference; MITC4, linear elastic";
  chart.x = {"elements a side (beams and hook: across)", ChartScale::kLog, {}, {}};
  chart.y = {"|displacement / reference \u2212 1| [%]", ChartScale::kLog, 0.01, 100.0};
  chart.horizontal_marks.push_back({1.0, "wanted", {}, ChartLine::kDashed});
  const struct {
    const char *name, *title;
    ChartMarker marker;
    int first, last;
  } rows[] = {{"scordelis_lo", "Scordelis-Lo roof", ChartMarker::kCircle, 4, 64},
              {"pinched_cylinder", "pinched cylinder", ChartMarker::kSquare, 4, 64},
              {"hemisphere", "hemisphere", ChartMarker::kDiamond, 4, 64},
              {"hemisphere_with_hole", "hemisphere, 18\u00b0 hole", ChartMarker::kTriangle, 4, 64},
              {"twisted_beam_in_plane", "twisted beam, in plane", ChartMarker::kDown, 2, 32},
              {"twisted_beam_out_of_plane", "twisted beam, out of plane", ChartMarker::kCross, 2, 32},
              {"thin_twisted_beam_in_plane", "thin twisted beam, in plane", ChartMarker::kPlus, 2, 32},
              {"raasch_hook", "Raasch's hook (5.02)", ChartMarker::kRing, 2, 32}};
  for (const auto& row : rows) {
    const Obstacle& obstacle = find_obstacle(row.name);
    ChartSeries series;
    series.name = row.title;
    series.marker = row.marker;
    for (int n = row.first; n <= row.last; n *= 2) {
      series.x.push_back(n);
      series.y.push_back(100.0 * std::abs(obstacle.solve(n) / obstacle.reference - 1.0));
    }
    chart.series.push_back(series);
  }
  return chart;
}

LineChart make_slope_chart() {
  LineChart chart;
  chart.title = "Tangential rest after one slide inside a facet";
  chart.subtitle = "one node on springs, t_N = 200 N, R = 10 mm; before re-projection";
  chart.x = {"slide [mm]", ChartScale::kLog, {}, {}};
  chart.y = {"|t' \u2212 n'(n'\u00b7t')| [N]", ChartScale::kLog, {}, {}};
  const auto add = [&](const std::string& name, const std::vector<SlopeRow>& rows,
                       TangentialRest SlopeRow::*treatment, double TangentialRest::*rest, ChartMarker marker,
                       ChartLine line) {
    ChartSeries series;
    for (const SlopeRow& row : rows) {
      series.x.push_back((row.*treatment).slide);
      series.y.push_back((row.*treatment).*rest);
    }
    char slope[32];
    std::snprintf(slope, sizeof slope, ": slope %.2f", fit_slope(series.x, series.y));
    series.name = name + slope;
    series.marker = marker;
    series.line = line;
    chart.series.push_back(series);
  };
  for (const SlopeCase& c : make_slope_cases()) {
    const bool is_flat = c.name == "sphere facets";
    if (!is_flat && c.name != "sphere nagata") continue;
    const auto rows = measure_slopes(*c.tool, make_spring_node(*c.tool, c.at, 0.75, 200.0), 200.0, 12);
    const auto add_balance = [&](const std::string& name, TangentialRest SlopeRow::*treatment,
                                 ChartMarker marker) {
      add(name, rows, treatment, &TangentialRest::balanced, marker, ChartLine::kSolid);
    };
    if (is_flat) {
      add_balance("no curvature", &SlopeRow::none, ChartMarker::kCircle);
      add_balance("facets, symmetric K_C", &SlopeRow::symmetric, ChartMarker::kSquare);
      add_balance("facets, full K_C", &SlopeRow::full, ChartMarker::kDiamond);
    } else {
      add_balance("Nagata, either K_C", &SlopeRow::full, ChartMarker::kTriangle);
    }
  }
  return chart;
}

LineChart make_friction_chart(const std::string& material) {
  LineChart chart;
  chart.title = "Corner of the square die with friction, " + material;
  chart.subtitle = "thin wall (r0/100); lines: one-dimensional wall, markers: 36 shells over the eighth";
  chart.x = {"corner radius \u03c1 of the mid-surface [mm]", ChartScale::kLinear, {}, {}};
  chart.y = {"corner thickness [mm]", ChartScale::kLinear, {}, {}};
  const std::vector<double> radii = {25, 22, 20, 18, 16, 15, 14.5, 14, 13.5, 12, 11, 10, 9};
  std::size_t colour = 0;
  for (const double mu : {0.05, 0.1, 0.2}) {
    const FrictionCase run = make_friction_case(material, mu, 36);
    const FrictionWall wall(run.metal, {30.0, 0.3, mu}, 9.0, 200, 400);
    ChartSeries line, markers;
    char name[32];
    std::snprintf(name, sizeof name, "\u03bc = %.2f", mu);
    line.name = name;
    line.colour = markers.colour = chart_colours()[colour++];
    markers.line = ChartLine::kNone;
    markers.marker = ChartMarker::kCircle;
    for (const CornerState& s : wall.states()) {
      if (s.rho > 26.0) continue;
      line.x.push_back(s.rho);
      line.y.push_back(s.corner_thickness);
    }
    for (const FrictionResultRow& r : compare_friction(run, radii).rows) {
      markers.x.push_back(r.rho);
      markers.y.push_back(r.thickness);
    }
    chart.series.push_back(line);
    chart.series.push_back(markers);
  }
  if (material == "M1") chart.notes.push_back("lines end where the wall necks");
  return chart;
}

}  // namespace
}  // namespace hydroscope::verification

int main(int argc, char** argv) {
  using namespace hydroscope;
  if (argc != 2) {
    std::fputs("usage: hydroscope_verification_charts FOLDER\n", stderr);
    return 2;
  }
  const std::string folder = argv[1];
  LineChartOptions options;
  options.size = {1400, 800};
  LineChartPainter painter(options);
  const auto save = [&](const std::string& name, const LineChart& chart) {
    write_png(folder + "/" + name + ".png", painter.draw(chart), {}, PngSize::kSmall);
  };
  save("obstacle-course", verification::make_obstacle_chart());
  save("curvature-slope", verification::make_slope_chart());
  save("friction-corner-m1", verification::make_friction_chart("M1"));
  save("friction-corner-m2", verification::make_friction_chart("M2"));
}
