// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/nagata_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

constexpr double kFarReach = 4.0;  // how far to look for a clearance, in reaches
constexpr double kSlack = 1e-9;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

NagataSurface::NagataSurface(const TriangleMesh& mesh, const NagataSurfaceOptions& options)
    : topology_(make_topology(mesh)),
      points_(mesh.triangles),
      search_(make_facet_search(mesh, options.search)) {
  require(options.normals != NormalRule::facet, "Nagata patches need averaged normals");
  const double crease_angle = options.crease_angle * std::numbers::pi / 180.0;
  CornerNormals corners = calc_corner_normals(mesh, topology_, options.normals, crease_angle);
  link_facets(corners);
  display_mesh_.triangles = std::move(corners.corners);
  for (int point : corners.points) display_mesh_.points.push_back(mesh.points[at(point)]);
  normals_ = std::move(corners.normals);
  double area2 = 0.0;
  for (const auto& t : mesh.triangles) {
    const NagataPatch flat{{mesh.points[at(t[0])], mesh.points[at(t[1])], mesh.points[at(t[2])]},
                           {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}};
    const double facet_area2 = (flat.x[1] - flat.x[0]).cross(flat.x[2] - flat.x[0]).norm();
    require(facet_area2 > 0.0, "a tool surface needs facets with an area");
    area2 += facet_area2;
    patches_.push_back(flat);
  }
  floor_ = 1e-3 * std::sqrt(area2 / static_cast<double>(patches_.size()));
  bend_patches();
}

const Vec3& NagataSurface::corner_normal(int facet, int k) const {
  return normals_[at(display_mesh_.triangles[at(facet)][at(k)])];
}

void NagataSurface::link_facets(const CornerNormals& corners) {
  links_.assign(points_.size(), {Link::rim, Link::rim, Link::rim});
  for (std::size_t f = 0; f < points_.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const MeshTopology::Side& side = topology_.sides[f][k];
      if (side.facet < 0) continue;
      const auto& there = corners.corners[at(side.facet)];
      const bool is_smooth = !side.is_flipped &&
                             corners.corners[f][(k + 1) % 3] == there[at((side.edge + 2) % 3)] &&
                             corners.corners[f][(k + 2) % 3] == there[at((side.edge + 1) % 3)];
      links_[f][k] = is_smooth ? Link::smooth : Link::crease;
      if (!is_smooth && static_cast<int>(f) < side.facet) ++crease_edges_;
    }
  }
}

void NagataSurface::bend_patches() {
  rise_.resize(patches_.size());
  for (int f = 0; f < static_cast<int>(patches_.size()); ++f) {
    NagataPatch& patch = patches_[at(f)];
    for (int k = 0; k < 3; ++k) {
      const int from = (k + 1) % 3, to = (k + 2) % 3;
      const Vec3 chord = patch.x[at(to)] - patch.x[at(from)];
      const Vec3& n0 = corner_normal(f, from);
      const Vec3& n1 = corner_normal(f, to);
      if (links_[at(f)][at(k)] != Link::crease) {
        patch.bend[at(k)] = calc_edge_bend(chord, n0, n1);
        continue;
      }
      const MeshTopology::Side& side = topology_.sides[at(f)][at(k)];
      if (side.is_flipped) continue;  // no free side: stays straight
      patch.bend[at(k)] = calc_crease_bend(chord, {n0, corner_normal(side.facet, (side.edge + 2) % 3)},
                                           {n1, corner_normal(side.facet, (side.edge + 1) % 3)});
    }
    rise_[at(f)] = patch.calc_rise();
    largest_rise_ = std::max(largest_rise_, rise_[at(f)]);
  }
}

std::optional<FootPoint> NagataSurface::find_foot_point(const Vec3& x, double band, double depth,
                                                        SearchHint& hint) const {
  const double window = std::max(band, depth);
  if (hint.clearance > 0.0 && (x - hint.position).norm() + window < hint.clearance) return std::nullopt;
  const double reach = window + largest_rise_;
  FacetSearch::Nearest best{-1, kFarReach * kFarReach * reach * reach};
  if (hint.facet >= 0 && at(hint.facet) < patches_.size()) {
    const double distance2 = search_->calc_distance2(x, hint.facet);
    if (distance2 < best.distance2) best = {hint.facet, distance2};
  }
  best = search_->find_nearest(x, best);
  const double distance = std::sqrt(best.distance2);
  hint.position = x;
  hint.clearance = distance - largest_rise_;
  hint.facet = best.facet;
  if (best.facet < 0 || !(distance <= reach)) return std::nullopt;
  const FootPoint foot = locate(x, best.facet, distance);
  hint.facet = foot.facet;
  if (foot.gap > band || foot.gap < -depth) return std::nullopt;
  return foot;
}

FootPoint NagataSurface::locate(const Vec3& x, int nearest, double distance) const {
  // The nearest patch lies no farther than the nearest facet and its rise; each facet no nearer than
  // its patch less its own. Boxes, facets and patches round differently.
  const double bound = distance * (1.0 + kSlack) + rise_[at(nearest)] + kSlack * floor_;
  int facet = -1;
  PatchFoot best;
  search_->visit_within(x, bound + largest_rise_, [&](int f) {
    const auto& t = patches_[at(f)].x;
    const ClosestPoint flat = find_closest_point(x, t[0], t[1], t[2]);
    if (std::sqrt(flat.distance2) > bound + rise_[at(f)]) return;
    const PatchFoot foot = find_closest_on_patch(patches_[at(f)], x, flat.weights[0], flat.weights[1]);
    if (facet >= 0 && (foot.distance2 > best.distance2 || (foot.distance2 == best.distance2 && f > facet)))
      return;
    facet = f;
    best = foot;
  });
  FootPoint foot = best.corner >= 0 ? make_corner_foot(x, facet, best.corner)
                   : best.edge >= 0 ? make_edge_foot(x, facet, best)
                                    : make_inner_foot(x, facet, best);
  foot.facet = facet;
  return foot;
}

}  // namespace hydroscope
