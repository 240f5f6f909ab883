// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/chart/marker_shape.h"

#include <cmath>
#include <numbers>

namespace hydroscope {
namespace {

std::vector<std::array<double, 2>> make_polygon(int corners, double radius, double first_angle) {
  std::vector<std::array<double, 2>> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = first_angle + 2.0 * std::numbers::pi * i / corners;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon;
}

std::vector<std::array<double, 2>> make_ring() {
  const auto circle = make_polygon(24, 0.9, 0.0);
  std::vector<std::array<double, 2>> strokes;
  for (std::size_t i = 0; i < circle.size(); ++i) {
    strokes.push_back(circle[i]);
    strokes.push_back(circle[(i + 1) % circle.size()]);
  }
  return strokes;
}

}  // namespace

MarkerShape make_marker_shape(ChartMarker marker) {
  constexpr double kQuarter = 0.25 * std::numbers::pi, kHalf = 0.5 * std::numbers::pi;
  switch (marker) {
    case ChartMarker::kNone:
      return {};
    case ChartMarker::kCircle:
      return {make_polygon(24, 1.0, 0.0)};
    case ChartMarker::kSquare:
      return {make_polygon(4, 1.25, kQuarter)};
    case ChartMarker::kDiamond:
      return {make_polygon(4, 1.25, 0.0)};
    case ChartMarker::kTriangle:
      return {make_polygon(3, 1.3, kHalf)};
    case ChartMarker::kDown:
      return {make_polygon(3, 1.3, -kHalf)};
    case ChartMarker::kCross:
      return {{{-0.8, -0.8}, {0.8, 0.8}, {-0.8, 0.8}, {0.8, -0.8}}, false};
    case ChartMarker::kPlus:
      return {{{-1.0, 0.0}, {1.0, 0.0}, {0.0, -1.0}, {0.0, 1.0}}, false};
    case ChartMarker::kRing:
      return {make_ring(), false, 0.1};
  }
  return {};
}

}  // namespace hydroscope
