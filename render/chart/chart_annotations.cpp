// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/chart/chart_annotations.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/chart/label_layout.h"

namespace hydroscope {
namespace {

constexpr Rgb kFailed{200, 40, 30};

}  // namespace

Rgb mix_colours(Rgb a, Rgb b, double share) {
  for (std::size_t c = 0; c < 3; ++c)
    a[c] = static_cast<std::uint8_t>(std::lround(a[c] + share * (b[c] - a[c])));
  return a;
}

void draw_mark_labels(Canvas& canvas, const LineChart& chart, const ChartLayout& layout, const AxisScale& x,
                      const AxisScale& y, const Theme& colours) {
  const PixelBox& box = layout.plot;
  for (const ChartMark& mark : chart.vertical_marks) {
    if (mark.label.empty() || !x.takes(mark.value)) continue;
    const double unit_x = x.to_unit(mark.value);
    const int at = box.left + static_cast<int>(unit_x * box.width), gap = layout.text / 4;
    const bool is_left = unit_x > 0.75;
    canvas.text(is_left ? at - gap : at + gap, box.top + gap, mark.label,
                {.size = layout.small_text,
                 .colour = mark.colour.value_or(colours.faint_text),
                 .align = is_left ? Canvas::Align::kRight : Canvas::Align::kLeft});
  }
  for (const ChartMark& mark : chart.horizontal_marks) {
    if (mark.label.empty() || !y.takes(mark.value)) continue;
    const int at = box.top + static_cast<int>((1.0 - y.to_unit(mark.value)) * box.height);
    canvas.text(box.left + box.width - layout.text / 4, at - layout.small_text * 5 / 4, mark.label,
                {.size = layout.small_text,
                 .colour = mark.colour.value_or(colours.faint_text),
                 .align = Canvas::Align::kRight});
  }
}

void draw_failure_strip(Canvas& canvas, const LineChart& chart, const ChartLayout& layout, const AxisScale& x,
                        const Theme& colours, Rgb ground) {
  const PixelBox& strip = layout.strip;
  if (strip.width == 0) return;
  canvas.fill(strip.left, strip.top, strip.width, strip.height, mix_colours(ground, kFailed, 0.07));
  canvas.frame(strip.left, strip.top, strip.width, strip.height, mix_colours(ground, kFailed, 0.4));
  canvas.text(strip.left + layout.text / 3, strip.top + layout.text / 5, chart.failure_title,
              {.size = layout.small_text, .colour = kFailed, .is_bold = true});
  std::vector<LabelWish> wishes;
  std::vector<PixelBox> obstacles;
  const double size = std::max(9.0, 0.56 * layout.text), y = strip.top + 0.62 * strip.height;
  for (const ChartFailure& failure : chart.failures) {
    const double at =
        failure.x && x.takes(*failure.x) ? x.to_unit(*failure.x) * strip.width : 0.5 * layout.text;
    const auto [width, height] = Canvas::text_size(failure.label, {.size = layout.small_text});
    const double px = strip.left + std::clamp(at, size, strip.width - size);
    wishes.push_back({px, y, width + 4, height + 2, 0.5 * size});
    const int half = static_cast<int>(0.5 * size);
    obstacles.push_back({static_cast<int>(px) - half, static_cast<int>(y) - half, 2 * half, 2 * half});
    draw_sample_marker(canvas, px, y, ChartMarker::kCross, size, kFailed);
  }
  const auto title = Canvas::text_size(chart.failure_title, {.size = layout.small_text, .is_bold = true});
  obstacles.push_back({strip.left, strip.top, title[0] + layout.text, title[1] + layout.text / 3});
  const auto placed = place_labels(wishes, strip, obstacles);
  for (std::size_t i = 0; i < placed.size(); ++i)
    canvas.text(placed[i].box.left + 2, placed[i].box.top + 1, chart.failures[i].label,
                {.size = layout.small_text, .colour = mix_colours(kFailed, colours.text, 0.4)});
}

void draw_inside_legend(Canvas& canvas, const ChartLayout& layout, const PlotArea& area,
                        const Theme& colours) {
  const auto [width, height] = calc_entries_size(layout);
  const int pad = layout.text / 2;
  PixelBox best;
  int fewest = std::numeric_limits<int>::max();
  for (const bool is_left : {false, true})
    for (const bool is_top : {true, false}) {
      const PixelBox box{
          is_left ? layout.plot.left + pad : layout.plot.left + layout.plot.width - width - 3 * pad,
          is_top ? layout.plot.top + pad : layout.plot.top + layout.plot.height - height - 2 * pad,
          width + 2 * pad, height + pad};
      int count = 0;
      for (const PlotArea::Line& line : area.lines)
        for (const auto& [px, py] : line.points)
          if (std::isfinite(px) &&
              box.holds(layout.plot.left + static_cast<int>(px * layout.plot.width),
                        layout.plot.top + static_cast<int>((1.0 - py) * layout.plot.height)))
            ++count;
      if (count < fewest) {
        fewest = count;
        best = box;
      }
    }
  canvas.fill(best.left, best.top, best.width, best.height, area.ground, 0.85);
  canvas.frame(best.left, best.top, best.width, best.height, area.grid);
  draw_chart_entries(canvas, layout, best.left + pad, best.top + pad,
                     best.top + best.height + layout.text * 2, colours);
}

}  // namespace hydroscope
