// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/edge_foot.h"

#include <algorithm>
#include <cmath>

namespace hydroscope {

namespace {

constexpr int kIterations = 60;
constexpr double kEps = 1e-9;

/// The wedge plane of a crease at parameter s: spanned by both normals, and its change.
struct WedgePlane {
  Vec3 left, right, normal, normal_rate;

  WedgePlane(const ToolEdge& edge, double s) {
    const Vec3 left_rate = edge.end_left - edge.start_left;
    const Vec3 right_rate = edge.end_right - edge.start_right;
    left = edge.start_left + s * left_rate;
    right = edge.start_right + s * right_rate;
    normal = left.cross(right);
    normal_rate = left_rate.cross(right) + left.cross(right_rate);
  }
};

/// How far `x` lies off the wedge plane at s; zero at the foot.
double calc_wedge_rest(const ToolEdge& edge, const Vec3& x, double s) {
  const WedgePlane plane(edge, s);
  return (x - edge.start - s * (edge.end - edge.start)).dot(plane.normal);
}

/// Bisection between signs, quickened by the secant: the rest is a cubic in s.
std::optional<double> find_wedge_parameter(const ToolEdge& edge, const Vec3& x) {
  double low = -kEps;
  double high = 1.0 + kEps;
  double at_low = calc_wedge_rest(edge, x, low);
  double at_high = calc_wedge_rest(edge, x, high);
  if (!(at_low * at_high <= 0.0) || at_low == at_high) return std::nullopt;
  for (int i = 0; i < kIterations && high - low > 1e-15; ++i) {
    double s = low - at_low * (high - low) / (at_high - at_low);
    if (i % 3 == 2 || !(s > low && s < high)) s = 0.5 * (low + high);
    const double rest = calc_wedge_rest(edge, x, s);
    if (rest == 0.0) return s;
    if ((rest < 0.0) == (at_low < 0.0)) {
      low = s;
      at_low = rest;
    } else {
      high = s;
      at_high = rest;
    }
  }
  return std::abs(at_low) < std::abs(at_high) ? low : high;
}

/// Foot point at distance `offset` from a point that moves by `point_rate` dx over the tool.
FootPoint make_radial_foot(const Vec3& point, const Vec3& offset, double sign, const Mat3& point_rate,
                           double floor) {
  const double distance = offset.norm();
  FootPoint foot;
  foot.point = point;
  foot.normal = sign * offset / distance;
  foot.gap = sign * distance;
  const Mat3 rate = Mat3::Identity() - point_rate;
  foot.gap_gradient = rate.transpose() * foot.normal;
  foot.normal_gradient =
      sign * (rate - foot.normal * (foot.normal.transpose() * rate)) / std::max(distance, floor);
  return foot;
}

}  // namespace

std::optional<FootPoint> find_crease_foot(const ToolEdge& edge, const Vec3& x, double floor) {
  const std::optional<double> s = find_wedge_parameter(edge, x);
  if (!s) return std::nullopt;
  const WedgePlane plane(edge, *s);
  const Vec3 along = edge.end - edge.start;
  const double wedge2 = plane.normal.squaredNorm();
  if (!(wedge2 > kEps * kEps)) return std::nullopt;
  const Vec3 point = edge.start + *s * along;
  const Vec3 offset = x - point;
  const double from_left = offset.cross(plane.right).dot(plane.normal) / wedge2;
  const double from_right = plane.left.cross(offset).dot(plane.normal) / wedge2;
  // A ridge opens its wedge on the free side, a groove behind the surface.
  const double sign = plane.normal.dot(along) > 0.0 ? 1.0 : -1.0;
  const double tolerance = -kEps * offset.norm();
  if (sign * from_left < tolerance || sign * from_right < tolerance) return std::nullopt;
  if (!(offset.norm() > 0.0)) return std::nullopt;
  const double slope = -along.dot(plane.normal) + offset.dot(plane.normal_rate);
  const Vec3 ds_dx = -plane.normal / slope;
  return make_radial_foot(point, offset, sign, along * ds_dx.transpose(), floor);
}

FootPoint find_tip_foot(const Vec3& corner, const Vec3& normal, const Vec3& x, double floor) {
  const Vec3 offset = x - corner;
  if (!(offset.norm() > 0.0)) {
    FootPoint foot;
    foot.point = corner;
    foot.normal = foot.gap_gradient = normal.normalized();
    return foot;
  }
  return make_radial_foot(corner, offset, offset.dot(normal) < 0.0 ? -1.0 : 1.0, Mat3::Zero(), floor);
}

RimFoot find_rim_foot(const ToolEdge& edge, const Vec3& x) {
  const Vec3 along = edge.end - edge.start;
  const Vec3 turn = edge.end_left - edge.start_left;
  double s = std::clamp((x - edge.start).dot(along) / along.squaredNorm(), 0.0, 1.0);
  Vec3 ds_dx = Vec3::Zero();
  int end = 0;
  // The foot lies where the rest x - X(s) has no part along the edge in the surface: there the
  // rim continues the outer face of its prism without a step.
  for (int i = 0; i < 12; ++i) {
    const Vec3 v = edge.start_left + s * turn;
    const double v2 = v.squaredNorm();
    const double lean = along.dot(v) / v2;
    const Vec3 c = along - lean * v;
    const double lean_rate = along.dot(turn) / v2 - 2.0 * lean * v.dot(turn) / v2;
    const Vec3 offset = x - edge.start - s * along;
    const double slope = -along.dot(c) - offset.dot(lean_rate * v + lean * turn);
    const double step = -offset.dot(c) / slope;
    ds_dx = -c / slope;
    const double next = std::clamp(s + step, 0.0, 1.0);
    end = s + step > 1.0 ? 1 : s + step < 0.0 ? -1 : 0;
    const bool is_done = std::abs(next - s) < 1e-14;
    s = next;
    if (is_done) break;
  }
  if (end != 0) ds_dx.setZero();
  const Vec3 m = edge.start_left + s * turn;
  FootPoint foot;
  foot.point = edge.start + s * along;
  foot.normal = m.normalized();
  const Vec3 offset = x - foot.point;
  foot.gap = foot.normal.dot(offset);
  foot.beyond_edge = (offset - foot.gap * foot.normal).norm();
  const Vec3 n_rate = (turn - foot.normal * foot.normal.dot(turn)) / m.norm();  // dn/ds
  foot.normal_gradient = n_rate * ds_dx.transpose();
  foot.gap_gradient = foot.normal + (n_rate.dot(offset) - foot.normal.dot(along)) * ds_dx;
  const double sink = edge.bend * s * (1.0 - s);  // the rim of a smooth facet is curved
  foot.gap += sink;
  foot.point -= sink * foot.normal;
  foot.gap_gradient += edge.bend * (1.0 - 2.0 * s) * ds_dx;
  return {foot, end};
}

}  // namespace hydroscope
