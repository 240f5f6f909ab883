// SPDX-License-Identifier: GPL-3.0-or-later
// What a facet of a mesh can be: a flat or bent triangle, half of a quadrilateral, with its own or with
// averaged normals, met along its prism or orthogonally.
#include <algorithm>
#include <cmath>

#include "solver/base/error.h"
#include "solver/geometry/mesh_surface.h"

namespace hydroscope {

namespace {

constexpr double kEps = 1e-9;  // barycentric

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Barycentric coordinates in the halves of a quad. Its diagonal runs from corner 0 to 2: one half has
/// corner 1, the other corner 3.
PrismPoint to_half(const QuadHalf& half, const QuadPoint& place) {
  const bool has_1 = half.corner[0] == 1 || half.corner[1] == 1 || half.corner[2] == 1;
  const double far = has_1 ? place.xi : place.eta;
  const double near = has_1 ? place.eta : place.xi;
  const auto weight = [&](int corner) { return corner == 0 ? 1.0 - far : corner == 2 ? near : far - near; };
  return {weight(half.corner[0]), weight(half.corner[1]), place.g, place.is_valid};
}

QuadPoint to_quad(const QuadHalf& half, const PrismPoint& place) {
  double of_0 = 0.0, of_2 = 0.0;
  bool has_1 = false;
  for (int k = 0; k < 3; ++k) {
    if (half.corner[at(k)] == 0) of_0 = place.l(k);
    if (half.corner[at(k)] == 2) of_2 = place.l(k);
    has_1 = has_1 || half.corner[at(k)] == 1;
  }
  return {has_1 ? 1.0 - of_0 : of_2, has_1 ? of_2 : 1.0 - of_0, place.g, place.is_valid};
}

/// Where `x` projects along the normal of a flat facet.
struct PlanePoint {
  double l1, l2, height;

  PlanePoint(const Prism& prism, const Vec3& x) {
    const Vec3 from_x3 = x - prism.x3;
    l1 = from_x3.dot(prism.e2.cross(prism.normal)) / prism.area2;
    l2 = from_x3.dot(prism.normal.cross(prism.e1)) / prism.area2;
    height = prism.normal.dot(from_x3);
  }
  bool is_inside() const { return std::min(std::min(l1, l2), 1.0 - l1 - l2) >= -kEps; }
};

FootPoint make_plane_foot(const Prism& prism, const PlanePoint& place) {
  const Vec3 m = prism.v3 + place.l1 * prism.d1 + place.l2 * prism.d2;
  FootPoint foot;
  foot.point = prism.x3 + place.l1 * prism.e1 + place.l2 * prism.e2;
  foot.normal = m.normalized();  // (4.2)
  foot.gap = place.height;
  foot.gap_gradient = prism.normal;
  const Mat3 dm_dx = (prism.d1 * prism.e2.cross(prism.normal).transpose() +
                      prism.d2 * prism.normal.cross(prism.e1).transpose()) /
                     prism.area2;  // (4.41)-(4.44)
  foot.normal_gradient = (dm_dx - foot.normal * (foot.normal.transpose() * dm_dx)) / m.norm();
  return foot;
}

}  // namespace

Projection parse_projection(const std::string& name) {
  if (name == "prism") return Projection::prism;
  if (name == "orthogonal") return Projection::orthogonal;
  throw InputError("projection = \"" + name + "\": expected prism or orthogonal");
}

void MeshSurface::make_quads(const TriangleMesh& mesh, const QuadCover& cover, const CornerNormals& corners) {
  halves_ = cover.halves;
  std::vector<std::array<Vec3, 4>> normals(cover.quads.size());
  for (std::size_t f = 0; f < halves_.size(); ++f) {
    if (halves_[f].quad < 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      normals[at(halves_[f].quad)][at(halves_[f].corner[k])] = corners.normals[at(corners.corners[f][k])];
    }
  }
  for (std::size_t q = 0; q < cover.quads.size(); ++q) {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < 4; ++k) x[k] = mesh.points[at(cover.quads[q][k])];
    quads_.push_back(make_quad_prism(x, normals[q]));
  }
}

PrismPoint MeshSurface::locate_in(int facet, const Vec3& x) const {
  if (!is_half_quad(facet)) return locate_in_prism(prisms_[at(facet)], x);
  const QuadHalf& half = halves_[at(facet)];
  return to_half(half, locate_in_quad(quads_[at(half.quad)], x));
}

FootPoint MeshSurface::make_foot(int facet, const PrismPoint& place, const Vec3& x) const {
  if (!is_half_quad(facet)) return make_foot_point(prisms_[at(facet)], place, x);
  const QuadHalf& half = halves_[at(facet)];
  return make_foot_point(quads_[at(half.quad)], to_quad(half, place), x);
}

FootPoint MeshSurface::locate_quad_normal(const Vec3& x, int nearest) const {
  const QuadPrism& quad = quads_[at(halves_[at(nearest)].quad)];
  const QuadPoint place = locate_in_quad(quad, x);
  const auto is_in = [](double s) { return s >= -kEps && s <= 1.0 + kEps; };
  FootPoint foot;
  if (place.is_valid && is_in(place.xi) && is_in(place.eta)) {
    foot = make_foot_point(quad, place, x);
  } else {
    const Prism& prism = prisms_[at(nearest)];
    const ClosestPoint closest = find_closest_point(x, prism.corner(0), prism.corner(1), prism.corner(2));
    const QuadPoint clamped =
        to_quad(halves_[at(nearest)], {closest.weights[0], closest.weights[1], 0.0, true});
    foot = make_fixed_foot(quad, clamped.xi, clamped.eta, x);
    for (int k = 0; k < 3; ++k) {
      if (closest.weights[k] > 0.0 || next_[at(nearest)][at(k)] >= 0) continue;
      foot.beyond_edge = (x - foot.point - foot.gap * foot.normal).norm();
    }
  }
  foot.facet = nearest;
  return foot;
}

std::optional<FootPoint> MeshSurface::find_orthogonal(const Vec3& x, double window) const {
  std::optional<FootPoint> best;
  search_->visit_within(x, window, [&](int f) {
    const PlanePoint place(prisms_[at(f)], x);
    if (!place.is_inside() || std::abs(place.height) > window) return;
    if (best) {
      const double nearer = std::abs(place.height) - std::abs(best->gap);
      if (nearer > 0.0 || (nearer == 0.0 && f > best->facet)) return;
    }
    best = make_plane_foot(prisms_[at(f)], place);
    best->facet = f;
  });
  return best;
}

std::vector<int> MeshSurface::list_projections_at(const Vec3& x, double reach) const {
  std::vector<int> facets;
  for (int f = 0; f < static_cast<int>(prisms_.size()); ++f) {
    const PlanePoint place(prisms_[at(f)], x);
    if (place.is_inside() && std::abs(place.height) <= reach) facets.push_back(f);
  }
  return facets;
}

FootPoint MeshSurface::locate_facet_normal(const Vec3& x, int nearest) const {
  if (is_half_quad(nearest)) return locate_quad_normal(x, nearest);
  const Prism& prism = prisms_[at(nearest)];
  const ClosestPoint closest = find_closest_point(x, prism.corner(0), prism.corner(1), prism.corner(2));
  FootPoint foot;
  foot.point = closest.point;
  foot.normal = foot.gap_gradient = prism.normal;  // (4.1): jumps from facet to facet
  foot.gap = prism.normal.dot(x - closest.point);
  foot.facet = nearest;
  for (int k = 0; k < 3; ++k) {
    const bool is_on_edge = closest.weights[k] <= 0.0;
    if (!is_on_edge || next_[at(nearest)][at(k)] >= 0) continue;
    foot.beyond_edge = (x - closest.point - foot.gap * foot.normal).norm();
  }
  return foot;
}

std::vector<int> MeshSurface::list_prisms_at(const Vec3& x, double reach) const {
  std::vector<int> facets;
  for (int f = 0; f < static_cast<int>(prisms_.size()); ++f) {
    const PrismPoint place = locate_in(f, x);
    if (place.is_valid && place.smallest() >= -kEps && std::abs(place.g) <= reach) facets.push_back(f);
  }
  return facets;
}

}  // namespace hydroscope
