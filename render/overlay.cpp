// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/overlay.h"

#include <algorithm>
#include <cmath>

#include "render/image/canvas.h"
#include "render/view_text.h"

namespace hydroscope {
namespace {

constexpr double kGround = 0.72;  // opacity of panels behind words that mostly lie beside the part
constexpr int kLeastWidth = 240, kLeastHeight = 135;  // [px] of a picture that has room for letters

/// Sizes for a picture of 720 rows, scaled with it.
class Layout {
 public:
  Layout(Image& image, const Theme& given)
      : Layout(image, given, std::clamp(std::min(image.height / 720.0, image.width / 1000.0), 0.5, 6.0)) {}
  Layout(Image& image, const Theme& given, double scale)
      : canvas(image), theme(given), width(image.width), height(image.height), scale_(scale) {}

  int px(double at_720) const { return static_cast<int>(std::lround(at_720 * scale_)); }

  Canvas canvas;
  const Theme& theme;
  const int width, height;

 private:
  double scale_;
};

struct Words {
  const std::string& title;
  const std::string& time_label;
  /// Anything may lie below: panels behind all words, and the title only where it finds room.
  bool is_live;
};

/// Right end of the lines drawn [px], which should not go beyond `room`.
int draw_heading(Layout& layout, const Legend& legend, const Words& words, int room) {
  const int x = layout.px(24);
  Canvas::TextStyle heading{.size = layout.px(25), .colour = layout.theme.text, .is_bold = true};
  const Canvas::TextStyle faint{.size = layout.px(18), .colour = layout.theme.faint_text};
  const Canvas::TextStyle plain{.size = layout.px(18), .colour = layout.theme.text};
  const int after = x + Canvas::text_size(legend.heading, heading)[0];
  const int beside = after + layout.px(14);
  const int title_end = beside + Canvas::text_size(words.title, faint)[0];
  const bool has_title = !words.is_live || title_end <= room;
  const int end = std::max(has_title ? title_end : after, x + Canvas::text_size(words.time_label, plain)[0]);
  if (words.is_live)
    layout.canvas.fill(layout.px(12), layout.px(10), end + layout.px(10) - layout.px(12), layout.px(66),
                       layout.theme.panel, kGround);
  layout.canvas.text(x, layout.px(16), legend.heading, heading);
  if (has_title) layout.canvas.text(beside, layout.px(22), words.title, faint);
  layout.canvas.text(x, layout.px(50), words.time_label, plain);
  return end;
}

/// The panel of swatches and notes at the right: what it takes.
struct SwatchPanel {
  SwatchPanel(const Layout& layout, const Legend& legend)
      : label{.size = layout.px(16), .colour = layout.theme.text},
        note{.size = layout.px(13), .colour = layout.theme.faint_text} {
    const int rows = static_cast<int>(legend.swatches.size()), notes = static_cast<int>(legend.notes.size());
    if (rows + notes == 0) return;
    int widest = 0;
    for (const auto& swatch : legend.swatches)
      widest = std::max(widest, layout.px(16) + layout.px(10) + Canvas::text_size(swatch.label, label)[0]);
    for (const auto& words : legend.notes) widest = std::max(widest, Canvas::text_size(words, note)[0]);
    width = widest + 2 * layout.px(12);
    height = rows * layout.px(26) + notes * layout.px(18) + 2 * layout.px(12) - layout.px(4);
  }

  Canvas::TextStyle label, note;
  int width = 0, height = 0;  ///< [px]; 0: there is nothing to show
};

void draw_swatches(Layout& layout, const Legend& legend, const SwatchPanel& panel, int top) {
  if (panel.height == 0) return;
  const int square = layout.px(16), pad = layout.px(12);
  const int left = layout.width - layout.px(20) - panel.width;
  layout.canvas.fill(left, top, panel.width, panel.height, layout.theme.panel, 0.82);
  layout.canvas.frame(left, top, panel.width, panel.height, layout.theme.panel_frame);
  int y = top + pad;
  for (const auto& swatch : legend.swatches) {
    layout.canvas.fill(left + pad, y, square, square, swatch.colour);
    layout.canvas.frame(left + pad, y, square, square, layout.theme.faint_text);
    const int height = Canvas::text_size(swatch.label, panel.label)[1];
    layout.canvas.text(left + pad + square + layout.px(10), y + (square - height) / 2, swatch.label,
                       panel.label);
    y += layout.px(26);
  }
  for (const auto& words : legend.notes) {
    layout.canvas.text(left + pad, y, words, panel.note);
    y += layout.px(18);
  }
}

/// A colour bar with its ticks.
struct BarPanel {
  BarPanel(const Layout& layout, const Legend::Bar& bar)
      : label{.size = layout.px(15), .colour = layout.theme.text},
        step(calc_round_step((bar.range.high - bar.range.low) / 6.0)),
        first(step * std::ceil(bar.range.low / step - 1e-9)) {
    int widest = 0;
    for (double value = first; value <= bar.range.high + 1e-9 * step; value += step)
      widest = std::max(widest, Canvas::text_size(format_number(value), label)[0]);
    width = std::max(Canvas::text_size(bar.title, label)[0], layout.px(18) + layout.px(14) + widest) +
            2 * layout.px(12);
  }
  /// What it takes beside the bar itself.
  static int calc_frame_height(const Layout& layout) {
    return layout.px(30) + 2 * layout.px(12) + layout.px(8);
  }

  Canvas::TextStyle label;
  double step, first;
  int width = 0;  ///< [px]
};

int draw_bar(Layout& layout, const Legend::Bar& bar, int bar_height, int top) {
  const BarPanel panel(layout, bar);
  const int bar_width = layout.px(18), pad = layout.px(12);
  const int panel_height = bar_height + BarPanel::calc_frame_height(layout);
  const int left = layout.width - layout.px(20) - panel.width;
  layout.canvas.fill(left, top, panel.width, panel_height, layout.theme.panel, 0.82);
  layout.canvas.frame(left, top, panel.width, panel_height, layout.theme.panel_frame);
  layout.canvas.text(left + pad, top + layout.px(9), bar.title, panel.label);
  const int x = left + pad, y = top + pad + layout.px(32);
  for (int row = 0; row < bar_height; ++row) {
    const double s = 1.0 - (row + 0.5) / bar_height;
    layout.canvas.fill(x, y + row, bar_width, 1, map_colour(*bar.table, s, 0.0, 1.0));
  }
  layout.canvas.frame(x, y, bar_width, bar_height, layout.theme.faint_text);
  const int letters = Canvas::text_size("0", panel.label)[1];
  for (double value = panel.first; value <= bar.range.high + 1e-9 * panel.step; value += panel.step) {
    const double s = (value - bar.range.low) / (bar.range.high - bar.range.low);
    const int tick = y + static_cast<int>(std::lround((1.0 - s) * (bar_height - 1)));
    layout.canvas.fill(x + bar_width, tick, layout.px(5), 1, layout.theme.faint_text);
    layout.canvas.text(x + bar_width + layout.px(10), tick - letters / 2, format_number(value), panel.label);
  }
  return top + panel_height + layout.px(14);
}

/// Left end of the legend's panels [px].
int find_legend_left(const Layout& layout, const Legend& legend, const SwatchPanel& swatches) {
  int widest = swatches.width;
  for (const Legend::Bar& bar : legend.bars) widest = std::max(widest, BarPanel(layout, bar).width);
  return layout.width - layout.px(20) - widest;
}

/// Where the legend begins: beside title and time label, or below them where it would meet them.
int find_legend_top(const Layout& layout, int legend_left, int heading_end) {
  return layout.px(heading_end + layout.px(8) > legend_left ? 80 : 20);
}

/// Bars shrink before the swatches below them leave the picture.
int find_bar_height(const Layout& layout, const Legend& legend, const SwatchPanel& swatches, int top) {
  const int bars = static_cast<int>(legend.bars.size());
  if (bars == 0) return 0;
  const int below = swatches.height > 0 ? swatches.height + layout.px(14) : 0;
  const int room = (layout.height - top - below) / bars - BarPanel::calc_frame_height(layout) - layout.px(14);
  return std::clamp(room, layout.px(100), layout.px(260));
}

/// The three directions as the camera sees them, nearest drawn last.
void draw_axes(Layout& layout, const CameraPose& camera) {
  const Vec3 direction = (camera.position - camera.focal).normalized();
  const Vec3 right = camera.up.cross(direction).normalized(), upright = direction.cross(right);
  struct Axis {
    int index;
    double depth;
  };
  std::array<Axis, 3> axes;
  for (int i = 0; i < 3; ++i) axes[static_cast<std::size_t>(i)] = {i, direction[i]};
  std::sort(axes.begin(), axes.end(), [](const Axis& a, const Axis& b) { return a.depth < b.depth; });
  constexpr std::array<Rgb, 3> kColoursOfAxes{{{213, 94, 0}, {0, 140, 100}, {0, 114, 178}}};
  constexpr std::array<const char*, 3> kNames{"x", "y", "z"};
  const double x = layout.px(66), y = layout.height - layout.px(62), length = layout.px(40);
  for (const Axis& axis : axes) {
    const auto i = static_cast<std::size_t>(axis.index);
    const double dx = length * right[axis.index], dy = -length * upright[axis.index];
    layout.canvas.line(x, y, x + dx, y + dy, layout.px(3), kColoursOfAxes[i]);
    const double size = std::hypot(dx, dy);
    if (size > layout.px(6))
      for (double turn : {0.42, -0.42}) {
        const double c = std::cos(turn), s = std::sin(turn), back = -layout.px(10) / size;
        layout.canvas.line(x + dx, y + dy, x + dx + back * (c * dx - s * dy),
                           y + dy + back * (s * dx + c * dy), layout.px(3), kColoursOfAxes[i]);
      }
    const Canvas::TextStyle style{
        .size = layout.px(16), .colour = layout.theme.text, .is_bold = true, .align = Canvas::Align::kCentre};
    const double reach = size > 0.0 ? 1.0 + layout.px(13) / std::max(size, 1.0) : 1.0;
    layout.canvas.text(
        static_cast<int>(std::lround(x + reach * dx)),
        static_cast<int>(std::lround(y + reach * dy)) - Canvas::text_size(kNames[i], style)[1] / 2, kNames[i],
        style);
  }
}

std::vector<PixelBox> draw_all(Layout& layout, const Legend& legend, const Words& words,
                               const CameraPose& camera) {
  std::vector<PixelBox> boxes;
  const auto close_box = [&] { boxes.push_back(layout.canvas.take_touched()); };
  const SwatchPanel swatches(layout, legend);
  const int legend_left = find_legend_left(layout, legend, swatches);
  const int heading_end = draw_heading(layout, legend, words, legend_left - layout.px(16));
  close_box();
  int top = find_legend_top(layout, legend_left, heading_end);
  const int bar_height = find_bar_height(layout, legend, swatches, top);
  for (const Legend::Bar& bar : legend.bars) {
    top = draw_bar(layout, bar, bar_height, top);
    close_box();
  }
  draw_swatches(layout, legend, swatches, top);
  close_box();
  if (words.is_live)
    layout.canvas.fill(layout.px(8), layout.height - layout.px(122), layout.px(118), layout.px(114),
                       layout.theme.panel, kGround);
  draw_axes(layout, camera);
  close_box();
  std::erase(boxes, PixelBox{});
  return boxes;
}

}  // namespace

std::vector<PixelBox> draw_overlay(Image& image, const Legend& legend, const std::string& title,
                                   const std::string& time_label, const CameraPose& camera,
                                   const Theme& theme) {
  Layout layout(image, theme);
  return draw_all(layout, legend, {title, time_label, false}, camera);
}

std::vector<PixelBox> draw_overlay(Image& image, const Legend& legend, const std::string& title,
                                   const std::string& time_label, const CameraPose& camera,
                                   const Theme& theme, double letters) {
  if (image.width < kLeastWidth || image.height < kLeastHeight) return {};
  const double usual = std::min(image.height / 720.0, image.width / 1200.0);
  // 11 pixels for a label, but no legend that fills a very small picture.
  const double least = std::min(0.70, image.height / 360.0);
  Layout layout(image, theme, letters * std::clamp(1.1 * usual, least, 6.0));
  return draw_all(layout, legend, {title, time_label, true}, camera);
}

double calc_report_height(int lines) { return lines == 0 ? 0.0 : (lines * 19.0 + 34.0) / 720.0; }

void draw_report(Image& image, const std::vector<std::string>& lines, const Theme& theme) {
  if (lines.empty()) return;
  Layout layout(image, theme);
  const Canvas::TextStyle style{.size = layout.px(14), .colour = theme.text, .is_mono = true};
  int widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, Canvas::text_size(line, style)[0]);
  const int line_height = layout.px(19), pad = layout.px(10);
  const int width = widest + 2 * pad,
            height = static_cast<int>(lines.size()) * line_height + 2 * pad - layout.px(3);
  const int left = layout.px(130), top = layout.height - layout.px(14) - height;
  layout.canvas.fill(left, top, width, height, theme.panel, 0.82);
  layout.canvas.frame(left, top, width, height, theme.panel_frame);
  for (std::size_t i = 0; i < lines.size(); ++i)
    layout.canvas.text(left + pad, top + pad + static_cast<int>(i) * line_height, lines[i], style);
}

}  // namespace hydroscope
