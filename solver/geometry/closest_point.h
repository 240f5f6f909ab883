// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/base/types.h"

namespace hydroscope {

/// Point of a triangle nearest to a given one.
struct ClosestPoint {
  Vec3 point = Vec3::Zero();    ///< [mm]
  Vec3 weights = Vec3::Zero();  ///< barycentric; exactly 0 where the point lies on an edge
  double distance2 = 0.0;       ///< [mm^2]
};

ClosestPoint find_closest_point(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace hydroscope
