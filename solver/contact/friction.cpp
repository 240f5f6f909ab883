// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/friction.h"

#include <algorithm>

namespace hydroscope {

Vec3 transport_tangential(const Vec3& force, const Vec3& normal) {
  const double length = force.norm();
  const Vec3 tangential = force - normal.dot(force) * normal;
  const double rest = tangential.norm();
  return rest > 1e-12 * length && rest > 0.0 ? Vec3(tangential * (length / rest)) : Vec3::Zero();
}

FrictionResult calc_friction(const Vec3& start, const Vec3& sliding, const Vec3& normal, double normal_force,
                             double mu, double stick_stiffness) {
  FrictionResult result;
  const double limit = mu * std::max(normal_force, 0.0);
  if (mu <= 0.0) {
    result.is_slipping = true;
    return result;
  }
  const Mat3 tangent_plane = Mat3::Identity() - normal * normal.transpose();
  const Vec3 trial =
      transport_tangential(start, normal) - stick_stiffness * (tangent_plane * sliding);  // (4.45)
  const double size = trial.norm();
  if (size <= limit) {
    result.force = trial;
    result.stiffness = stick_stiffness * tangent_plane;
    return result;
  }
  const Vec3 direction = trial / size;
  result.is_slipping = true;
  result.force = limit * direction;  // (4.47)
  result.stiffness = stick_stiffness * limit / size * (tangent_plane - direction * direction.transpose());
  return result;
}

FrictionResult calc_lagging_friction(const Vec3& start, bool is_slipping, const Vec3& sliding,
                                     const Vec3& normal, double stick_stiffness) {
  FrictionResult result;
  result.force = transport_tangential(start, normal);
  result.is_slipping = is_slipping;
  if (is_slipping) return result;
  result.stiffness = stick_stiffness * (Mat3::Identity() - normal * normal.transpose());
  result.force -= result.stiffness * sliding;  // (4.45)
  return result;
}

FrictionResult renew_lagging_friction(const Vec3& force, bool is_slipping, const Vec3& sliding,
                                      const Vec3& normal, double normal_force, double mu, double shortest) {
  const double limit = mu * std::max(normal_force, 0.0), size = force.norm();
  FrictionResult result;
  result.force = force;
  if (!is_slipping && size <= limit) return result;  // (4.46)
  const Vec3 slide = sliding - normal.dot(sliding) * normal;
  const bool has_turned = is_slipping && force.dot(slide) > 0.0 && slide.norm() > shortest;
  const Vec3 carried = size > 0.0 ? Vec3(force * (limit / size)) : Vec3::Zero();
  result.is_slipping = !has_turned;
  result.force =
      has_turned || slide.norm() <= shortest ? carried : Vec3(-limit / slide.norm() * slide);  // (4.47)
  return result;
}

}  // namespace hydroscope
