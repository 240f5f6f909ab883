// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/prism.h"

#include <cmath>

namespace hydroscope {

namespace {

constexpr int kIterations = 12;
// Newton squares its error: a step below this leaves nothing but rounding.
constexpr double kLastStep = 1e-8;
// Part of the facet's own volume that is left; at the focal distance it is zero.
constexpr double kFocal = 1e-6;

/// Columns dx/dl1, dx/dl2, dx/dg of the prism map, and its determinant.
struct Jacobian {
  Vec3 a, b, m;
  Vec3 b_x_m;
  double det;

  Jacobian(const Prism& prism, double l1, double l2, double g)
      : a(prism.e1 + g * prism.d1),
        b(prism.e2 + g * prism.d2),
        m(prism.v3 + l1 * prism.d1 + l2 * prism.d2),
        b_x_m(b.cross(m)),
        det(a.dot(b_x_m)) {}
};

}  // namespace

Prism make_prism(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals) {
  Prism prism;
  prism.x3 = corners[2];
  prism.e1 = corners[0] - corners[2];
  prism.e2 = corners[1] - corners[2];
  prism.v3 = normals[2];
  prism.d1 = normals[0] - normals[2];
  prism.d2 = normals[1] - normals[2];
  const Vec3 area = prism.e1.cross(prism.e2);
  prism.area2 = area.norm();
  prism.normal = area / prism.area2;
  return prism;
}

void bend_edges(Prism& prism) {
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Vec3 chord = prism.corner(j) - prism.corner(i);
    prism.bend[static_cast<std::size_t>(k)] =
        0.5 * (prism.corner_normal(i) - prism.corner_normal(j)).dot(chord);
  }
}

PrismPoint locate_in_prism(const Prism& prism, const Vec3& x) {
  const Vec3 from_x3 = x - prism.x3;
  PrismPoint at{1.0 / 3.0, 1.0 / 3.0, prism.normal.dot(from_x3), false};
  const double size = std::sqrt(prism.area2);
  for (int i = 0; i < kIterations; ++i) {
    const Jacobian j(prism, at.l1, at.l2, at.g);
    if (!(j.det > kFocal * prism.area2)) return at;
    const Vec3 rest = from_x3 - at.l1 * prism.e1 - at.l2 * prism.e2 - at.g * j.m;
    const Vec3 a_x_rest = j.a.cross(rest);
    const double dl1 = rest.dot(j.b_x_m) / j.det;
    const double dl2 = a_x_rest.dot(j.m) / j.det;
    const double dg = -a_x_rest.dot(j.b) / j.det;
    at.l1 += dl1;
    at.l2 += dl2;
    at.g += dg;
    if (std::abs(dl1) < kLastStep && std::abs(dl2) < kLastStep && std::abs(dg) < kLastStep * size) {
      at.is_valid = true;
      return at;
    }
  }
  return at;
}

FootPoint make_foot_point(const Prism& prism, const PrismPoint& at, const Vec3& x) {
  const Jacobian j(prism, at.l1, at.l2, at.g);
  const double size = j.m.norm();
  FootPoint foot;
  foot.point = prism.x3 + at.l1 * prism.e1 + at.l2 * prism.e2;
  foot.normal = j.m / size;  // (4.2), normalised: interpolated normals are shorter than 1
  foot.gap = foot.normal.dot(x - foot.point);
  // Rows of the inverse Jacobian: how l1, l2 and g change with x, (4.41)-(4.44) at any height g.
  const Vec3 dl1_dx = j.b_x_m / j.det;
  const Vec3 dl2_dx = j.m.cross(j.a) / j.det;
  const Vec3 dg_dx = j.a.cross(j.b) / j.det;
  const Mat3 dm_dx = prism.d1 * dl1_dx.transpose() + prism.d2 * dl2_dx.transpose();  // (4.30)
  foot.normal_gradient = (dm_dx - foot.normal * (foot.normal.transpose() * dm_dx)) / size;
  foot.gap_gradient = size * dg_dx + at.g * (dm_dx.transpose() * foot.normal);
  // The smooth surface rises over the facet by -sum bend l_i l_j along the normal.
  const std::array<double, 3> l{at.l1, at.l2, at.l(2)};
  const std::array<Vec3, 3> dl{dl1_dx, dl2_dx, -dl1_dx - dl2_dx};
  double sink = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
    sink += prism.bend[k] * l[a] * l[b];
    foot.gap_gradient += prism.bend[k] * (l[b] * dl[a] + l[a] * dl[b]);
  }
  foot.gap += sink;
  foot.point -= sink * foot.normal;
  return foot;
}

}  // namespace hydroscope
