// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/closest_point.h"

#include <algorithm>
#include <limits>

namespace hydroscope {

namespace {

/// Parameter of the point of a + s e nearest to a + d, clamped to the edge.
double clamp_to_edge(double d_dot_e, double e_dot_e) { return std::clamp(d_dot_e / e_dot_e, 0.0, 1.0); }

}  // namespace

ClosestPoint find_closest_point(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ax = x - a;
  const double ab_ab = ab.dot(ab);
  const double ab_ac = ab.dot(ac);
  const double ac_ac = ac.dot(ac);
  const double ax_ab = ax.dot(ab);
  const double ax_ac = ax.dot(ac);
  // Barycentric coordinates of the foot in the plane, times the Gram determinant.
  const double wb = ac_ac * ax_ab - ab_ac * ax_ac;
  const double wc = ab_ab * ax_ac - ab_ac * ax_ab;
  const double gram = ab_ab * ac_ac - ab_ac * ab_ac;
  const double wa = gram - wb - wc;

  ClosestPoint best;
  if (wa >= 0.0 && wb >= 0.0 && wc >= 0.0 && gram > 0.0) {
    best.weights = Vec3(wa, wb, wc) / gram;
    best.point = a + best.weights[1] * ab + best.weights[2] * ac;
    best.distance2 = (x - best.point).squaredNorm();
    return best;
  }
  // Outside: on one of the edges that face x. An obtuse corner can make two of them candidates.
  best.distance2 = std::numeric_limits<double>::infinity();
  const auto keep = [&](const Vec3& weights, const Vec3& point) {
    const double distance2 = (x - point).squaredNorm();
    if (distance2 < best.distance2) best = {point, weights, distance2};
  };
  if (wc < 0.0 || gram <= 0.0) {
    const double s = clamp_to_edge(ax_ab, ab_ab);
    keep(Vec3(1.0 - s, s, 0.0), a + s * ab);
  }
  if (wb < 0.0 || gram <= 0.0) {
    const double s = clamp_to_edge(ax_ac, ac_ac);
    keep(Vec3(1.0 - s, 0.0, s), a + s * ac);
  }
  if (wa < 0.0 || gram <= 0.0) {
    const Vec3 bc = c - b;
    const double s = clamp_to_edge((x - b).dot(bc), bc.dot(bc));
    keep(Vec3(0.0, 1.0 - s, s), b + s * bc);
  }
  return best;
}

}  // namespace hydroscope
