// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/geometry/tool_surface.h"

namespace hydroscope {

/// How far a tool surface is from an exact one, over sample points.
struct SurfaceError {
  int points = 0;
  int lost = 0;                ///< points to which only the exact surface has a foot point
  double gap_rms = 0.0;        ///< [mm]
  double gap_max = 0.0;        ///< [mm]
  double normal_rms = 0.0;     ///< angle between the normals [deg]
  double normal_max = 0.0;     ///< [deg]
  double curvature_rms = 0.0;  ///< of the difference in dn/dx, Frobenius [1/mm]
};

/// Compares foot points of `tool` with those of `exact` at `points` [mm], no farther than `band` [mm] away.
/// A normal error d acts in a frictionless contact like friction tan(d) (mechanics 6.1).
SurfaceError measure_surface_error(const ToolSurface& tool, const ToolSurface& exact,
                                   const std::vector<Vec3>& points, double band);

/// One line for a report: gap and normal, rms and largest.
std::string format_surface_error(const SurfaceError& error);

}  // namespace hydroscope
