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
  std::array<Eigen::Matrix<double, 4, kDofs>, 4> rows;
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t t = 0; t < 4; ++t) {
      rows[a].row(static_cast<Eigen::Index>(t)) << shear.dn[t][a] * shear.g3[t].transpose(),
          shear.n[t][a] * shear.g[t].transpose() * w[a];
    }
  }
  const auto couple = [&](std::size_t a, std::size_t b) {
    double c = 0.0;
    for (std::size_t t = 0; t < 4; ++t) c += s[t] * shear.dn[t][a] * shear.n[t][b];
    return c;
  };
  for (std::size_t b = 0; b < 4; ++b) {
    const Eigen::Matrix<double, 4, kDofs> stressed = moduli.lazyProduct(rows[b]);
    for (std::size_t a = 0; a <= b; ++a) {
      const auto ia = static_cast<Eigen::Index>(kDofs * a), ib = static_cast<Eigen::Index>(kDofs * b);
      stiffness.block<kDofs, kDofs>(ia, ib) += rows[a].transpose().lazyProduct(stressed);
      stiffness.block<3, 2>(ia, ib + 3) += couple(a, b) * w[b];
      stiffness.block<2, 3>(ia + 3, ib) += couple(b, a) * w[a].transpose();
    }
  }
}

}  // namespace hydroscope
