// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/follow/chart_column.h"

#include <algorithm>
#include <cmath>

#include "app/inspect/figure_text.h"
#include "render/image/canvas.h"
#include "render/image/colour_map.h"

namespace hydroscope {

void lay_picture(Image& frame, const Image& piece, int left, int top) {
  const int width = std::min(piece.width, frame.width - left);
  const int height = std::min(piece.height, frame.height - top);
  for (int y = 0; y < height; ++y)
    std::copy_n(piece.pixel(0, y), 4 * static_cast<std::size_t>(width), frame.pixel(left, top + y));
}

ChartColumn::ChartColumn(const Ledger& ledger, const std::vector<NodeStory>& stories,
                         const LineChartOptions& options)
    : theme_(options.theme),
      curves_(make_image(
          options.size[0], options.size[1],
          options.theme == "dark" ? hydroscope::theme("dark").background_top : Rgb{255, 255, 255})),
      head_(options.size[1] / 14) {
  std::vector<LineChart> charts = make_patch_charts(ledger, stories, theme_);
  LineChartOptions each = options;
  // Charts as flat as these have the least letters and lines there are; from here on these grow with the
  // frame.
  const double growth = std::min(options.size[1] / 720.0, 1.5);
  each.text_scale *= growth;
  for (LineChart& chart : charts)
    for (ChartSeries& series : chart.series) {
      series.line_width *= growth;
      series.marker_size *= std::max(growth, 0.75);
    }
  each.size[1] = (options.size[1] - head_) / static_cast<int>(charts.size());
  // Numbers of more digits need more room at the left: all charts begin where that one does.
  std::vector<int> lefts;
  {
    LineChartPainter painter(each);
    for (const LineChart& chart : charts) {
      painter.draw(chart);
      lefts.push_back(painter.place().plot.left);
    }
  }
  const int left = *std::max_element(lefts.begin(), lefts.end());
  for (std::size_t k = 0; k < charts.size(); ++k) {
    LineChartOptions narrowed = each;
    const int shift = left - lefts[k], top = head_ + static_cast<int>(k) * each.size[1];
    narrowed.size[0] -= shift;
    LineChartPainter painter(narrowed);
    lay_picture(curves_, painter.draw(charts[k]), shift, top);
    places_.push_back(painter.place());
    places_.back().plot.left += shift;
    places_.back().plot.top += top;
  }
  draw_head(stories);
}

void ChartColumn::draw_head(const std::vector<NodeStory>& stories) {
  Canvas canvas(curves_);
  const Canvas::TextStyle style{.size = std::max(9, 3 * head_ / 10), .colour = theme(theme_).text};
  const int left = places_.front().plot.left, square = head_ / 4, top = head_ / 10;
  int x = left;
  // Many nodes have no room for the word.
  const int room = (curves_.width - left) / static_cast<int>(std::max<std::size_t>(stories.size(), 1));
  const bool is_short = 3 * square + Canvas::text_size("node 123456", style)[0] > room;
  for (std::size_t k = 0; k < stories.size(); ++k) {
    const std::string name = (is_short ? "" : "node ") + std::to_string(stories[k].node);
    canvas.fill(x, top + square / 4, square, square, find_node_colour(k, theme_));
    canvas.text(x + 3 * square / 2, top, name, style);
    x += (is_short ? 2 : 3) * square + Canvas::text_size(name, style)[0];
  }
}

double ChartColumn::find_column(const ChartPlace& place, double time) {
  return place.plot.left + (time - place.x[0]) / (place.x[1] - place.x[0]) * (place.plot.width - 1);
}

Image ChartColumn::draw(const ChartMoments& moments) const {
  Image picture = curves_;
  Canvas canvas(picture);
  const int width = std::max(1, picture.height / 360), dash = std::max(3, picture.height / 100);
  const auto line = [&](const ChartPlace& place, double time, Rgb colour, int period) {
    const int x = static_cast<int>(std::lround(find_column(place, time))) - width / 2;
    for (int y = 0; y < place.plot.height; y += period)
      canvas.fill(x, place.plot.top + y, width, std::min((period + 1) / 2, place.plot.height - y), colour);
  };
  for (const ChartPlace& place : places_) {
    line(place, moments.let_go, kReleaseLine, 2 * dash);
    line(place, moments.now, theme_ == "dark" ? Rgb{230, 234, 240} : kTimeLine, 1);
  }
  const Canvas::TextStyle style{
      .size = std::max(9, head_ / 4), .colour = kReleaseLine, .align = Canvas::Align::kRight};
  canvas.text(picture.width - head_ / 4, head_ / 2, "let go from " + format_figure(moments.let_go) + " s",
              style);
  return picture;
}

}  // namespace hydroscope
