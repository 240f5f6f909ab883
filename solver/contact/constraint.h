// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/contact/friction.h"
#include "solver/shell/shell_element.h"

namespace hydroscope {

/// The slave point of a node, X + offset V with offset = +-h/2 (4.63), as a
/// function of the node's five degrees of freedom.
struct SlavePoint {
  Triad triad;
  double offset = 0.0;  ///< [mm]

  /// d x_c / d (u, alpha, beta).
  Eigen::Matrix<double, 3, kDofs> calc_map() const;
};

/// Row c with c . q = change of the gap: n . (u + offset theta x V).
Eigen::Matrix<double, kDofs, 1> calc_gap_row(const SlavePoint& point, const Vec3& normal);

/// dn/dx of a tool whose radius where it is curved is known (4.11)-(4.22): the principal curvatures
/// of the foot point keep their directions and signs, but those that turn at all turn by 1/radius.
Mat3 calc_known_gradient(const FootPoint& foot, double radius);

/// What contact adds to the left-hand side: -K_C (4.28)-(4.44) with
/// K_C = t_N J^T dn/dx J written on the contact point, so that it has rotation
/// rows and columns; the friction's stiffness; and the second variation of the
/// fibre that carries the force `t_N n + f`. `use_curvature` and `symmetrise`
/// choose the treatment of dn/dx.
Eigen::Matrix<double, kDofs, kDofs> calc_contact_stiffness(const SlavePoint& point, const FootPoint& foot,
                                                           double normal_force,
                                                           const FrictionResult& friction, bool use_curvature,
                                                           bool symmetrise);

}  // namespace hydroscope
