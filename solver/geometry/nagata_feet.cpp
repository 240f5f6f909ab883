// SPDX-License-Identifier: GPL-3.0-or-later
// Foot points on Nagata patches: within a patch, on an edge between two, on an open rim, in a corner.
#include <cmath>

#include "solver/geometry/nagata_surface.h"

namespace hydroscope {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Foot at `point` where the surface's normal is not one: it points to `x`, or along `mean` when `x` is
/// nearer than `floor` [mm].
FootPoint make_radial(const Vec3& x, const Vec3& point, const Vec3& mean, double floor) {
  const Vec3 offset = x - point;
  const double distance = offset.norm();
  const double sign = offset.dot(mean) < 0.0 ? -1.0 : 1.0;
  FootPoint foot;
  foot.point = point;
  foot.gap = sign * distance;
  foot.normal = distance > floor ? Vec3(sign * offset / distance) : mean;
  foot.gap_gradient = foot.normal;
  return foot;
}

/// Curvature around a crease that turns the normal like a fillet of no radius, but no smaller than `floor`;
/// along it the foot moves by `point_rate` dx.
void set_crease_curvature(const Mat3& point_rate, double floor, FootPoint& foot) {
  const Mat3 rate = Mat3::Identity() - point_rate;
  const double sign = foot.gap < 0.0 ? -1.0 : 1.0;
  foot.normal_gradient =
      sign * (rate - foot.normal * (foot.normal.transpose() * rate)) / std::max(std::abs(foot.gap), floor);
}

/// The surface's own curvature in the plane of a normal that leans a little against it.
void set_smooth_curvature(const Mat3& gradient, FootPoint& foot) {
  const Mat3 tangent_plane = Mat3::Identity() - foot.normal * foot.normal.transpose();
  foot.normal_gradient = tangent_plane * gradient * tangent_plane;
}

}  // namespace

FootPoint NagataSurface::make_inner_foot(const Vec3& x, int facet, const PatchFoot& at_foot) const {
  const PatchPlace place = place_on_patch(facet, at_foot.l1, at_foot.l2);
  FootPoint foot;
  foot.point = place.point;
  foot.normal = foot.gap_gradient = place.normal;
  foot.gap = place.normal.dot(x - place.point);
  foot.normal_gradient = place.calc_normal_gradient(foot.gap);
  return foot;
}

FootPoint NagataSurface::make_edge_foot(const Vec3& x, int facet, const PatchFoot& at_foot) const {
  const int k = at_foot.edge;
  const double s = read_edge_parameter(k, at_foot.l1, at_foot.l2);
  if (links_[at(facet)][at(k)] == Link::rim) return make_rim_foot(x, facet, k, s);
  const MeshTopology::Side& side = topology_.sides[at(facet)][at(k)];
  const auto l = place_on_edge(side.edge, side.is_flipped ? s : 1.0 - s);
  const PatchPlace here = place_on_patch(facet, at_foot.l1, at_foot.l2);
  const PatchPlace there = place_on_patch(side.facet, l[0], l[1]);
  FootPoint foot = make_radial(x, here.point, (here.normal + there.normal).normalized(), floor_);
  if (links_[at(facet)][at(k)] == Link::smooth) {
    set_smooth_curvature(0.5 * (here.calc_normal_gradient(foot.gap) + there.calc_normal_gradient(foot.gap)),
                         foot);
    return foot;
  }
  const PatchEdge edge(patches_[at(facet)], k, s);
  const double slope = edge.tangent.squaredNorm() - (x - edge.point).dot(edge.second);
  set_crease_curvature(edge.tangent * edge.tangent.transpose() / slope, floor_, foot);
  return foot;
}

FootPoint NagataSurface::make_rim_foot(const Vec3& x, int facet, int k, double s) const {
  const PatchEdge edge(patches_[at(facet)], k, s);
  const auto l = place_on_edge(k, s);
  const PatchPlace place = place_on_patch(facet, l[0], l[1]);
  const Vec3 offset = x - place.point;
  FootPoint foot;
  foot.point = place.point;
  foot.normal = place.normal;
  foot.gap = place.normal.dot(offset);
  foot.beyond_edge = (offset - foot.gap * foot.normal).norm();
  // The normal changes along the rim only; (x - C) . dC/ds = 0 says how fast the foot moves there.
  const double slope = edge.tangent.squaredNorm() - offset.dot(edge.second);
  const Vec3 ds_dx = edge.tangent / slope;
  const Vec3 turn = place.calc_normal_gradient(0.0) * edge.tangent;  // dn/ds
  foot.normal_gradient = turn * ds_dx.transpose();
  foot.gap_gradient = foot.normal + turn.dot(offset) * ds_dx;
  return foot;
}

FootPoint NagataSurface::make_corner_foot(const Vec3& x, int facet, int corner) const {
  const int point = points_[at(facet)][at(corner)];
  Vec3 sum = Vec3::Zero();
  Mat3 curvature = Mat3::Zero();
  bool is_rim = false, is_crease = false;
  const int first = topology_.ring_start[at(point)], last = topology_.ring_start[at(point + 1)];
  const double gap = (x - patches_[at(facet)].x[at(corner)]).dot(corner_normal(facet, corner));
  for (int i = first; i < last; ++i) {
    const int f = topology_.ring[at(i)];
    int k = 0;
    while (points_[at(f)][at(k)] != point) ++k;
    const PatchPlace place = place_on_patch(f, k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0);
    sum += place.normal;
    curvature += place.calc_normal_gradient(gap) / (last - first);
    for (int edge : {(k + 1) % 3, (k + 2) % 3}) {
      is_rim = is_rim || links_[at(f)][at(edge)] == Link::rim;
      is_crease = is_crease || links_[at(f)][at(edge)] == Link::crease;
    }
  }
  const Vec3 mean = sum.norm() > 0.0 ? Vec3(sum.normalized()) : corner_normal(facet, corner);
  const Vec3& place = patches_[at(facet)].x[at(corner)];
  if (is_rim) {
    FootPoint foot;
    foot.point = place;
    foot.normal = foot.gap_gradient = is_crease ? mean : corner_normal(facet, corner);
    foot.gap = foot.normal.dot(x - place);
    foot.beyond_edge = (x - place - foot.gap * foot.normal).norm();
    return foot;
  }
  FootPoint foot = make_radial(x, place, mean, floor_);
  if (is_crease) {
    set_crease_curvature(Mat3::Zero(), floor_, foot);
  } else {
    set_smooth_curvature(curvature, foot);
  }
  return foot;
}

}  // namespace hydroscope
