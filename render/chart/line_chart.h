// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/image/image.h"
#include "render/image/pixel_box.h"

namespace hydroscope {

enum class ChartScale { kLinear, kLog };

struct ChartAxis {
  std::string title{};  ///< with its unit, e.g. "pressure [MPa]"
  ChartScale scale = ChartScale::kLinear;
  std::optional<double> low{}, high{};  ///< ends that are not given come from the data
};

enum class ChartLine { kNone, kSolid, kDashed, kDotted };
enum class ChartMarker { kNone, kCircle, kSquare, kDiamond, kTriangle, kDown, kCross, kPlus, kRing };

/// One named set of points. A point that is not finite, or not above zero on a
/// logarithmic axis, is left out and breaks the line.
struct ChartSeries {
  std::string name{};  ///< in the legend; empty: not listed
  std::vector<double> x{}, y{};
  std::vector<std::string> labels{};  ///< one a point, or none
  std::optional<Rgb> colour{};        ///< not given: the next of chart_colours()
  ChartLine line = ChartLine::kSolid;
  ChartMarker marker = ChartMarker::kNone;
  double line_width = 2.0;    ///< [px] of a picture of 1000 rows
  double marker_size = 13.0;  ///< [px] of a picture of 1000 rows
};

/// A line right across the plot, e.g. the time of the frame.
struct ChartMark {
  double value = 0.0;
  std::string label{};
  std::optional<Rgb> colour{};
  ChartLine line = ChartLine::kDashed;
};

/// Something that has no height: a cross on a strip above the plot.
struct ChartFailure {
  std::optional<double> x{};  ///< not given: at the left end
  std::string label{};
};

struct LineChart {
  std::string title{}, subtitle{};
  ChartAxis x{}, y{};
  std::vector<ChartSeries> series{};
  std::vector<ChartMark> vertical_marks{}, horizontal_marks{};
  std::string failure_title{};  ///< of the strip
  std::vector<ChartFailure> failures{};
  std::vector<std::string> notes{};  ///< small lines below the legend
  enum class Legend { kNone, kRight, kInside } legend = Legend::kRight;
};

struct LineChartOptions {
  std::array<int, 2> size{1600, 1000};  ///< [px]
  std::string theme = "light";          ///< "light" or "dark"
  double text_scale = 1.0;              ///< letters against their usual size (24 px of 1000 rows)
  int rasteriser_threads = 1;           ///< see OffscreenContext
};

/// Where data stand in the picture.
struct ChartPlace {
  PixelBox plot;                   ///< inside of the axes
  std::array<double, 2> x, y;      ///< ends of the axes
  std::vector<PixelBox> labels{};  ///< of points, as placed
  int missing_labels = 0;          ///< of them, those that had to overlap something
};

/// Draws charts one after the other with one context. Belongs to the thread that makes it.
class LineChartPainter {
 public:
  /// Throws EnvironmentError as OffscreenContext does.
  explicit LineChartPainter(const LineChartOptions& options);
  ~LineChartPainter();
  LineChartPainter(const LineChartPainter&) = delete;
  LineChartPainter& operator=(const LineChartPainter&) = delete;

  Image draw(const LineChart& chart);
  /// Of the chart drawn last.
  const ChartPlace& place() const;
  /// GL_RENDERER, for the texts of a PNG.
  std::string renderer() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One picture with a context of its own.
Image draw_line_chart(const LineChart& chart, const LineChartOptions& options = {});

/// Eight colours that stay apart for colour-blind readers (Okabe and Ito), darkest yellow last.
const std::vector<Rgb>& chart_colours();

}  // namespace hydroscope
