// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "solver/base/types.h"
#include "solver/geometry/tool_surface.h"

namespace hydroscope {

/// Rigid placement: turned about x, then y, then z, then moved.
struct Pose {
  Mat3 rotation = Mat3::Identity();
  Vec3 position = Vec3::Zero();  ///< [mm]

  Vec3 place_point(const Vec3& x) const { return rotation * x + position; }
  Vec3 place_direction(const Vec3& v) const { return rotation * v; }
  /// From where it is placed to the own frame.
  Vec3 take_back(const Vec3& x) const { return rotation.transpose() * (x - position); }
};

/// `rotation_deg` about the fixed axes x, then y, then z; `position` [mm].
Pose make_pose(const std::array<double, 3>& rotation_deg, const std::array<double, 3>& position);

/// A right-handed frame whose third axis is `direction` (any length but zero).
Mat3 make_frame(const Vec3& direction);

/// A foot point of the own frame, as placed.
FootPoint place_foot_point(const Pose& pose, FootPoint foot);

/// Moves all points of `mesh`.
void place_mesh(const Pose& pose, TriangleMesh& mesh);

/// Turns every triangle around, so that the free side is the other one.
void flip_mesh(TriangleMesh& mesh);

}  // namespace hydroscope
