// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "render/image/image.h"
#include "render/shape/reflection.h"

namespace hydroscope {

using Vec3f = Eigen::Vector3f;

/// What is drawn as filled polygons. Either `values` (a scalar a point, NaN
/// allowed) or `colours` (a colour a point) or neither is filled.
struct Surface {
  std::vector<Vec3f> points;   ///< [mm]
  std::vector<Vec3f> normals;  ///< unit, for the light
  std::vector<float> values;
  std::vector<Rgb> colours;
  /// Point indices, counter-clockwise from outside; a triangle's last one is -1.
  std::vector<std::array<int, 4>> polygons;

  int add_point(const Vec3& x, const Vec3& n) {
    points.push_back(x.cast<float>());
    normals.push_back(n.cast<float>());
    return static_cast<int>(points.size()) - 1;
  }
};

/// What is drawn as lines.
struct LineSet {
  std::vector<Vec3f> points;  ///< [mm]
  std::vector<std::array<int, 2>> lines;

  void add_line(const Vec3& a, const Vec3& b) {
    const int first = static_cast<int>(points.size());
    points.push_back(a.cast<float>());
    points.push_back(b.cast<float>());
    lines.push_back({first, first + 1});
  }
};

/// Adds another surface that is painted in the same way.
void append(Surface& surface, const Surface& more);

/// All copies of one piece.
Surface calc_reflected(const Surface& piece, const std::vector<Reflection>& reflections);
LineSet calc_reflected(const LineSet& piece, const std::vector<Reflection>& reflections);

}  // namespace hydroscope
