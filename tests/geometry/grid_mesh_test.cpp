// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/grid_mesh.h"

#include <gtest/gtest.h>

#include "solver/geometry/mesh_topology.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

TEST(GridMesh, NormalsFollowColumnsTimesRows) {
  const TriangleMesh mesh = make_grid_mesh(3, 4, [](int i, int j) { return Vec3(i, j, 0); });
  EXPECT_EQ(mesh.points.size(), 12u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  for (const Vec3& normal : calc_facet_normals(mesh)) EXPECT_EQ(normal, Vec3::UnitZ());
}

TEST(GridMesh, SplitsCellsAtTheShorterDiagonal) {
  const TriangleMesh mesh = make_grid_mesh(2, 2, [](int i, int j) { return Vec3(i + 0.5 * j, j, 0); });
  // Points 1 and 2 of this sheared cell are nearer to each other than 0 and 3.
  for (const auto& t : mesh.triangles) {
    EXPECT_TRUE(std::find(t.begin(), t.end(), 1) != t.end());
    EXPECT_TRUE(std::find(t.begin(), t.end(), 2) != t.end());
  }
}

TEST(GridMesh, ClosesWherePointsCoincide) {
  EXPECT_EQ(make_topology(test::make_torus(30, 10, 12, 8)).open_edges, 0);
}

TEST(GradedSteps, AreSymmetricGrowTowardsTheMiddleAndBeginAsAsked) {
  const std::vector<double> steps = make_graded_steps(0.02, 12);
  ASSERT_EQ(steps.size(), 13u);
  EXPECT_NEAR(steps[1], 0.02, 1e-9);
  EXPECT_EQ(steps.front(), 0.0);
  EXPECT_EQ(steps.back(), 1.0);
  for (std::size_t i = 1; i < 6; ++i) EXPECT_GT(steps[i + 1] - steps[i], steps[i] - steps[i - 1]);
  for (std::size_t i = 0; i < 13; ++i) EXPECT_NEAR(steps[i] + steps[12 - i], 1.0, 1e-14);
}

TEST(GradedSteps, AreEqualWhenThatIsFineEnough) {
  const std::vector<double> steps = make_graded_steps(0.4, 10);
  for (std::size_t i = 0; i < steps.size(); ++i) EXPECT_NEAR(steps[i], 0.1 * static_cast<double>(i), 1e-9);
}

TEST(RoundedOutline, LiesOnTheSectionAndTurnsLeft) {
  const auto outline = make_rounded_outline(36, 30, 12, 13, 8);
  double turned = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2& p = outline[i];
    const Vec2 a = outline[(i + 1) % outline.size()] - p;
    const Vec2 b = outline[(i + 2) % outline.size()] - outline[(i + 1) % outline.size()];
    const double turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    EXPECT_GE(turn, -1e-12);
    EXPECT_LE(turn, std::numbers::pi / 2 / 13 + 1e-12);
    turned += turn;
    const Vec2 q(std::abs(p.x()) - 24, std::abs(p.y()) - 18);
    const bool is_in_corner = q.x() >= -1e-12 && q.y() >= -1e-12;
    EXPECT_NEAR(is_in_corner ? q.norm() : std::max(q.x(), q.y()), 12.0, 1e-12);
  }
  EXPECT_NEAR(turned, 2 * std::numbers::pi, 1e-12);
}

TEST(RoundedOutline, SharpAndRoundLimits) {
  EXPECT_EQ(make_rounded_outline(10, 10, 10, 9, 4).size(), 36u);  // a circle
  EXPECT_EQ(make_rounded_outline(10, 10, 0, 9, 4).size(), 16u);   // a square
}

}  // namespace
}  // namespace hydroscope
