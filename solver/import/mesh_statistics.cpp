// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/mesh_statistics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "solver/geometry/mesh_topology.h"
#include "solver/geometry/triangle_tree.h"

namespace hydroscope {

namespace {

constexpr double kSliver = 50.0;
constexpr double kBent = 0.2;  // [deg]: flatter edges are flat, bent by single precision only
constexpr double kDegree = std::numbers::pi / 180.0;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

const Vec3& corner(const TriangleMesh& mesh, int f, int k) {
  return mesh.points[at(mesh.triangles[at(f)][at(k % 3)])];
}

double calc_area(const TriangleMesh& mesh, int f) {
  return 0.5 *
         (corner(mesh, f, 1) - corner(mesh, f, 0)).cross(corner(mesh, f, 2) - corner(mesh, f, 0)).norm();
}

void measure_sizes(const TriangleMesh& mesh, MeshStatistics& statistics) {
  statistics.low = statistics.high = mesh.points.front();
  for (const Vec3& p : mesh.points) {
    statistics.low = statistics.low.cwiseMin(p);
    statistics.high = statistics.high.cwiseMax(p);
  }
  statistics.smallest_edge = std::numeric_limits<double>::infinity();
  double sum = 0.0;
  for (int f = 0; f < statistics.facets; ++f) {
    const double area = calc_area(mesh, f);
    statistics.area += area;
    double longest = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double length = (corner(mesh, f, k + 2) - corner(mesh, f, k + 1)).norm();
      statistics.smallest_edge = std::min(statistics.smallest_edge, length);
      longest = std::max(longest, length);
      sum += length;
    }
    statistics.largest_edge = std::max(statistics.largest_edge, longest);
    const double aspect = longest * longest / (2.0 * area);
    statistics.worst_aspect = std::max(statistics.worst_aspect, aspect);
    if (aspect > kSliver) ++statistics.slivers;
  }
  statistics.mean_edge = sum / (3.0 * statistics.facets);
}

void measure_angles(const TriangleMesh& mesh, const MeshTopology& topology, double crease_angle,
                    MeshStatistics& statistics) {
  const std::vector<Vec3> normals = calc_facet_normals(mesh);
  double sum = 0.0;
  int bent = 0;
  double smallest_radius = std::numeric_limits<double>::infinity();
  for (int f = 0; f < statistics.facets; ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto& side = topology.sides[at(f)][at(k)];
      if (side.facet < f || side.is_flipped) continue;
      const Vec3& a = normals[at(f)];
      const Vec3& b = normals[at(side.facet)];
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b)) / kDegree;
      if (angle > crease_angle) {
        ++statistics.creases;
        statistics.sharpest_crease = std::max(statistics.sharpest_crease, angle);
        continue;
      }
      if (angle < kBent) continue;
      ++bent;
      sum += angle;
      statistics.largest_facet_angle = std::max(statistics.largest_facet_angle, angle);
      // A row of facets turns by `angle` over the height of the two facets beside the edge.
      const double edge = (corner(mesh, f, k + 2) - corner(mesh, f, k + 1)).norm();
      const double height = (calc_area(mesh, f) + calc_area(mesh, side.facet)) / edge;
      smallest_radius = std::min(smallest_radius, height / (angle * kDegree));
    }
  }
  statistics.mean_facet_angle = bent > 0 ? sum / bent : 0.0;
  statistics.smallest_radius = bent > 0 ? smallest_radius : 0.0;
}

/// Joins the open edges into chains by their common points.
std::vector<double> measure_rims(const TriangleMesh& mesh, const MeshTopology& topology) {
  std::map<int, int> leader;  // union-find over rim points
  const std::function<int(int)> find = [&](int p) {
    int root = p;
    while (leader[root] != root) root = leader[root];
    while (leader[p] != root) p = std::exchange(leader[p], root);
    return root;
  };
  std::vector<std::pair<int, double>> edges;
  for (int f = 0; f < static_cast<int>(mesh.triangles.size()); ++f) {
    for (int k = 0; k < 3; ++k) {
      if (topology.sides[at(f)][at(k)].facet != MeshTopology::kOpen) continue;
      const int from = mesh.triangles[at(f)][at((k + 1) % 3)];
      const int to = mesh.triangles[at(f)][at((k + 2) % 3)];
      leader.try_emplace(from, from);
      leader.try_emplace(to, to);
      leader[find(from)] = find(to);
      edges.emplace_back(from, (mesh.points[at(to)] - mesh.points[at(from)]).norm());
    }
  }
  std::map<int, double> lengths;
  for (const auto& [point, length] : edges) lengths[find(point)] += length;
  std::vector<double> sorted;
  for (const auto& entry : lengths) sorted.push_back(entry.second);
  std::sort(sorted.rbegin(), sorted.rend());
  return sorted;
}

int count_t_joints(const TriangleMesh& mesh, const MeshTopology& topology, double tolerance) {
  std::set<int> rim_points;
  for (int f = 0; f < static_cast<int>(mesh.triangles.size()); ++f) {
    for (int k = 0; k < 3; ++k) {
      if (topology.sides[at(f)][at(k)].facet != MeshTopology::kOpen) continue;
      rim_points.insert(mesh.triangles[at(f)][at((k + 1) % 3)]);
      rim_points.insert(mesh.triangles[at(f)][at((k + 2) % 3)]);
    }
  }
  if (rim_points.empty()) return 0;
  const TriangleTree tree(mesh);
  int count = 0;
  for (int p : rim_points) {
    bool is_joint = false;
    tree.visit_within(mesh.points[at(p)], tolerance, [&](int f) {
      const auto& t = mesh.triangles[at(f)];
      if (std::find(t.begin(), t.end(), p) != t.end()) return;
      is_joint = is_joint || tree.calc_distance2(mesh.points[at(p)], f) < tolerance * tolerance;
    });
    count += is_joint ? 1 : 0;
  }
  return count;
}

}  // namespace

MeshStatistics measure_mesh(const TriangleMesh& mesh, double crease_angle) {
  MeshStatistics statistics;
  statistics.points = static_cast<int>(mesh.points.size());
  statistics.facets = static_cast<int>(mesh.triangles.size());
  if (mesh.triangles.empty()) return statistics;
  const MeshTopology topology = make_topology(mesh);
  statistics.open_edges = topology.open_edges;
  statistics.non_manifold_edges = topology.non_manifold_edges;
  statistics.flipped_edges = topology.flipped_edges;
  const std::vector<int> parts = find_parts(topology);
  statistics.parts = 1 + *std::max_element(parts.begin(), parts.end());
  measure_sizes(mesh, statistics);
  measure_angles(mesh, topology, crease_angle, statistics);
  statistics.rim_lengths = measure_rims(mesh, topology);
  statistics.t_joints = count_t_joints(mesh, topology, 1e-5 * (statistics.high - statistics.low).norm());
  return statistics;
}

}  // namespace hydroscope
