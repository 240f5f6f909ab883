// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/mesh_topology.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace hydroscope {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct HalfEdge {
  int low, high;  // points
  int facet, edge;
  bool is_forward;  // runs from low to high
};

std::vector<HalfEdge> list_half_edges(const TriangleMesh& mesh) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (int f = 0; f < static_cast<int>(mesh.triangles.size()); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int from = mesh.triangles[at(f)][at((k + 1) % 3)];
      const int to = mesh.triangles[at(f)][at((k + 2) % 3)];
      edges.push_back({std::min(from, to), std::max(from, to), f, k, from < to});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return std::tie(a.low, a.high, a.facet, a.edge) < std::tie(b.low, b.high, b.facet, b.edge);
  });
  return edges;
}

void join(const HalfEdge& a, const HalfEdge& b, MeshTopology& topology) {
  const bool is_flipped = a.is_forward == b.is_forward;
  topology.sides[at(a.facet)][at(a.edge)] = {b.facet, b.edge, is_flipped};
  topology.sides[at(b.facet)][at(b.edge)] = {a.facet, a.edge, is_flipped};
  if (is_flipped) ++topology.flipped_edges;
}

void fill_rings(const TriangleMesh& mesh, MeshTopology& topology) {
  topology.ring_start.assign(mesh.points.size() + 1, 0);
  for (const auto& t : mesh.triangles) {
    for (int p : t) ++topology.ring_start[at(p + 1)];
  }
  for (std::size_t p = 1; p < topology.ring_start.size(); ++p)
    topology.ring_start[p] += topology.ring_start[p - 1];
  topology.ring.resize(3 * mesh.triangles.size());
  std::vector<int> next(topology.ring_start.begin(), topology.ring_start.end() - 1);
  for (int f = 0; f < static_cast<int>(mesh.triangles.size()); ++f) {
    for (int p : mesh.triangles[at(f)]) topology.ring[at(next[at(p)]++)] = f;
  }
}

/// Walks over one connected part; `turned` says which facets disagree with the first one.
std::vector<int> spread_orientation(const MeshTopology& topology, int seed, std::vector<int>& turned) {
  std::vector<int> part{seed};
  turned[at(seed)] = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const int f = part[i];
    for (const auto& side : topology.sides[at(f)]) {
      if (side.facet < 0 || turned[at(side.facet)] >= 0) continue;
      turned[at(side.facet)] = side.is_flipped ? 1 - turned[at(f)] : turned[at(f)];
      part.push_back(side.facet);
    }
  }
  return part;
}

double calc_area(const TriangleMesh& mesh, int f) {
  const auto& t = mesh.triangles[at(f)];
  const Vec3& a = mesh.points[at(t[0])];
  return 0.5 * (mesh.points[at(t[1])] - a).cross(mesh.points[at(t[2])] - a).norm();
}

}  // namespace

MeshTopology make_topology(const TriangleMesh& mesh) {
  MeshTopology topology;
  topology.sides.resize(mesh.triangles.size());
  const std::vector<HalfEdge> edges = list_half_edges(mesh);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) ++end;
    if (end - i == 1) ++topology.open_edges;
    if (end - i == 2) join(edges[i], edges[i + 1], topology);
    if (end - i > 2) {
      ++topology.non_manifold_edges;
      for (std::size_t k = i; k < end; ++k) {
        topology.sides[at(edges[k].facet)][at(edges[k].edge)].facet = MeshTopology::kNonManifold;
      }
    }
    i = end;
  }
  fill_rings(mesh, topology);
  return topology;
}

std::vector<Vec3> calc_facet_normals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals;
  normals.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.points[at(t[0])];
    const Vec3 area = (mesh.points[at(t[1])] - a).cross(mesh.points[at(t[2])] - a);
    const double size = area.norm();
    normals.push_back(size > 0.0 ? Vec3(area / size) : Vec3(Vec3::Zero()));  // (4.1)
  }
  return normals;
}

int orient_consistently(TriangleMesh& mesh) {
  const MeshTopology topology = make_topology(mesh);
  if (topology.flipped_edges == 0) return 0;
  std::vector<int> turned(mesh.triangles.size(), -1);
  int count = 0;
  for (int seed = 0; seed < static_cast<int>(mesh.triangles.size()); ++seed) {
    if (turned[at(seed)] >= 0) continue;
    const std::vector<int> part = spread_orientation(topology, seed, turned);
    double area[2] = {0.0, 0.0};
    for (int f : part) area[turned[at(f)]] += calc_area(mesh, f);
    const int loser = area[1] > area[0] ? 0 : 1;
    for (int f : part) {
      if (turned[at(f)] != loser) continue;
      std::swap(mesh.triangles[at(f)][1], mesh.triangles[at(f)][2]);
      ++count;
    }
  }
  return count;
}

std::vector<int> find_parts(const MeshTopology& topology) {
  std::vector<int> turned(topology.sides.size(), -1);
  std::vector<int> part_of(topology.sides.size(), -1);
  int parts = 0;
  for (int seed = 0; seed < static_cast<int>(topology.sides.size()); ++seed) {
    if (turned[at(seed)] >= 0) continue;
    for (int f : spread_orientation(topology, seed, turned)) part_of[at(f)] = parts;
    ++parts;
  }
  return part_of;
}

}  // namespace hydroscope
