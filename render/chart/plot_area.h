// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "render/chart/line_chart.h"

namespace hydroscope {

/// What VTK draws of a chart, ready to be drawn: no scales and no lettering.
struct PlotArea {
  struct Line {
    std::vector<std::array<double, 2>> points{};  ///< 0..1 along both axes; a nan breaks the line
    Rgb colour{};
    double width = 1.0;  ///< [px]
    ChartLine style = ChartLine::kSolid;
  };
  struct Marker {
    double x = 0.0, y = 0.0;  ///< [px] from the top left of the picture
    double size = 8.0;        ///< [px]
    ChartMarker shape = ChartMarker::kCircle;
    Rgb colour{};
    Rgb rim{};  ///< thin outline, the colour of the ground
  };
  PixelBox box;  ///< inside of the axes, in the picture
  Rgb ground{}, axis{}, grid{}, small_grid{};
  std::array<std::vector<double>, 2> ticks{};        ///< 0..1, labelled ones
  std::array<std::vector<double>, 2> small_ticks{};  ///< 0..1
  double axis_width = 1.0;                           ///< [px]
  std::vector<Line> lines{};
  std::vector<Marker> markers{};
};

/// Draws plot areas with VTK's charts in a context of its own.
class PlotAreaPainter {
 public:
  PlotAreaPainter(std::array<int, 2> size, int rasteriser_threads);
  ~PlotAreaPainter();
  PlotAreaPainter(const PlotAreaPainter&) = delete;
  PlotAreaPainter& operator=(const PlotAreaPainter&) = delete;

  Image draw(const PlotArea& area);
  std::string renderer() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hydroscope
