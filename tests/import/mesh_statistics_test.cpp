// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/mesh_statistics.h"

#include <gtest/gtest.h>

#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

TEST(MeshStatistics, OfACube) {
  const MeshStatistics cube = measure_mesh(test::make_cube(1, 2), 40.0);
  EXPECT_EQ(cube.facets, 48);
  EXPECT_EQ(cube.points, 26);
  EXPECT_EQ(cube.parts, 1);
  EXPECT_NEAR(cube.area, 24.0, 1e-12);
  EXPECT_EQ(cube.low, Vec3(-1, -1, -1));
  EXPECT_EQ(cube.high, Vec3(1, 1, 1));
  EXPECT_EQ(cube.open_edges, 0);
  EXPECT_EQ(cube.creases, 24);
  EXPECT_NEAR(cube.sharpest_crease, 90.0, 1e-9);
  EXPECT_EQ(cube.largest_facet_angle, 0.0);
  EXPECT_EQ(cube.smallest_radius, 0.0);
  EXPECT_NEAR(cube.smallest_edge, 1.0, 1e-12);
  EXPECT_NEAR(cube.largest_edge, std::sqrt(2.0), 1e-12);
  EXPECT_EQ(cube.slivers, 0);
}

TEST(MeshStatistics, OfARoundBar) {
  const TriangleMesh bar = make_grid_mesh(61, 9, [](int i, int j) {
    const double a = 2 * std::numbers::pi * (i % 60) / 60;
    return Vec3(10 * std::cos(a), 10 * std::sin(a), j);
  });
  const MeshStatistics statistics = measure_mesh(bar, 40.0);
  EXPECT_NEAR(statistics.largest_facet_angle, 6.0, 1e-9);
  EXPECT_NEAR(statistics.mean_facet_angle, 6.0, 1e-9);
  EXPECT_NEAR(statistics.smallest_radius, 10.0, 0.02);
  ASSERT_EQ(statistics.rim_lengths.size(), 2u);
  EXPECT_NEAR(statistics.rim_lengths[0], 60 * 2 * 10 * std::sin(std::numbers::pi / 60), 1e-9);
  EXPECT_EQ(statistics.t_joints, 0);
  EXPECT_EQ(statistics.creases, 0);
}

TEST(MeshStatistics, FindsSliversAndTJoints) {
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0.7, 0, 0}, {1, -1, 0}, {0, 5, 0}, {9, 5, 0}, {4, 5.1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 0, 4}, {1, 3, 4}, {5, 6, 7}};  // point 3 lies on the edge 0-1
  const MeshStatistics statistics = measure_mesh(mesh, 40.0);
  EXPECT_EQ(statistics.t_joints, 1);
  EXPECT_EQ(statistics.slivers, 1);
  EXPECT_NEAR(statistics.worst_aspect, 90.0, 1.0);
  EXPECT_EQ(statistics.parts, 3);
}

}  // namespace
}  // namespace hydroscope
