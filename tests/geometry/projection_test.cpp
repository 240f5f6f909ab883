// SPDX-License-Identifier: GPL-3.0-or-later
// V20: orthogonal projection loses points over convex edges and has several over concave ones; the
// normal prism has exactly one everywhere.
#include <gtest/gtest.h>

#include "solver/base/error.h"
#include "solver/geometry/mesh_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::Dice;

struct Share {
  double without = 0.0, with_several = 0.0;  // of the points
};

Share count(const TriangleMesh& mesh, Projection projection, double radius) {
  const MeshSurface tool(mesh, {NormalRule::area, 60.0});
  Dice dice(20);
  Share share;
  const int points = 2000;
  for (int i = 0; i < points; ++i) {
    const Vec3 x = radius * dice.direction();
    const double reach = 1.2 * std::abs(radius - 10.0) + 1.0;  // facets of 36 degrees lie up to 0.7 mm deep
    const auto facets =
        projection == Projection::prism ? tool.list_prisms_at(x, reach) : tool.list_projections_at(x, reach);
    share.without += facets.empty() ? 1.0 / points : 0.0;
    share.with_several += facets.size() > 1 ? 1.0 / points : 0.0;
  }
  return share;
}

TEST(Projection, OrthogonalHasDeadZonesOverConvexEdges) {
  const TriangleMesh ball = test::make_icosphere(10, 1);
  // Mechanics 7.2: at 0.02, 0.05, 0.1, 0.2 R 6-9, 10-12, 18-24 and 30-36 % (80 and 320 facets).
  const double expected[4][2] = {{0.05, 0.10}, {0.09, 0.14}, {0.16, 0.26}, {0.28, 0.38}};
  int i = 0;
  for (double g : {0.2, 0.5, 1.0, 2.0}) {
    const double lost = count(ball, Projection::orthogonal, 10 + g).without;
    EXPECT_GT(lost, expected[i][0]) << g;
    EXPECT_LT(lost, expected[i][1]) << g;
    ++i;
    const Share prisms = count(ball, Projection::prism, 10 + g);
    EXPECT_EQ(prisms.without, 0.0);
    EXPECT_EQ(prisms.with_several, 0.0);
  }
}

TEST(Projection, OrthogonalHasDoubleHitsOnTheConcaveSide) {
  TriangleMesh cavity = test::make_icosphere(10, 1);
  flip_mesh(cavity);
  EXPECT_GT(count(cavity, Projection::orthogonal, 9.0).with_several, 0.05);
  EXPECT_GT(count(cavity, Projection::orthogonal, 8.0).with_several, 0.2);
  for (double radius : {8.0, 9.0, 9.8}) {
    const Share prisms = count(cavity, Projection::prism, radius);
    EXPECT_EQ(prisms.without, 0.0);
    EXPECT_EQ(prisms.with_several, 0.0);
  }
}

/// A concave corner of 30 degrees between two flats along z, its bottom at x = 0; free side above.
TriangleMesh make_groove() {
  return make_grid_mesh(9, 5, [](int i, int j) {
    const double u = i - 4;
    return Vec3(u, std::abs(u) * std::tan(15 * std::numbers::pi / 180), -2.0 * j);
  });
}

TEST(Projection, OrthogonalLosesANodeThatFallsThroughAConcaveCorner) {
  MeshSurfaceOptions options{NormalRule::area, 60.0};
  const MeshSurface prism(make_groove(), options);
  options.projection = Projection::orthogonal;
  const MeshSurface orthogonal(make_groove(), options);
  SearchHint hint, other;
  // On the free side both hold it; a little behind the bottom only one does.
  const Vec3 above(0.001, 0.05, -3.3), below(0.001, -0.05, -3.3);
  ASSERT_TRUE(prism.find_foot_point(above, 1, 1, hint));
  ASSERT_TRUE(orthogonal.find_foot_point(above, 1, 1, other));
  const auto kept = prism.find_foot_point(below, 1, 1, hint);
  ASSERT_TRUE(kept);
  EXPECT_NEAR(kept->gap, -0.05, 0.003);
  EXPECT_FALSE(orthogonal.find_foot_point(below, 1, 1, other));
}

TEST(Projection, OrthogonalNormalJumpsAlongAConcaveCorner) {
  // Marching over the bottom, the nearer of two hits changes at once, and the gap with it stays.
  MeshSurfaceOptions options{NormalRule::area, 60.0};
  const MeshSurface prism(make_groove(), options);
  options.projection = Projection::orthogonal;
  const MeshSurface orthogonal(make_groove(), options);
  const auto jump = [](const MeshSurface& tool) {
    SearchHint a, b;
    const auto left = tool.find_foot_point(Vec3(-1e-9, 0.8, -3.3), 2, 2, a);
    const auto right = tool.find_foot_point(Vec3(1e-9, 0.8, -3.3), 2, 2, b);
    return (left->normal - right->normal).norm();
  };
  EXPECT_LT(jump(prism), 1e-8);
  EXPECT_GT(jump(orthogonal), 0.05);
}

TEST(Projection, OrthogonalAgreesWithThePrismOverAPlane) {
  const TriangleMesh plane = make_grid_mesh(5, 5, [](int i, int j) { return Vec3(i, j, 0); });
  MeshSurfaceOptions options;
  options.projection = Projection::orthogonal;
  const MeshSurface tool(plane, options);
  SearchHint hint;
  const auto foot = tool.find_foot_point(Vec3(1.3, 2.2, 0.4), 1, 1, hint);
  ASSERT_TRUE(foot);
  EXPECT_NEAR(foot->gap, 0.4, 1e-15);
  EXPECT_LT((foot->normal - Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_FALSE(tool.find_foot_point(Vec3(4.2, 2.2, 0.4), 1, 1, hint));  // beside it there is nothing
}

TEST(Projection, GradientsAgreeWithDifferences) {
  MeshSurfaceOptions options;
  options.projection = Projection::orthogonal;
  const MeshSurface tool(test::make_torus(30, 10, 48, 32), options);
  Dice dice(5);
  const double step = 1e-5;
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const double a = dice.number(0, 6.2), t = dice.number(0, 6.2), r = dice.number(9, 11);
    const Vec3 x((30 + r * std::cos(t)) * std::cos(a), (30 + r * std::cos(t)) * std::sin(a), r * std::sin(t));
    SearchHint hint;
    const auto here = tool.find_foot_point(x, 5, 5, hint);
    bool is_inside = here.has_value();
    for (int k = 0; is_inside && k < 6; ++k) {
      const auto there = tool.find_foot_point(x + (k < 3 ? 2 : -2) * step * Vec3::Unit(k % 3), 5, 5, hint);
      is_inside = there && there->facet == here->facet;
    }
    if (!is_inside) continue;
    ++inside;
    for (int k = 0; k < 3; ++k) {
      const auto up = tool.find_foot_point(x + step * Vec3::Unit(k), 5, 5, hint);
      const auto down = tool.find_foot_point(x - step * Vec3::Unit(k), 5, 5, hint);
      EXPECT_LT(((up->normal - down->normal) / (2 * step) - here->normal_gradient.col(k)).norm(), 1e-6);
      EXPECT_NEAR((up->gap - down->gap) / (2 * step), here->gap_gradient[k], 1e-6);
    }
  }
  EXPECT_GT(inside, 500);
}

TEST(Projection, HasNames) {
  EXPECT_EQ(parse_projection("orthogonal"), Projection::orthogonal);
  EXPECT_EQ(parse_projection("prism"), Projection::prism);
  EXPECT_THROW(parse_projection("closest"), InputError);
}

}  // namespace
}  // namespace hydroscope
