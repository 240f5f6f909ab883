// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/base/types.h"
#include "solver/contact/contact_point.h"

namespace hydroscope {

/// Coulomb friction with a pseudo-stick stiffness (4.45)-(4.47), integrated by
/// a return mapping: the elastic trial -E_t du is brought back to the circle
/// |f| = mu t_N (4.46).
struct FrictionResult {
  Vec3 force = Vec3::Zero();      ///< on the sheet [N]
  Mat3 stiffness = Mat3::Zero();  ///< -d force / d u without the change of t_N, symmetric [N/mm]
  bool is_slipping = false;
};

/// `start` friction force at the start of the increment [N], carried along
/// onto the present tangent plane; `sliding` tangential displacement since
/// [mm]; `stick_stiffness` E_t [N/mm].
FrictionResult calc_friction(const Vec3& start, const Vec3& sliding, const Vec3& normal, double normal_force,
                             double mu, double stick_stiffness);

/// `force` turned onto the plane across `normal`, its length kept.
Vec3 transport_tangential(const Vec3& force, const Vec3& normal);

}  // namespace hydroscope
