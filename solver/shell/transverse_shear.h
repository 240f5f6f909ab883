// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/shell/bases.h"

namespace hydroscope {

/// Covariant transverse shears gamma = g_i . g_3 at the four tying points, and
/// what is needed for their first and second variations.
struct TiedShear {
  TiedShear(const ElementNodes& nodes);

  std::array<double, 4> gamma{};
  std::array<Vec3, 4> g;   ///< in-plane base vector of the tied direction
  std::array<Vec3, 4> g3;  ///< half-thickness fibre
  std::array<std::array<double, 4>, 4> n,
      dn;  ///< shape functions and derivative along the tied direction [point][node]
};

/// Adds the work of tied shear stresses `s` (one a tying point, already
/// weighted by volume): internal force on (u, h/2 V).
void add_shear_force(const TiedShear& shear, const std::array<double, 4>& s, std::array<Vec3, 4>& force,
                     std::array<Vec3, 4>& fibre_force);

/// Adds rows^T M rows and the initial-stress term of `s` to the upper blocks (row node <= column node) of
/// the stiffness, with the director maps `w` = (h/2) [-V2, V1] of the nodes.
void add_shear_stiffness(const TiedShear& shear, const std::array<double, 4>& s,
                         const Eigen::Matrix4d& moduli, const std::array<Eigen::Matrix<double, 3, 2>, 4>& w,
                         ElementMatrix& stiffness);

}  // namespace hydroscope
