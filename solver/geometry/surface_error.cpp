// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/surface_error.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace hydroscope {

SurfaceError measure_surface_error(const ToolSurface& tool, const ToolSurface& exact,
                                   const std::vector<Vec3>& points, double band) {
  SurfaceError error;
  SearchHint hint, exact_hint;
  double gap2 = 0.0, angle2 = 0.0, curvature2 = 0.0;
  for (const Vec3& x : points) {
    const auto wanted = exact.find_foot_point(x, band, band, exact_hint);
    if (!wanted) continue;
    const auto foot = tool.find_foot_point(x, band, band, hint);
    if (!foot) {
      ++error.lost;
      continue;
    }
    ++error.points;
    const double gap = std::abs(foot->gap - wanted->gap);
    const double angle =
        std::atan2(foot->normal.cross(wanted->normal).norm(), foot->normal.dot(wanted->normal)) * 180.0 /
        std::numbers::pi;
    gap2 += gap * gap;
    angle2 += angle * angle;
    curvature2 += (foot->normal_gradient - wanted->normal_gradient).squaredNorm();
    error.gap_max = std::max(error.gap_max, gap);
    error.normal_max = std::max(error.normal_max, angle);
  }
  if (error.points == 0) return error;
  error.gap_rms = std::sqrt(gap2 / error.points);
  error.normal_rms = std::sqrt(angle2 / error.points);
  error.curvature_rms = std::sqrt(curvature2 / error.points);
  return error;
}

std::string format_surface_error(const SurfaceError& error) {
  char text[256];
  std::snprintf(
      text, sizeof text,
      "%d points, %d lost; gap rms %.3g, max %.3g mm; normal rms %.3g, max %.3g deg; dn/dx rms %.3g 1/mm",
      error.points, error.lost, error.gap_rms, error.gap_max, error.normal_rms, error.normal_max,
      error.curvature_rms);
  return text;
}

}  // namespace hydroscope
