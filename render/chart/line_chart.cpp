// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/chart/line_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/chart/axis_scale.h"
#include "render/chart/chart_annotations.h"
#include "render/chart/chart_lettering.h"
#include "render/chart/label_layout.h"
#include "render/chart/plot_area.h"
#include "render/image/canvas.h"
#include "render/image/colour_map.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

struct ScaledSeries {
  const ChartSeries* series = nullptr;
  Rgb colour{};
};

std::vector<double> collect(const LineChart& chart, bool is_x) {
  std::vector<double> values;
  for (const ChartSeries& series : chart.series) {
    require(series.x.size() == series.y.size(), "a series has as many x as y");
    require(series.labels.empty() || series.labels.size() == series.x.size(),
            "a label for each point or none");
    for (std::size_t i = 0; i < series.x.size(); ++i)
      if (std::isfinite(series.x[i]) && std::isfinite(series.y[i]))
        values.push_back(is_x ? series.x[i] : series.y[i]);
  }
  for (const ChartMark& mark : is_x ? chart.vertical_marks : chart.horizontal_marks)
    values.push_back(mark.value);
  if (is_x)
    for (const ChartFailure& failure : chart.failures) values.push_back(failure.x.value_or(kNowhere));
  return values;
}

/// Points along the lines of a plot, some pixels apart [px].
std::vector<std::array<double, 2>> sample_lines(const PlotArea& area) {
  constexpr double kApart = 6.0;
  std::vector<std::array<double, 2>> samples;
  const auto to_pixels = [&](const std::array<double, 2>& p) {
    return std::array{area.box.left + p[0] * area.box.width, area.box.top + (1.0 - p[1]) * area.box.height};
  };
  for (const PlotArea::Line& line : area.lines)
    for (std::size_t i = 1; i < line.points.size() && line.style != ChartLine::kNone; ++i) {
      const auto a = to_pixels(line.points[i - 1]), b = to_pixels(line.points[i]);
      const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
      if (!std::isfinite(length) || samples.size() > 20000) continue;
      const int count = static_cast<int>(std::min(length, 5000.0) / kApart) + 1;
      for (int k = 0; k < count; ++k)
        samples.push_back({a[0] + k * (b[0] - a[0]) / count, a[1] + k * (b[1] - a[1]) / count});
    }
  return samples;
}

/// A label of a point that waits for its place.
struct PendingLabel {
  LabelWish wish;
  std::string text;
  Rgb colour{};
};

}  // namespace

const std::vector<Rgb>& chart_colours() {
  static const std::vector<Rgb> colours = {{0, 114, 178},  {213, 94, 0},  {0, 140, 100}, {184, 82, 144},
                                           {70, 165, 220}, {210, 145, 0}, {90, 90, 90},  {130, 60, 20}};
  return colours;
}

struct LineChartPainter::Impl {
  explicit Impl(const LineChartOptions& given)
      : options(given), colours(theme(given.theme)), painter(given.size, given.rasteriser_threads) {
    const bool is_light = given.theme == "light";
    ground = is_light ? Rgb{255, 255, 255} : colours.background_top;
  }

  Image draw(const LineChart& chart);
  std::vector<ScaledSeries> find_colours(const LineChart& chart) const;
  void add_entry(std::vector<ChartEntry>& entries, const ChartSeries& series, Rgb colour) const;
  std::vector<ChartEntry> make_entries(const LineChart& chart, const std::vector<ScaledSeries>& all) const;
  PlotArea make_area(const LineChart& chart, const std::vector<ScaledSeries>& all, const ChartLayout& layout,
                     const AxisScale& x, const AxisScale& y) const;
  void add_marks(PlotArea& area, const LineChart& chart, const AxisScale& x, const AxisScale& y) const;
  std::vector<PendingLabel> collect_labels(const std::vector<ScaledSeries>& all, const ChartLayout& layout,
                                           const AxisScale& x, const AxisScale& y) const;
  void draw_labels(Canvas& canvas, const std::vector<PendingLabel>& labels, const PlotArea& area,
                   const ChartLayout& layout);
  double unit() const { return calc_chart_unit(options.size); }

  double thickness(double width) const { return std::max(1.3, width * unit()); }

  LineChartOptions options;
  const Theme& colours;
  Rgb ground{};
  PlotAreaPainter painter;
  ChartPlace place;
};

std::vector<ScaledSeries> LineChartPainter::Impl::find_colours(const LineChart& chart) const {
  std::vector<ScaledSeries> all;
  std::size_t next = 0;
  const auto& palette = chart_colours();
  for (const ChartSeries& series : chart.series) {
    Rgb colour = series.colour ? *series.colour : palette[next++ % palette.size()];
    // Dark colours are lifted on a dark ground.
    if (options.theme != "light" && colour[0] + colour[1] + colour[2] < 330)
      colour = mix_colours(colour, {255, 255, 255}, 0.35);
    all.push_back({&series, colour});
  }
  return all;
}

/// A name that is too long for the column goes on below.
void LineChartPainter::Impl::add_entry(std::vector<ChartEntry>& entries, const ChartSeries& series,
                                       Rgb colour) const {
  if (series.name.empty()) return;
  const Canvas::TextStyle style{.size = static_cast<int>(std::lround(22.0 * unit() * options.text_scale))};
  ChartEntry entry{.colour = colour,
                   .line_width = thickness(series.line_width),
                   .line = series.line,
                   .marker = series.marker,
                   .marker_size = series.marker_size * unit()};
  for (const std::string& line : wrap_text(series.name, options.size[0] * 24 / 100, style)) {
    entry.text = line;
    entries.push_back(entry);
    entry.is_continued = true;
  }
}

std::vector<ChartEntry> LineChartPainter::Impl::make_entries(const LineChart& chart,
                                                             const std::vector<ScaledSeries>& all) const {
  std::vector<ChartEntry> entries;
  if (chart.legend == LineChart::Legend::kNone) return entries;
  for (const auto& [series, colour] : all) add_entry(entries, *series, colour);
  const Canvas::TextStyle style{.size = static_cast<int>(std::lround(20.0 * unit() * options.text_scale))};
  for (const std::string& note : chart.notes)
    for (const std::string& line : wrap_text(note, options.size[0] * 27 / 100, style))
      entries.push_back({.text = line, .has_sample = false});
  return entries;
}

PlotArea LineChartPainter::Impl::make_area(const LineChart& chart, const std::vector<ScaledSeries>& all,
                                           const ChartLayout& layout, const AxisScale& x,
                                           const AxisScale& y) const {
  PlotArea area;
  area.box = layout.plot;
  area.ground = ground;
  area.axis = colours.text;
  area.grid = mix_colours(ground, colours.faint_text, 0.22);
  area.axis_width = thickness(2.0);
  for (const AxisTick& tick : x.find_ticks(layout.plot.width / (layout.text * 5)))
    if (!tick.label.empty()) area.ticks[0].push_back(x.to_unit(tick.value));
  for (const AxisTick& tick : y.find_ticks(layout.plot.height / (layout.text * 3)))
    if (!tick.label.empty()) area.ticks[1].push_back(y.to_unit(tick.value));
  add_marks(area, chart, x, y);
  for (const auto& [series, colour] : all) {
    PlotArea::Line line{{}, colour, thickness(series->line_width), series->line};
    for (std::size_t i = 0; i < series->x.size(); ++i) {
      const bool has_place = x.takes(series->x[i]) && y.takes(series->y[i]);
      line.points.push_back(has_place ? std::array{x.to_unit(series->x[i]), y.to_unit(series->y[i])}
                                      : std::array{kNowhere, kNowhere});
      const auto& [px, py] = line.points.back();
      if (!has_place || series->marker == ChartMarker::kNone || px < 0.0 || px > 1.0 || py < 0.0 || py > 1.0)
        continue;
      area.markers.push_back({layout.plot.left + px * layout.plot.width,
                              layout.plot.top + (1.0 - py) * layout.plot.height, series->marker_size * unit(),
                              series->marker, colour, ground});
    }
    area.lines.push_back(std::move(line));
  }
  return area;
}

void LineChartPainter::Impl::add_marks(PlotArea& area, const LineChart& chart, const AxisScale& x,
                                       const AxisScale& y) const {
  for (const ChartMark& mark : chart.vertical_marks)
    if (x.takes(mark.value))
      area.lines.push_back({{{x.to_unit(mark.value), 0.0}, {x.to_unit(mark.value), 1.0}},
                            mark.colour.value_or(colours.faint_text),
                            2.0 * unit(),
                            mark.line});
  for (const ChartMark& mark : chart.horizontal_marks)
    if (y.takes(mark.value))
      area.lines.push_back({{{0.0, y.to_unit(mark.value)}, {1.0, y.to_unit(mark.value)}},
                            mark.colour.value_or(colours.faint_text),
                            2.0 * unit(),
                            mark.line});
}

std::vector<PendingLabel> LineChartPainter::Impl::collect_labels(const std::vector<ScaledSeries>& all,
                                                                 const ChartLayout& layout,
                                                                 const AxisScale& x,
                                                                 const AxisScale& y) const {
  std::vector<PendingLabel> labels;
  for (const auto& [series, colour] : all)
    for (std::size_t i = 0; i < series->labels.size(); ++i) {
      if (series->labels[i].empty() || !x.takes(series->x[i]) || !y.takes(series->y[i])) continue;
      const auto [width, height] = Canvas::text_size(series->labels[i], {.size = layout.small_text});
      labels.push_back({{layout.plot.left + x.to_unit(series->x[i]) * layout.plot.width,
                         layout.plot.top + (1.0 - y.to_unit(series->y[i])) * layout.plot.height, width + 4,
                         height + 4, 0.55 * series->marker_size * unit()},
                        series->labels[i],
                        mix_colours(colour, colours.text, 0.35)});
    }
  return labels;
}

void LineChartPainter::Impl::draw_labels(Canvas& canvas, const std::vector<PendingLabel>& labels,
                                         const PlotArea& area, const ChartLayout& layout) {
  std::vector<LabelWish> wishes;
  for (const PendingLabel& label : labels) wishes.push_back(label.wish);
  std::vector<PixelBox> obstacles;
  for (const PlotArea::Marker& marker : area.markers) {
    const int half = static_cast<int>(std::lround(0.55 * marker.size));
    obstacles.push_back(
        {static_cast<int>(marker.x) - half, static_cast<int>(marker.y) - half, 2 * half, 2 * half});
  }
  // The margin at the right of the plot may be used as well, up to the legend.
  PixelBox bounds = layout.plot;
  bounds.left += 4;
  bounds.width -= 4;
  const auto placed = place_labels(wishes, bounds, obstacles, sample_lines(area));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const PixelBox& box = placed[i].box;
    if (placed[i].is_far) {
      const double to_x = std::clamp(labels[i].wish.x, static_cast<double>(box.left),
                                     static_cast<double>(box.left + box.width));
      const double to_y = std::clamp(labels[i].wish.y, static_cast<double>(box.top),
                                     static_cast<double>(box.top + box.height));
      canvas.line(labels[i].wish.x, labels[i].wish.y, to_x, to_y, 1.2 * unit(),
                  mix_colours(ground, labels[i].colour, 0.6));
    }
    place.labels.push_back(box);
    place.missing_labels += placed[i].has_room ? 0 : 1;
  }
  // A veil below the letters keeps them readable over lines.
  for (const PlacedLabel& label : placed)
    canvas.fill(label.box.left, label.box.top, label.box.width, label.box.height, ground, 0.72);
  for (std::size_t i = 0; i < labels.size(); ++i)
    canvas.text(placed[i].box.left + 2, placed[i].box.top + 2, labels[i].text,
                {.size = layout.small_text, .colour = labels[i].colour});
}

Image LineChartPainter::Impl::draw(const LineChart& chart) {
  const AxisScale x(chart.x, collect(chart, true)), y(chart.y, collect(chart, false));
  const std::vector<ScaledSeries> all = find_colours(chart);
  const ChartLayout layout =
      make_chart_layout(chart, options.size, options.text_scale, make_entries(chart, all),
                        y.find_ticks(std::max(options.size[1] / 90, 5)));
  const PlotArea area = make_area(chart, all, layout, x, y);
  Image image = painter.draw(area);
  Canvas canvas(image);
  place = {.plot = layout.plot, .x = {x.low(), x.high()}, .y = {y.low(), y.high()}};
  draw_chart_frame(canvas, image, chart, layout, x, y, colours, ground);
  draw_failure_strip(canvas, chart, layout, x, colours, ground);
  draw_labels(canvas, collect_labels(all, layout, x, y), area, layout);
  draw_mark_labels(canvas, chart, layout, x, y, colours);
  if (!layout.entries.empty() && chart.legend == LineChart::Legend::kInside)
    draw_inside_legend(canvas, layout, area, colours);
  if (!layout.entries.empty() && chart.legend == LineChart::Legend::kRight)
    draw_chart_entries(canvas, layout, layout.side_left, layout.plot.top, image.height - layout.text / 2,
                       colours);
  return image;
}

LineChartPainter::LineChartPainter(const LineChartOptions& options)
    : impl_(std::make_unique<Impl>(options)) {}
LineChartPainter::~LineChartPainter() = default;
Image LineChartPainter::draw(const LineChart& chart) { return impl_->draw(chart); }
const ChartPlace& LineChartPainter::place() const { return impl_->place; }
std::string LineChartPainter::renderer() const { return impl_->painter.renderer(); }

Image draw_line_chart(const LineChart& chart, const LineChartOptions& options) {
  return LineChartPainter(options).draw(chart);
}

}  // namespace hydroscope
