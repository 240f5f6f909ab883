// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/vertex_normals.h"

#include <algorithm>
#include <cmath>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// What corner `k` of a facet adds to the normal of its node.
Vec3 calc_share(const TriangleMesh& mesh, int facet, int k, NormalRule rule) {
  const auto& t = mesh.triangles[at(facet)];
  const Vec3& origin = mesh.points[at(t[at(k)])];
  const Vec3 e1 = mesh.points[at(t[at((k + 1) % 3)])] - origin;
  const Vec3 e2 = mesh.points[at(t[at((k + 2) % 3)])] - origin;
  if (rule == NormalRule::area) return 0.5 * e1.cross(e2);  // (4.4), to the last bit the same for all corners
  return weigh_corner(e1, e2, 0.0, rule);
}

/// The same of the quad that the facet is half of. Where both halves meet, each adds a half of it.
Vec3 calc_quad_share(const TriangleMesh& mesh, const QuadCover& cover, int facet, int k, NormalRule rule) {
  const QuadHalf& half = cover.halves[at(facet)];
  const auto& quad = cover.quads[at(half.quad)];
  const auto x = [&](int corner) { return mesh.points[at(quad[at(corner % 4)])]; };
  const int corner = half.corner[at(k)];
  const double area = 0.5 * (x(2) - x(0)).cross(x(3) - x(1)).norm();
  const Vec3 share = weigh_corner(x(corner + 1) - x(corner), x(corner + 3) - x(corner), area, rule);
  return corner % 2 == 0 ? Vec3(0.5 * share) : share;
}

int find_corner(const TriangleMesh& mesh, int facet, int point) {
  const auto& t = mesh.triangles[at(facet)];
  return static_cast<int>(std::find(t.begin(), t.end(), point) - t.begin());
}

/// Gathers what is needed to walk around a node.
struct Fan {
  const TriangleMesh& mesh;
  const MeshTopology& topology;
  const std::vector<Vec3>& facet_normals;
  NormalRule rule;
  double crease_angle;
  const QuadCover& cover;

  bool is_half(int facet) const { return !cover.halves.empty() && cover.halves[at(facet)].quad >= 0; }
  bool is_joined(int facet, int edge) const {
    if (is_half(facet) && cover.halves[at(facet)].corner[at(edge)] % 2 == 1) return true;  // the diagonal
    return rule != NormalRule::facet && topology.sides[at(facet)][at(edge)].facet >= 0 &&
           !is_crease(topology, facet_normals, facet, edge, crease_angle);
  }
};

/// Gives all facets reached from `seed` around `point` without crossing a crease the same normal.
void spread_normal(const Fan& fan, int seed, int point, CornerNormals& result) {
  const int id = static_cast<int>(result.normals.size());
  std::vector<int> group{seed};
  result.corners[at(seed)][at(find_corner(fan.mesh, seed, point))] = id;
  for (std::size_t i = 0; i < group.size(); ++i) {
    const int corner = find_corner(fan.mesh, group[i], point);
    for (int edge : {(corner + 1) % 3, (corner + 2) % 3}) {
      if (!fan.is_joined(group[i], edge)) continue;
      const int next = fan.topology.sides[at(group[i])][at(edge)].facet;
      int& slot = result.corners[at(next)][at(find_corner(fan.mesh, next, point))];
      if (slot >= 0) continue;
      slot = id;
      group.push_back(next);
    }
  }
  std::sort(group.begin(), group.end());  // the sum must not depend on the way around
  Vec3 sum = Vec3::Zero();
  for (int f : group) {
    const int k = find_corner(fan.mesh, f, point);
    sum += fan.is_half(f) ? calc_quad_share(fan.mesh, fan.cover, f, k, fan.rule)
                          : calc_share(fan.mesh, f, k, fan.rule);
  }
  const double size = sum.norm();
  result.normals.push_back(size > 0.0 ? Vec3(sum / size) : fan.facet_normals[at(seed)]);
  result.points.push_back(point);
}

}  // namespace

Vec3 weigh_corner(const Vec3& e1, const Vec3& e2, double area, NormalRule rule) {
  const Vec3 cross = e1.cross(e2);
  const double size = cross.norm();
  switch (rule) {
    case NormalRule::facet:
    case NormalRule::plain:
      return cross / size;  // (4.3)
    case NormalRule::area:
      return area * cross / size;  // (4.4)
    case NormalRule::angle:
      return std::atan2(size, e1.dot(e2)) * cross / size;
    case NormalRule::max:
      return cross / (e1.squaredNorm() * e2.squaredNorm());
  }
  return cross;
}

NormalRule parse_normal_rule(const std::string& name) {
  if (name == "facet") return NormalRule::facet;
  if (name == "plain") return NormalRule::plain;
  if (name == "area") return NormalRule::area;
  if (name == "angle") return NormalRule::angle;
  if (name == "max") return NormalRule::max;
  throw InputError("normals = \"" + name + "\": expected facet, plain, area, angle or max");
}

bool is_crease(const MeshTopology& topology, const std::vector<Vec3>& facet_normals, int facet, int edge,
               double crease_angle) {
  const MeshTopology::Side& side = topology.sides[at(facet)][at(edge)];
  if (side.facet < 0) return false;
  if (side.is_flipped) return true;
  const Vec3& a = facet_normals[at(facet)];
  const Vec3& b = facet_normals[at(side.facet)];
  return std::atan2(a.cross(b).norm(), a.dot(b)) > crease_angle;
}

CornerNormals calc_corner_normals(const TriangleMesh& mesh, const MeshTopology& topology, NormalRule rule,
                                  double crease_angle, const QuadCover& cover) {
  const std::vector<Vec3> facet_normals = calc_facet_normals(mesh);
  const Fan fan{mesh, topology, facet_normals, rule, crease_angle, cover};
  CornerNormals result;
  result.corners.assign(mesh.triangles.size(), {-1, -1, -1});
  for (int point = 0; point < static_cast<int>(mesh.points.size()); ++point) {
    for (int i = topology.ring_start[at(point)]; i < topology.ring_start[at(point + 1)]; ++i) {
      const int facet = topology.ring[at(i)];
      if (result.corners[at(facet)][at(find_corner(mesh, facet, point))] < 0) {
        spread_normal(fan, facet, point, result);
      }
    }
  }
  return result;
}

}  // namespace hydroscope
