// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "render/chart/axis_scale.h"
#include "render/chart/line_chart.h"
#include "render/image/canvas.h"
#include "render/image/colour_map.h"

namespace hydroscope {

/// A line of the legend or of the key beside a plot.
struct ChartEntry {
  std::string text{};
  Rgb colour{};
  double line_width = 0.0;  ///< 0: no line
  ChartLine line = ChartLine::kNone;
  ChartMarker marker = ChartMarker::kNone;
  double marker_size = 0.0;
  bool has_sample = true;     ///< false: words alone, and smaller
  bool is_continued = false;  ///< a further line of the words above
};

/// All that is not data: where things stand, and how large letters are.
struct ChartLayout {
  PixelBox plot, strip;  ///< the strip of what failed is empty when nothing did
  int side_left = 0;     ///< [px] of the column beside the plot
  int text = 24, small_text = 20;
  std::vector<ChartEntry> entries{};
};

/// One of a picture of 1500 x 1000 pixels; lengths grow with the picture.
double calc_chart_unit(const std::array<int, 2>& size);

/// Sizes of the letters, room for the tick labels and for the column at the side.
ChartLayout make_chart_layout(const LineChart& chart, const std::array<int, 2>& size, double text_scale,
                              const std::vector<ChartEntry>& entries, const std::vector<AxisTick>& y_ticks);

/// Titles, ticks and their labels.
void draw_chart_frame(Canvas& canvas, Image& image, const LineChart& chart, const ChartLayout& layout,
                      const AxisScale& x, const AxisScale& y, const Theme& theme, Rgb ground);
/// Those that do not fit above `bottom` are left out, with dots in their place.
void draw_chart_entries(Canvas& canvas, const ChartLayout& layout, int left, int top, int bottom,
                        const Theme& theme);
/// Width and height that the entries take [px].
std::array<int, 2> calc_entries_size(const ChartLayout& layout);

/// A marker drawn by the canvas, for legends and the strip.
void draw_sample_marker(Canvas& canvas, double x, double y, ChartMarker marker, double size, Rgb colour);
/// A line in its style.
void draw_styled_line(Canvas& canvas, double x0, double y0, double x1, double y1, double width,
                      ChartLine style, Rgb colour);

/// The text in lines no wider than `width` [px].
std::vector<std::string> wrap_text(const std::string& text, int width, const Canvas::TextStyle& style);

}  // namespace hydroscope
