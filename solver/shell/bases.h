// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/shell/shell_element.h"

namespace hydroscope {

/// Base vectors of an in-plane point: g_i = x_,i and d_i = (h/2 V)_,i, so that
/// the layer zeta has g_i + zeta d_i.
struct Bases {
  Vec3 g1, g2, d1, d2;
};

inline Bases calc_bases(const ElementNodes& nodes, const ShapeFunctions& s) {
  Bases b{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  for (std::size_t a = 0; a < 4; ++a) {
    const Vec3 fibre = 0.5 * nodes.thickness[a] * nodes.triad[a].v;
    b.g1 += s.n1[a] * nodes.x[a];
    b.g2 += s.n2[a] * nodes.x[a];
    b.d1 += s.n1[a] * fibre;
    b.d2 += s.n2[a] * fibre;
  }
  return b;
}

/// Metric of a layer as a polynomial in zeta.
struct MetricPolynomial {
  explicit MetricPolynomial(const Bases& b, bool is_quadratic = true)
      : c0{b.g1.dot(b.g1), b.g2.dot(b.g2), b.g1.dot(b.g2)},
        c1{2.0 * b.g1.dot(b.d1), 2.0 * b.g2.dot(b.d2), b.g1.dot(b.d2) + b.g2.dot(b.d1)},
        c2{b.d1.dot(b.d1), b.d2.dot(b.d2), b.d1.dot(b.d2)} {
    if (!is_quadratic) c2 = {0.0, 0.0, 0.0};
  }
  Metric operator()(double z) const {
    return {c0.a11 + z * (c1.a11 + z * c2.a11), c0.a22 + z * (c1.a22 + z * c2.a22),
            c0.a12 + z * (c1.a12 + z * c2.a12)};
  }
  Metric c0, c1, c2;
};

/// The four tying points of the transverse shear: A (0,1), C (0,-1) for
/// direction 1, D (1,0), B (-1,0) for direction 2.
struct TyingPoint {
  double xi, eta;
  int direction;
};
inline constexpr std::array<TyingPoint, 4> kTyingPoints{{{0, 1, 1}, {0, -1, 1}, {1, 0, 2}, {-1, 0, 2}}};

/// Weights with which a point (xi, eta) takes its two shears from A, C, D, B.
inline std::array<double, 4> calc_tying_weights(const Vec2& at) {
  return {0.5 * (1.0 + at[1]), 0.5 * (1.0 - at[1]), 0.5 * (1.0 + at[0]), 0.5 * (1.0 - at[0])};
}

}  // namespace hydroscope
