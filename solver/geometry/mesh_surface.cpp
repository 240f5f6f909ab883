// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/mesh_surface.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

constexpr double kEps = 1e-9;        // barycentric: on the border between two prisms
constexpr int kLongestWalk = 16;     // facets
constexpr double kFarReach = 4.0;    // how far to look for a clearance, in reaches
constexpr double kPrismReach = 1.5;  // a prism leans: its height may exceed the distance of its facet

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

MeshSurface::MeshSurface(const TriangleMesh& mesh, const MeshSurfaceOptions& options)
    : topology_(make_topology(mesh)),
      points_(mesh.triangles),
      search_(make_facet_search(mesh, options.search)),
      keeps_facet_normals_(options.normals == NormalRule::facet),
      projection_(options.projection) {
  const double crease_angle = options.crease_angle * std::numbers::pi / 180.0;
  const QuadCover cover = options.quads.empty() ? QuadCover{} : cover_with_quads(mesh, options.quads);
  CornerNormals corners = calc_corner_normals(mesh, topology_, options.normals, crease_angle, cover);
  prisms_.reserve(mesh.triangles.size());
  double area2 = 0.0;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    std::array<Vec3, 3> x, v;
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = mesh.points[at(mesh.triangles[f][k])];
      v[k] = corners.normals[at(corners.corners[f][k])];
    }
    prisms_.push_back(make_prism(x, v));
    require(prisms_.back().area2 > 0.0, "a tool surface needs facets with an area");
    area2 += prisms_.back().area2;
  }
  size_ = (search_->high() - search_->low()).norm();
  floor_ = 1e-3 * std::sqrt(area2 / static_cast<double>(mesh.triangles.size()));
  link_facets(corners);
  mark_seams(mesh);
  if (!cover.quads.empty()) make_quads(mesh, cover, corners);
  if (options.is_smooth && !keeps_facet_normals_ && quads_.empty()) bend_facets();
  display_mesh_.triangles = std::move(corners.corners);
  for (int point : corners.points) display_mesh_.points.push_back(mesh.points[at(point)]);
  normals_ = std::move(corners.normals);
}

void MeshSurface::link_facets(const CornerNormals& corners) {
  const std::size_t count = points_.size();
  next_.assign(count, {-1, -1, -1});
  links_.assign(count, {Link::rim, Link::rim, Link::rim});
  is_tip_.assign(topology_.ring_start.size() - 1, 0);
  for (std::size_t f = 0; f < count; ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const MeshTopology::Side& side = topology_.sides[f][k];
      if (side.facet < 0) continue;
      const std::size_t from = (k + 1) % 3;
      const std::size_t to = (k + 2) % 3;
      const auto& there = corners.corners[at(side.facet)];
      const std::size_t other = at(side.edge);
      const bool is_smooth = !side.is_flipped && corners.corners[f][from] == there[(other + 2) % 3] &&
                             corners.corners[f][to] == there[(other + 1) % 3];
      next_[f][k] = side.facet;
      links_[f][k] = is_smooth ? Link::smooth : Link::crease;
      if (is_smooth) continue;
      if (static_cast<int>(f) < side.facet) ++crease_edges_;
      is_tip_[at(points_[f][from])] = is_tip_[at(points_[f][to])] = 1;
    }
  }
}

void MeshSurface::mark_seams(const TriangleMesh& mesh) {
  // Rims that lie on other facets (T-joints, unwelded seams, edges of three facets): beyond them a
  // prism may go on that the walk cannot reach.
  const double tolerance = 1e-5 * size_;
  for (std::size_t f = 0; f < points_.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (links_[f][k] != Link::rim) continue;
      const Vec3& from = mesh.points[at(points_[f][(k + 1) % 3])];
      const Vec3& to = mesh.points[at(points_[f][(k + 2) % 3])];
      for (double s : {0.07, 0.31, 0.5, 0.69, 0.93}) {
        const Vec3 x = from + s * (to - from);
        search_->visit_within(x, tolerance, [&](int other) {
          if (at(other) == f) return;
          if (search_->calc_distance2(x, other) < tolerance * tolerance) links_[f][k] = Link::seam;
        });
      }
    }
  }
}

void MeshSurface::bend_facets() {
  for (std::size_t f = 0; f < prisms_.size(); ++f) {
    bend_edges(prisms_[f]);
    double rise = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      // Both sides of a crease would curve it in their own ways: it stays straight, and closed.
      if (links_[f][k] == Link::crease) prisms_[f].bend[k] = 0.0;
      rise += 0.25 * std::abs(prisms_[f].bend[k]);
    }
    rise_ = std::max(rise_, rise);
  }
}

ToolEdge MeshSurface::make_edge(int facet, int k) const {
  const Prism& prism = prisms_[at(facet)];
  const int from = (k + 1) % 3;
  const int to = (k + 2) % 3;
  ToolEdge edge;
  edge.start = prism.corner(from);
  edge.end = prism.corner(to);
  edge.start_left = edge.start_right = prism.corner_normal(from);
  edge.end_left = edge.end_right = prism.corner_normal(to);
  const int neighbour = next_[at(facet)][at(k)];
  if (neighbour < 0) {
    edge.bend = prism.bend[at(k)];
    return edge;
  }
  const auto& side = topology_.sides[at(facet)][at(k)];
  const int start = side.is_flipped ? (side.edge + 1) % 3 : (side.edge + 2) % 3;
  const int end = side.is_flipped ? (side.edge + 2) % 3 : (side.edge + 1) % 3;
  edge.start_right = prisms_[at(neighbour)].corner_normal(start);
  edge.end_right = prisms_[at(neighbour)].corner_normal(end);
  return edge;
}

std::optional<FootPoint> MeshSurface::find_foot_point(const Vec3& x, double band, double depth,
                                                      SearchHint& hint) const {
  const double window = std::max(band, depth);
  if (hint.clearance > 0.0 && (x - hint.position).norm() + window < hint.clearance) return std::nullopt;
  const double reach = window + rise_;
  FacetSearch::Nearest best{-1, kFarReach * kFarReach * reach * reach};
  if (hint.facet >= 0 && at(hint.facet) < prisms_.size()) {
    const double distance2 = search_->calc_distance2(x, hint.facet);
    if (distance2 < best.distance2) best = {hint.facet, distance2};
  }
  best = search_->find_nearest(x, best);
  const double distance = std::sqrt(best.distance2);
  hint.position = x;
  hint.clearance = distance - rise_;
  hint.facet = best.facet;
  // A foot point is never nearer than the nearest facet: out of reach is out of the window.
  if (best.facet < 0 || distance > reach) return std::nullopt;
  if (projection_ == Projection::orthogonal) {
    const auto projected = find_orthogonal(x, window);
    if (!projected || projected->gap > band || projected->gap < -depth) return std::nullopt;
    return projected;
  }
  FootPoint foot =
      keeps_facet_normals_ ? locate_facet_normal(x, best.facet) : locate(x, best.facet, distance);
  hint.facet = foot.facet;
  if (foot.gap > band || foot.gap < -depth) return std::nullopt;
  return foot;
}

FootPoint MeshSurface::locate(const Vec3& x, int nearest, double distance) const {
  int facet = nearest;
  int previous = -1;
  for (int step = 0; step < kLongestWalk; ++step) {
    const PrismPoint place = locate_in(facet, x);
    if (!place.is_valid) break;
    if (place.smallest() >= -kEps) return finish_in_prism(x, facet, place);
    // Cross the edge that is missed most; a rim only counts when nothing else is left.
    int crossed = -1;
    for (int k = 0; k < 3; ++k) {
      const int next = next_[at(facet)][at(k)];
      if (place.l(k) >= -kEps || next < 0) continue;
      if (next == previous && links_[at(facet)][at(k)] == Link::smooth) continue;
      if (crossed < 0 || place.l(k) < place.l(crossed)) crossed = k;
    }
    if (crossed < 0) {
      if (const auto foot = find_rim(x, facet, place)) return *foot;
      break;
    }
    const int next = next_[at(facet)][at(crossed)];
    if (next == previous) break;  // between two prisms: the wedge of a crease
    previous = facet;
    facet = next;
  }
  const double radius = kPrismReach * distance + kEps * size_;
  if (const auto foot = find_any_prism(x, radius)) return *foot;
  if (const auto foot = find_any_crease(x, radius)) return *foot;
  return find_any_end(x, nearest, distance, radius);
}

FootPoint MeshSurface::finish_in_prism(const Vec3& x, int facet, const PrismPoint& place) const {
  int owner = facet;
  PrismPoint owner_place = place;
  if (place.smallest() <= kEps) {
    // On the border of several prisms the lowest facet answers, whatever the way that led here.
    for (int k = 0; k < 3; ++k) {
      if (place.l(k) > kEps) continue;
      const int point = points_[at(facet)][at((k + 1) % 3)];
      for (int p : {point, points_[at(facet)][at((k + 2) % 3)]}) {
        for (int i = topology_.ring_start[at(p)]; i < topology_.ring_start[at(p + 1)]; ++i) {
          const int other = topology_.ring[at(i)];
          if (other >= owner) break;
          const PrismPoint there = locate_in(other, x);
          if (!there.is_valid || there.smallest() < -kEps) continue;
          if (std::abs(there.g - place.g) > 1e-6 * size_) continue;
          owner = other;
          owner_place = there;
        }
      }
    }
  }
  FootPoint foot = make_foot(owner, owner_place, x);
  foot.facet = owner;
  return foot;
}

}  // namespace hydroscope
