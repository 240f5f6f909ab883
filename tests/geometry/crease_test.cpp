// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "solver/geometry/mesh_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::Dice;

FootPoint look_up(const ToolSurface& tool, const Vec3& x) {
  SearchHint hint;
  return tool.find_foot_point(x, 1e3, 1e3, hint).value();
}

/// Signed distance of a cube of edge 2, positive outside.
double calc_cube_distance(const Vec3& x) {
  const Vec3 q = x.cwiseAbs() - Vec3::Ones();
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

TEST(Crease, CubeFromOutsideHasItsExactDistance) {
  const MeshSurface tool(test::make_cube(1, 4));
  EXPECT_EQ(tool.crease_edges(), 48);
  Dice dice(1);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 x = dice.number(1.0, 2.4) * dice.direction();
    const double wanted = calc_cube_distance(x);
    const FootPoint foot = look_up(tool, x);
    EXPECT_NEAR(foot.gap, wanted, 1e-9);
    EXPECT_LT((foot.point + foot.gap * foot.normal - x).norm(), 1e-12);
    EXPECT_EQ(foot.beyond_edge, 0.0);
  }
}

TEST(Crease, CubeFromInsideHasItsExactDistanceAndNoHoleBehindItsEdges) {
  TriangleMesh cube = test::make_cube(1, 4);
  flip_mesh(cube);
  const MeshSurface tool(cube);
  Dice dice(2);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 x = dice.number(0.2, 2.4) * dice.direction();
    EXPECT_NEAR(look_up(tool, x).gap, -calc_cube_distance(x), 1e-9);
  }
}

TEST(Crease, NormalSwingsOverAConvexEdgeWithoutAJump) {
  const MeshSurface tool(test::make_cube(1, 4));
  FootPoint last = look_up(tool, Vec3(0.8, 0.1, 1.3));
  for (int i = 1; i <= 20000; ++i) {
    const double a = 0.5 * std::numbers::pi * i / 20000;
    const Vec3 x(0.8 + 0.5 * std::sin(a), 0.1, 0.8 + 0.5 * std::cos(a));
    const FootPoint here = look_up(tool, x);
    // The step of 4e-5 mm over the distance to the edge, 0.217 mm at the least.
    EXPECT_LT((here.normal - last.normal).norm(), 1.9e-4);
    EXPECT_LT(std::abs(here.gap - last.gap), 5e-5);
    last = here;
  }
  EXPECT_GT(last.normal.x(), 0.999);
}

TEST(Crease, GradientsInTheWedgeAgreeWithDifferences) {
  const MeshSurface tool(test::make_cube(1, 4));
  for (const Vec3& x : {Vec3(1.2, 0.13, 1.3), Vec3(1.25, 1.3, 1.4), Vec3(-1.5, -1.2, 0.4)}) {
    const test::GradientError error = test::measure_gradients(tool, x, 1e-5);
    EXPECT_LT(error.gap, 1e-8);
    EXPECT_LT(error.normal, 1e-7);
  }
}

TEST(Crease, CurvatureStaysFiniteOnTheEdgeItself) {
  const MeshSurface tool(test::make_cube(1, 4));
  for (double off : {0.0, 1e-15, 1e-12, 1e-9, 1e-6}) {
    for (const Vec3& edge : {Vec3(1, 0.2, 1), Vec3(1, 1, 1)}) {
      const FootPoint foot = look_up(tool, edge + off * Vec3(1, 0.5, 1));
      EXPECT_NEAR(foot.gap, 0.0, 2 * off + 1e-14);
      EXPECT_NEAR(foot.normal.norm(), 1.0, 1e-12);
      EXPECT_TRUE(foot.normal_gradient.allFinite());
      EXPECT_LT(foot.normal_gradient.norm(), 1e4);
    }
  }
}

TEST(Crease, RoundedCreaseBetweenCurvedFacesIsWatertight) {
  // Two cylinders' parts meet at a sharp ridge that is itself curved: normals lean along the ridge.
  const auto profile = [](int i, double bow) {
    const double u = 0.25 * (i - 8);
    return Vec3(u, bow * u, -std::abs(u) * 1.2 - 0.1 * u * u);
  };
  const TriangleMesh mesh = make_grid_mesh(17, 13, [&](int i, int j) {
    const double v = 0.3 * (j - 6);
    return Vec3(profile(i, 0.1) + Vec3(0.05 * v * v, v, -0.08 * v * v));
  });
  const MeshSurface tool(mesh);
  EXPECT_GE(tool.crease_edges(), 12);
  Dice dice(3);
  for (int k = 0; k < 20; ++k) {
    const Vec3 from(-0.8, dice.number(-1, 1), dice.number(0.1, 0.5));
    const Vec3 to(0.8, dice.number(-1, 1), dice.number(0.1, 0.5));
    SearchHint hint;
    FootPoint last = *tool.find_foot_point(from, 1e3, 1e3, hint);
    for (int i = 1; i <= 5000; ++i) {
      const FootPoint here = *tool.find_foot_point(from + (to - from) * i / 5000.0, 1e3, 1e3, hint);
      EXPECT_LT(std::abs(here.gap - last.gap), 1.1 * (to - from).norm() / 5000);
      EXPECT_LT((here.normal - last.normal).norm(), 20 * (to - from).norm() / 5000);
      last = here;
    }
  }
}

TEST(Crease, GrooveAnswersWithTheNearerWall) {
  // A right-angled groove open to +x+y: two walls, their crease concave.
  TriangleMesh groove = make_grid_mesh(
      9, 5, [](int i, int j) { return i < 4 ? Vec3(0, 0.5 * (4 - i), j) : Vec3(0.5 * (i - 4), 0, j); });
  const MeshSurface tool(groove);
  const double sign = look_up(tool, Vec3(1, 0.2, 2)).gap > 0 ? 1.0 : -1.0;
  if (sign < 0) flip_mesh(groove);
  const MeshSurface facing(groove);
  EXPECT_NEAR(look_up(facing, Vec3(1, 0.2, 2)).gap, 0.2, 1e-12);
  EXPECT_NEAR(look_up(facing, Vec3(0.3, 0.7, 2)).gap, 0.3, 1e-12);
  EXPECT_NEAR(look_up(facing, Vec3(0.05, 0.05001, 2)).gap, 0.05, 1e-12);
  // Behind the bottom of the groove, where projections lose the point.
  EXPECT_NEAR(look_up(facing, Vec3(-0.03, -0.04, 2.2)).gap, -0.05, 1e-12);
}

}  // namespace
}  // namespace hydroscope
