// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "solver/shell/shell_element.h"

namespace hydroscope {

ShapeFunctions calc_shape_functions(double xi, double eta) {
  static constexpr std::array<double, 4> kXi{-1, 1, 1, -1}, kEta{-1, -1, 1, 1};
  ShapeFunctions s;
  for (std::size_t a = 0; a < 4; ++a) {
    const double p = 1.0 + kXi[a] * xi, q = 1.0 + kEta[a] * eta;
    s.n[a] = 0.25 * p * q;
    s.n1[a] = 0.25 * kXi[a] * q;
    s.n2[a] = 0.25 * kEta[a] * p;
  }
  return s;
}

Vec2 gauss_point(int i) {
  static const double kG = 1.0 / std::sqrt(3.0);
  const bool is_right = i == 1 || i == 2, is_upper = i >= 2;
  return {is_right ? kG : -kG, is_upper ? kG : -kG};
}

}  // namespace hydroscope
