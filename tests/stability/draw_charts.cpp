// SPDX-License-Identifier: GPL-3.0-or-later
// Charts of docs/stability.md. Started by pictures.sh from the root of the repository: draw_charts FOLDER
#include <cstdio>
#include <functional>

#include "render/image/png_file.h"
#include "tests/stability/gallery_charts.h"

namespace hydroscope::stability {

LineChart make_chart(const std::string& title, const std::string& x, const std::string& y) {
  LineChart chart;
  chart.title = title;
  chart.x.title = x;
  chart.y.title = y;
  chart.legend = LineChart::Legend::kInside;
  return chart;
}

ChartSeries make_series(const std::string& name, const std::vector<double>& x, const std::vector<double>& y) {
  ChartSeries series;
  series.name = name;
  series.x = x;
  series.y = y;
  return series;
}

ChartSeries make_series(const std::string& name, const History& history, const std::string& x,
                        const std::string& y, double from) {
  ChartSeries series = make_series(name, history.column(x), history.column(y));
  std::size_t first = 0;
  while (first < history.rows.size() && history.rows[first].time <= from) ++first;
  series.x.erase(series.x.begin(), series.x.begin() + static_cast<std::ptrdiff_t>(first));
  series.y.erase(series.y.begin(), series.y.begin() + static_cast<std::ptrdiff_t>(first));
  return series;
}

namespace {

void draw_all(const std::string& folder) {
  const struct {
    const char* file;
    std::function<LineChart()> make;
  } charts[] = {{"coarse-drum", chart_coarse_drum},
                {"force-loss", chart_force_loss},
                {"one-step-behind", chart_one_step_behind},
                {"reversal", chart_reversal},
                {"sharp-corner", chart_sharp_corner},
                {"pressure-maximum", chart_pressure_maximum},
                {"penalty", chart_penalty},
                {"facet-noise", chart_facet_noise},
                {"thick-shell", chart_thick_shell},
                {"wrinkling", chart_wrinkling}};
  LineChartOptions options;
  options.size = {880, 520};
  LineChartPainter painter(options);
  for (const auto& chart : charts) {
    LineChart drawn = chart.make();
    for (ChartSeries& series : drawn.series) series.line_width *= 2.0;
    write_png(folder + "/" + chart.file + ".png", painter.draw(drawn), {}, PngSize::kSmall);
  }
}

}  // namespace
}  // namespace hydroscope::stability

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: draw_charts FOLDER\n");
    return 1;
  }
  try {
    hydroscope::stability::draw_all(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "draw_charts: %s\n", error.what());
    return 1;
  }
  return 0;
}
