// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "render/chart/line_chart.h"

namespace hydroscope {

/// A marker within -1..1, y upwards: the corners of a polygon, or pairs of ends of strokes.
struct MarkerShape {
  std::vector<std::array<double, 2>> corners{};
  bool is_filled = true;
  double stroke = 0.2;  ///< width of strokes against the marker's size
};
MarkerShape make_marker_shape(ChartMarker marker);

}  // namespace hydroscope
