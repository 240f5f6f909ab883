// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/mesh_topology.h"

#include <gtest/gtest.h>

#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::at;

TEST(MeshTopology, ClosedMeshHasNoOpenEdges) {
  const MeshTopology topology = make_topology(test::make_icosphere(10, 2));
  EXPECT_EQ(topology.open_edges, 0);
  EXPECT_EQ(topology.non_manifold_edges, 0);
  EXPECT_EQ(topology.flipped_edges, 0);
  for (int f = 0; f < 320; ++f) {
    for (int k = 0; k < 3; ++k) {
      const auto& side = topology.sides[at(f)][at(k)];
      EXPECT_EQ(topology.sides[at(side.facet)][at(side.edge)].facet, f);
    }
  }
}

TEST(MeshTopology, CountsTheRimOfAnOpenSheet) {
  const TriangleMesh sheet = make_grid_mesh(4, 3, [](int i, int j) { return Vec3(i, j, 0); });
  EXPECT_EQ(make_topology(sheet).open_edges, 10);
}

TEST(MeshTopology, RingsHoldTheFacetsOfEachPoint) {
  const TriangleMesh mesh = test::make_icosphere(10, 1);
  const MeshTopology topology = make_topology(mesh);
  for (int p = 0; p < static_cast<int>(mesh.points.size()); ++p) {
    const int count = topology.ring_start[at(p + 1)] - topology.ring_start[at(p)];
    EXPECT_EQ(count, p < 12 ? 5 : 6);  // the corners of the icosahedron keep five neighbours
  }
}

TEST(MeshTopology, FindsEdgesOfThreeFacets) {
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
  const MeshTopology topology = make_topology(mesh);
  EXPECT_EQ(topology.non_manifold_edges, 1);
  EXPECT_EQ(topology.open_edges, 6);
  EXPECT_EQ(topology.sides[0][2].facet, MeshTopology::kNonManifold);
}

TEST(OrientConsistently, TurnsTheFacetsThatDisagree) {
  const TriangleMesh whole = test::make_icosphere(10, 2);
  TriangleMesh mesh = whole;
  for (int f : {0, 7, 8, 100, 319}) std::swap(mesh.triangles[at(f)][0], mesh.triangles[at(f)][1]);
  EXPECT_GT(make_topology(mesh).flipped_edges, 0);
  EXPECT_EQ(orient_consistently(mesh), 5);
  EXPECT_EQ(make_topology(mesh).flipped_edges, 0);
  const auto wanted = calc_facet_normals(whole);
  const auto normals = calc_facet_normals(mesh);
  for (std::size_t f = 0; f < normals.size(); ++f) EXPECT_GT(normals[f].dot(wanted[f]), 0.99);
}

TEST(OrientConsistently, LetsTheLargerAreaWin) {
  // Two small facets point up, one large facet down: the large one stays.
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 0}, {-1, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 2, 3}, {0, 2, 4}};
  EXPECT_EQ(orient_consistently(mesh), 2);
  for (const Vec3& normal : calc_facet_normals(mesh)) EXPECT_LT(normal.z(), -0.99);
}

TEST(OrientConsistently, LeavesAMoebiusStripFlippedSomewhere) {
  TriangleMesh strip;
  for (int i = 0; i < 9; ++i) {
    const double a = 2 * std::numbers::pi * i / 9;
    const Vec3 out(std::cos(a), std::sin(a), 0);
    const Vec3 across = std::cos(a / 2) * out + std::sin(a / 2) * Vec3::UnitZ();
    strip.points.push_back(3 * out - across);
    strip.points.push_back(3 * out + across);
  }
  for (int i = 0; i < 9; ++i) {
    const int a = 2 * i, b = 2 * i + 1;
    const int c = i < 8 ? a + 2 : 1, d = i < 8 ? b + 2 : 0;
    strip.triangles.push_back({a, b, d});
    strip.triangles.push_back({a, d, c});
  }
  orient_consistently(strip);
  EXPECT_GT(make_topology(strip).flipped_edges, 0);
}

TEST(FindParts, NumbersConnectedParts) {
  TriangleMesh two = test::make_icosphere(10, 0);
  const TriangleMesh other = test::make_icosphere(1, 0);
  const int offset = static_cast<int>(two.points.size());
  two.points.insert(two.points.end(), other.points.begin(), other.points.end());
  for (auto t : other.triangles) two.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  const std::vector<int> part = find_parts(make_topology(two));
  for (int f = 0; f < 40; ++f) EXPECT_EQ(part[at(f)], f < 20 ? 0 : 1);
}

TEST(FlipMesh, TurnsAllNormalsAround) {
  TriangleMesh mesh = test::make_icosphere(10, 1);
  const auto before = calc_facet_normals(mesh);
  flip_mesh(mesh);
  const auto after = calc_facet_normals(mesh);
  for (std::size_t f = 0; f < after.size(); ++f) EXPECT_LT((before[f] + after[f]).norm(), 1e-14);
}

}  // namespace
}  // namespace hydroscope
