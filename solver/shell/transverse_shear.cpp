// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/shell/transverse_shear.h"

namespace hydroscope {

TiedShear::TiedShear(const ElementNodes& nodes) {
  for (std::size_t t = 0; t < 4; ++t) {
    const ShapeFunctions s = calc_shape_functions(kTyingPoints[t].xi, kTyingPoints[t].eta);
    n[t] = s.n;
    dn[t] = kTyingPoints[t].direction == 1 ? s.n1 : s.n2;
    g[t] = g3[t] = Vec3::Zero();
    for (std::size_t a = 0; a < 4; ++a) {
      g[t] += dn[t][a] * nodes.x[a];
      g3[t] += n[t][a] * 0.5 * nodes.thickness[a] * nodes.triad[a].v;
    }
    gamma[t] = g[t].dot(g3[t]);
  }
}

void add_shear_force(const TiedShear& shear, const std::array<double, 4>& s, std::array<Vec3, 4>& force,
                     std::array<Vec3, 4>& fibre_force) {
  for (std::size_t t = 0; t < 4; ++t) {
    for (std::size_t a = 0; a < 4; ++a) {
      force[a] += s[t] * shear.dn[t][a] * shear.g3[t];
      fibre_force[a] += s[t] * shear.n[t][a] * shear.g[t];
    }
  }
}

void add_shear_stiffness(const TiedShear& shear, const std::array<double, 4>& s,
                         const Eigen::Matrix4d& moduli, const std::array<Eigen::Matrix<double, 3, 2>, 4>& w,
                         ElementMatrix& stiffness) {
  Eigen::Matrix<double, 4, kElementDofs> rows;
  for (std::size_t t = 0; t < 4; ++t) {
    for (std::size_t a = 0; a < 4; ++a) {
      const auto row = static_cast<Eigen::Index>(t), col = static_cast<Eigen::Index>(5 * a);
      rows.block<1, 3>(row, col) = shear.dn[t][a] * shear.g3[t].transpose();
      rows.block<1, 2>(row, col + 3) = shear.n[t][a] * shear.g[t].transpose() * w[a];
    }
  }
  stiffness.noalias() += rows.transpose() * (moduli * rows);
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < 4; ++b) {
      double c = 0.0;
      for (std::size_t t = 0; t < 4; ++t) c += s[t] * shear.dn[t][a] * shear.n[t][b];
      const auto ia = static_cast<Eigen::Index>(5 * a), ib = static_cast<Eigen::Index>(5 * b);
      stiffness.block<3, 2>(ia, ib + 3) += c * w[b];
      stiffness.block<2, 3>(ib + 3, ia) += c * w[b].transpose();
    }
  }
}

}  // namespace hydroscope
