// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/contact/constraint.h"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace hydroscope {

Eigen::Matrix<double, 3, kDofs> SlavePoint::calc_map() const {
  Eigen::Matrix<double, 3, kDofs> map;
  map << Mat3::Identity(), -offset * triad.v2, offset * triad.v1;
  return map;
}

Eigen::Matrix<double, kDofs, 1> calc_gap_row(const SlavePoint& point, const Vec3& normal) {
  return point.calc_map().transpose() * normal;
}

Mat3 calc_known_gradient(const FootPoint& foot, double radius) {
  constexpr double kFlat = 0.1;  // of 1/radius: less is none
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(
      Mat3(0.5 * (foot.normal_gradient + foot.normal_gradient.transpose())));
  Mat3 gradient = Mat3::Zero();
  for (int i = 0; i < 3; ++i) {
    const double curvature = principal.eigenvalues()[i];
    if (std::abs(curvature) < kFlat / radius) continue;
    const Vec3 direction = principal.eigenvectors().col(i);
    gradient += std::copysign(1.0 / radius, curvature) * direction * direction.transpose();
  }
  return gradient;
}

Eigen::Matrix<double, kDofs, kDofs> calc_contact_stiffness(const SlavePoint& point, const FootPoint& foot,
                                                           double normal_force,
                                                           const FrictionResult& friction, bool use_curvature,
                                                           bool symmetrise) {
  const auto map = point.calc_map();
  Mat3 inner = friction.stiffness;
  if (use_curvature) {
    // dn/dx already acts in the tangent plane: its rows are tangential; take n's direction off its columns.
    const Mat3 tangent_plane = Mat3::Identity() - foot.normal * foot.normal.transpose();
    const Mat3 curvature = foot.normal_gradient * tangent_plane;  // (4.29), (4.30), (4.32)
    inner -=
        normal_force * (symmetrise ? Mat3(0.5 * (curvature + curvature.transpose())) : curvature);  // (4.33)
  }
  Eigen::Matrix<double, kDofs, kDofs> k = map.transpose() * inner * map;
  const double turn = point.offset * point.triad.v.dot(normal_force * foot.normal + friction.force);
  k.bottomRightCorner<2, 2>().diagonal().array() += turn;
  return k;
}

}  // namespace hydroscope
