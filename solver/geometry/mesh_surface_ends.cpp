// SPDX-License-Identifier: GPL-3.0-or-later
// Where the prisms of a mesh end: open rims, creases and tips.
#include <cmath>

#include "solver/geometry/mesh_surface.h"

namespace hydroscope {

namespace {

constexpr double kEps = 1e-9;        // barycentric
constexpr int kLongestRimWalk = 64;  // edges

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

std::array<int, 2> MeshSurface::step_along_rim(int facet, int k, int direction) const {
  // Turn around the common point from facet to facet until the next rim.
  int f = facet;
  int edge = k;
  for (int i = 0; i < kLongestRimWalk; ++i) {
    edge = direction > 0 ? (edge + 1) % 3 : (edge + 2) % 3;
    const int next = next_[at(f)][at(edge)];
    if (next < 0) return {f, edge};
    const auto& side = topology_.sides[at(f)][at(edge)];
    if (side.is_flipped) break;
    edge = side.edge;
    f = next;
  }
  return {-1, -1};
}

FootPoint MeshSurface::follow_rim(const Vec3& x, int facet, int k) const {
  RimFoot here = find_rim_foot(make_edge(facet, k), x);
  here.foot.facet = facet;
  for (int i = 0; i < kLongestRimWalk && here.end != 0; ++i) {
    const auto [f, edge] = step_along_rim(facet, k, here.end);
    if (f < 0) break;
    RimFoot there = find_rim_foot(make_edge(f, edge), x);
    there.foot.facet = f;
    // Before its start as well: the common point of both edges is the foot.
    if (there.end == -here.end) return here.foot.facet <= f ? here.foot : there.foot;
    here = there;
    facet = f;
    k = edge;
  }
  return here.foot;
}

std::optional<FootPoint> MeshSurface::find_rim(const Vec3& x, int facet, const PrismPoint& place) const {
  int edge = -1;
  double best = 0.0;
  for (int k = 0; k < 3; ++k) {
    if (place.l(k) >= -kEps || next_[at(facet)][at(k)] >= 0) continue;
    if (links_[at(facet)][at(k)] == Link::seam) return std::nullopt;
    const double distance = (x - find_rim_foot(make_edge(facet, k), x).foot.point).norm();
    if (edge >= 0 && distance >= best) continue;
    edge = k;
    best = distance;
  }
  if (edge < 0) return std::nullopt;
  return follow_rim(x, facet, edge);
}

std::optional<FootPoint> MeshSurface::find_any_prism(const Vec3& x, double radius) const {
  int facet = -1;
  PrismPoint best;
  search_->visit_within(x, radius, [&](int f) {
    const PrismPoint place = locate_in(f, x);
    if (!place.is_valid || place.smallest() < -kEps || std::abs(place.g) > radius) return;
    const double nearer = std::abs(place.g) - std::abs(best.g);
    if (facet >= 0 && (nearer > 0.0 || (nearer == 0.0 && f > facet))) return;
    facet = f;
    best = place;
  });
  if (facet < 0) return std::nullopt;
  return finish_in_prism(x, facet, best);
}

std::optional<FootPoint> MeshSurface::find_any_crease(const Vec3& x, double radius) const {
  std::optional<FootPoint> best;
  search_->visit_within(x, radius, [&](int f) {
    for (int k = 0; k < 3; ++k) {
      if (links_[at(f)][at(k)] != Link::crease || next_[at(f)][at(k)] < f) continue;
      auto foot = find_crease_foot(make_edge(f, k), x, floor_);
      if (!foot || std::abs(foot->gap) > radius) continue;
      foot->facet = f;
      if (best) {
        const double nearer = std::abs(foot->gap) - std::abs(best->gap);
        if (nearer > 0.0 || (nearer == 0.0 && f > best->facet)) continue;
      }
      best = foot;
    }
  });
  return best;
}

FootPoint MeshSurface::find_any_end(const Vec3& x, int nearest, double distance, double radius) const {
  std::optional<FootPoint> best;
  double best_distance = 1.2 * distance + kEps * size_;
  const auto keep = [&](const FootPoint& foot) {
    const double d = (x - foot.point).norm();
    if (d > best_distance || (best && d == best_distance && foot.facet >= best->facet)) return;
    best = foot;
    best_distance = d;
  };
  search_->visit_within(x, radius, [&](int f) {
    const Prism& prism = prisms_[at(f)];
    for (int k = 0; k < 3; ++k) {
      if (next_[at(f)][at(k)] < 0) keep(follow_rim(x, f, k));
      if (is_tip_[at(points_[at(f)][at(k)])] == 0) continue;
      FootPoint tip = find_tip_foot(prism.corner(k), prism.corner_normal(k), x, floor_);
      tip.facet = f;
      keep(tip);
    }
  });
  if (best) return *best;
  // Node normals too crooked for their facets: the closest point still answers.
  const Prism& prism = prisms_[at(nearest)];
  const ClosestPoint closest = find_closest_point(x, prism.corner(0), prism.corner(1), prism.corner(2));
  FootPoint foot;
  foot.point = closest.point;
  foot.normal = foot.gap_gradient =
      (prism.v3 + closest.weights[0] * prism.d1 + closest.weights[1] * prism.d2).normalized();
  foot.gap = foot.normal.dot(x - closest.point);
  foot.facet = nearest;
  return foot;
}

}  // namespace hydroscope
