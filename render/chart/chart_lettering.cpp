// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/chart/chart_lettering.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "render/chart/marker_shape.h"

namespace hydroscope {
namespace {

int round(double value) { return static_cast<int>(std::lround(value)); }

/// Words that run upwards, on a plain ground.
void draw_upright(Image& image, int centre_x, int centre_y, const std::string& words,
                  const Canvas::TextStyle& style, Rgb ground) {
  const auto [width, height] = Canvas::text_size(words, style);
  if (width == 0) return;
  Image flat = make_image(width, height, ground);
  Canvas(flat).text(0, 0, words, style);
  const int left = centre_x - height / 2, bottom = centre_y + width / 2;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      const int x = left + j, y = bottom - i;
      if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
      std::copy_n(flat.pixel(i, j), 4, image.pixel(x, y));
    }
}

Canvas::TextStyle entry_style(const ChartLayout& layout, const ChartEntry& entry, Rgb colour) {
  return {.size = entry.has_sample ? layout.text * 7 / 8 : layout.small_text, .colour = colour};
}

int sample_width(const ChartLayout& layout) { return layout.text * 2; }

int widest_label(const std::vector<AxisTick>& ticks, const Canvas::TextStyle& style) {
  int widest = 0;
  for (const AxisTick& tick : ticks) widest = std::max(widest, Canvas::text_size(tick.label, style)[0]);
  return widest;
}

void draw_x_ticks(Canvas& canvas, const ChartLayout& layout, const AxisScale& x, const Theme& theme) {
  const PixelBox& box = layout.plot;
  const Canvas::TextStyle style{.size = layout.text, .colour = theme.text, .align = Canvas::Align::kCentre};
  const int bottom = box.top + box.height, length = layout.text / 3;
  int free_from = box.left - layout.text * 3;
  for (const AxisTick& tick : x.find_ticks(box.width / (layout.text * 5))) {
    const int at = box.left + round(x.to_unit(tick.value) * box.width);
    const int width = Canvas::text_size(tick.label, style)[0];
    const bool has_room = at - width / 2 > free_from;
    canvas.fill(at - 1, bottom, 2, tick.label.empty() ? length / 2 : length, theme.text);
    if (tick.label.empty() || !has_room) continue;
    canvas.text(at, bottom + layout.text / 2, tick.label, style);
    free_from = at + width / 2 + layout.text / 3;
  }
}

void draw_y_ticks(Canvas& canvas, const ChartLayout& layout, const AxisScale& y, const Theme& theme) {
  const PixelBox& box = layout.plot;
  const Canvas::TextStyle style{.size = layout.text, .colour = theme.text, .align = Canvas::Align::kRight};
  const int length = layout.text / 3, letters = Canvas::text_size("0", style)[1];
  int free_below = box.top + box.height + layout.text * 2;
  for (const AxisTick& tick : y.find_ticks(box.height / (layout.text * 3))) {
    const int at = box.top + round((1.0 - y.to_unit(tick.value)) * box.height);
    const int mark = tick.label.empty() ? length / 2 : length;
    canvas.fill(box.left - mark, at - 1, mark, 2, theme.text);
    if (tick.label.empty() || at + letters / 2 > free_below) continue;
    const int height = Canvas::text_size(tick.label, style)[1];
    canvas.text(box.left - layout.text / 2, at + letters / 2 - height, tick.label, style);
    free_below = at - letters / 2 - layout.text / 5;
  }
}

}  // namespace

double calc_chart_unit(const std::array<int, 2>& size) {
  return std::clamp(std::min(size[1] / 1000.0, size[0] / 1500.0), 0.25, 6.0);
}

std::vector<std::string> wrap_text(const std::string& text, int width, const Canvas::TextStyle& style) {
  std::vector<std::string> lines(1);
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (lines.back().empty() || Canvas::text_size(longer, style)[0] <= width)
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

void draw_sample_marker(Canvas& canvas, double x, double y, ChartMarker marker, double size, Rgb colour) {
  const MarkerShape shape = make_marker_shape(marker);
  const double half = 0.5 * size;
  if (!shape.is_filled) {
    for (std::size_t i = 0; i + 1 < shape.corners.size(); i += 2)
      canvas.line(x + half * shape.corners[i][0], y - half * shape.corners[i][1],
                  x + half * shape.corners[i + 1][0], y - half * shape.corners[i + 1][1],
                  std::max(1.6, shape.stroke * size), colour);
    return;
  }
  // A fan of thick strokes from the middle fills any convex shape of this size.
  for (std::size_t i = 0; i < shape.corners.size(); ++i) {
    const auto& a = shape.corners[i];
    const auto& b = shape.corners[(i + 1) % shape.corners.size()];
    const int steps = round(size);
    for (int k = 0; k <= steps; ++k) {
      const double s = static_cast<double>(k) / std::max(steps, 1);
      canvas.line(x, y, x + 0.93 * half * (a[0] + s * (b[0] - a[0])),
                  y - 0.93 * half * (a[1] + s * (b[1] - a[1])), 1.2, colour);
    }
  }
}

void draw_styled_line(Canvas& canvas, double x0, double y0, double x1, double y1, double width,
                      ChartLine style, Rgb colour) {
  if (style == ChartLine::kNone) return;
  if (style == ChartLine::kSolid) return canvas.line(x0, y0, x1, y1, width, colour);
  const double length = std::hypot(x1 - x0, y1 - y0);
  const double dash = style == ChartLine::kDashed ? 5.0 * width : 1.0,
               gap = style == ChartLine::kDashed ? 4.0 * width : 3.0 * width;
  for (double s = 0.0; s < length; s += dash + gap) {
    const double a = s / length, b = std::min(1.0, (s + dash) / length);
    canvas.line(x0 + a * (x1 - x0), y0 + a * (y1 - y0), x0 + b * (x1 - x0), y0 + b * (y1 - y0), width,
                colour);
  }
}

std::array<int, 2> calc_entries_size(const ChartLayout& layout) {
  int width = 0, height = 0;
  for (const ChartEntry& entry : layout.entries) {
    const auto style = entry_style(layout, entry, {});
    const int before = entry.has_sample ? sample_width(layout) : 0;
    width = std::max(width, before + Canvas::text_size(entry.text, style)[0]);
    height += style.size * 3 / 2;
  }
  return {width, height};
}

void draw_chart_entries(Canvas& canvas, const ChartLayout& layout, int left, int top, int bottom,
                        const Theme& theme) {
  for (const ChartEntry& entry : layout.entries) {
    const auto style = entry_style(layout, entry, entry.has_sample ? theme.text : theme.faint_text);
    const int before = entry.has_sample ? sample_width(layout) : 0;
    if (top + 3 * style.size > bottom && &entry != &layout.entries.back())
      return canvas.text(left + before, top, "…", style);
    const double middle = top + 0.48 * style.size, room = before - 0.5 * style.size;
    if (entry.has_sample && !entry.is_continued) {
      draw_styled_line(canvas, left, middle, left + room, middle, entry.line_width, entry.line, entry.colour);
      draw_sample_marker(canvas, left + 0.5 * room, middle, entry.marker, entry.marker_size, entry.colour);
    }
    canvas.text(left + before, top, entry.text, style);
    top += style.size * 3 / 2;
  }
}

ChartLayout make_chart_layout(const LineChart& chart, const std::array<int, 2>& size, double text_scale,
                              const std::vector<ChartEntry>& entries, const std::vector<AxisTick>& y_ticks) {
  ChartLayout layout;
  const double unit = calc_chart_unit(size) * text_scale;
  layout.text = std::max(9, round(25.0 * unit));
  layout.small_text = std::max(8, round(20.0 * unit));
  layout.entries = entries;
  const int em = layout.text;
  const Canvas::TextStyle style{.size = em};
  int side = em;
  if (chart.legend == LineChart::Legend::kRight && !entries.empty())
    side = std::min(calc_entries_size(layout)[0] + 2 * em, size[0] / 2);
  const int left = em / 2 + (chart.y.title.empty() ? 0 : em * 3 / 2) + widest_label(y_ticks, style) + em;
  const int top =
      em / 2 + (chart.title.empty() ? 0 : em * 2) + (chart.subtitle.empty() ? 0 : em * 3 / 2) + em / 2;
  const int strip = chart.failures.empty() ? 0 : em * 5;
  const int bottom = em * 3 / 2 + (chart.x.title.empty() ? 0 : em * 2) + em / 2;
  layout.plot = {left, top + strip, std::max(size[0] - left - side - em / 2, 10),
                 std::max(size[1] - top - strip - bottom, 10)};
  if (strip > 0) layout.strip = {left, top, layout.plot.width, strip - em / 2};
  layout.side_left = left + layout.plot.width + em;
  return layout;
}

void draw_chart_frame(Canvas& canvas, Image& image, const LineChart& chart, const ChartLayout& layout,
                      const AxisScale& x, const AxisScale& y, const Theme& theme, Rgb ground) {
  const int em = layout.text;
  int top = em / 2;
  const PixelBox& box = layout.plot;
  if (!chart.title.empty()) {
    canvas.text(box.left, top, chart.title, {.size = em * 6 / 5, .colour = theme.text, .is_bold = true});
    top += em * 2;
  }
  canvas.text(box.left, top, chart.subtitle, {.size = layout.small_text, .colour = theme.faint_text});
  draw_x_ticks(canvas, layout, x, theme);
  draw_y_ticks(canvas, layout, y, theme);
  const Canvas::TextStyle title{.size = em, .colour = theme.text, .align = Canvas::Align::kCentre};
  canvas.text(box.left + box.width / 2, box.top + box.height + em * 2, chart.x.title, title);
  draw_upright(image, em, box.top + box.height / 2, chart.y.title, {.size = em, .colour = theme.text},
               ground);
}

}  // namespace hydroscope
