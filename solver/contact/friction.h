// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/base/types.h"
#include "solver/contact/contact_point.h"

namespace hydroscope {

enum class FrictionLaw {
  kReturnMapping,  ///< within the increment
  kOneStepBehind,  ///< (4.45)-(4.49)
  kStick,          ///< pseudo-stick alone (4.45)
};

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

/// Friction of the source: a sticking node takes the elastic trial whatever its size, a slipping one carries
/// the force of the last accepted state, whose direction and bound lag by one increment.
FrictionResult calc_lagging_friction(const Vec3& start, bool is_slipping, const Vec3& sliding,
                                     const Vec3& normal, double stick_stiffness);

/// What that friction becomes at the end of an increment: (4.46) tells who slips, (4.47) with which force;
/// a node that is driven along its friction force has turned round and sticks. Below `shortest` [mm] of
/// sliding the direction stays. The difference from the force carried so far is f_neq,fric (4.48).
FrictionResult renew_lagging_friction(const Vec3& force, bool is_slipping, const Vec3& sliding,
                                      const Vec3& normal, double normal_force, double mu, double shortest);

/// `force` turned onto the plane across `normal`, its length kept.
Vec3 transport_tangential(const Vec3& force, const Vec3& normal);

}  // namespace hydroscope
