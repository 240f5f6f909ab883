// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/prism.h"

#include <gtest/gtest.h>

#include "solver/geometry/mesh_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::at;
using test::Dice;

/// A random point at height g (of the interpolated normal) over a random place of the mesh.
Vec3 place_randomly(const MeshSurface& tool, Dice& dice, double g) {
  const TriangleMesh& mesh = tool.display_mesh();
  const auto& t =
      mesh.triangles[at(static_cast<int>(dice.number(0, static_cast<double>(mesh.triangles.size()))))];
  double l1 = dice.number(0, 1);
  double l2 = dice.number(0, 1);
  if (l1 + l2 > 1) {
    l1 = 1 - l1;
    l2 = 1 - l2;
  }
  const double l[3] = {l1, l2, 1 - l1 - l2};
  Vec3 x = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    x += l[k] * (mesh.points[at(t[k])] + g * tool.display_normals()[at(t[k])]);
  }
  return x;
}

struct Census {
  int points = 0, without = 0, with_several = 0;
};

/// V20: 16 offsets from -0.2 R to 0.2 R, 400 points each.
Census count_prisms(const MeshSurface& tool, double radius) {
  Dice dice(20);
  Census census;
  for (int i = 0; i < 16; ++i) {
    const double g = 0.2 * radius * (i < 8 ? i - 8 : i - 7) / 8.0;
    for (int j = 0; j < 400; ++j) {
      const auto prisms = tool.list_prisms_at(place_randomly(tool, dice, g), 0.25 * radius);
      ++census.points;
      census.without += prisms.empty() ? 1 : 0;
      census.with_several += prisms.size() > 1 ? 1 : 0;
    }
  }
  return census;
}

class DeadZones : public testing::TestWithParam<NormalRule> {};

TEST_P(DeadZones, ExactlyOnePrismAPointOnSpheres) {
  for (int times : {1, 2}) {
    for (bool is_concave : {false, true}) {
      TriangleMesh mesh = test::make_icosphere(10, times);
      if (is_concave) flip_mesh(mesh);
      const Census census = count_prisms(MeshSurface(mesh, {GetParam(), 60.0}), 10.0);
      EXPECT_EQ(census.points, 6400);
      EXPECT_EQ(census.without, 0);
      EXPECT_EQ(census.with_several, 0);
    }
  }
}

TEST_P(DeadZones, ExactlyOnePrismAPointOnATorus) {
  for (bool is_concave : {false, true}) {
    TriangleMesh mesh = test::make_torus(30, 10, 30, 18);
    if (is_concave) flip_mesh(mesh);
    const Census census = count_prisms(MeshSurface(mesh, {GetParam(), 60.0}), 10.0);
    EXPECT_EQ(census.without, 0);
    EXPECT_EQ(census.with_several, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, DeadZones,
                         testing::Values(NormalRule::plain, NormalRule::area, NormalRule::angle,
                                         NormalRule::max));

TEST(DeadZones, AnOrthogonalProjectionWouldLosePoints) {
  // The failure that prisms cure: with facet normals, many points over a convex surface have no facet.
  const MeshSurface tool(test::make_icosphere(10, 1), {NormalRule::facet, 60.0});
  Dice dice(21);
  int without = 0;
  for (int i = 0; i < 1000; ++i) {
    if (tool.list_prisms_at(12.0 * dice.direction(), 3.0).empty()) ++without;
  }
  EXPECT_GT(without, 250);  // mechanics 7.2: 30-36 % at 0.2 R
}

TEST(Prism, RecoversItsCoordinates) {
  const MeshSurface tool(test::make_icosphere(10, 1));
  Dice dice(3);
  for (int i = 0; i < 500; ++i) {
    const double g = dice.number(-3, 3);
    const Vec3 x = place_randomly(tool, dice, g);
    SearchHint hint;
    const auto foot = tool.find_foot_point(x, 5, 5, hint);
    ASSERT_TRUE(foot);
    EXPECT_NEAR((foot->point + foot->gap * foot->normal - x).norm(), 0.0, 1e-12);
    EXPECT_NEAR(foot->normal.norm(), 1.0, 1e-14);
    EXPECT_EQ(foot->beyond_edge, 0.0);
    // Un-normalised normals are shorter than 1: the gap is, too.
    EXPECT_LE(std::abs(foot->gap), std::abs(g) + 1e-12);
    EXPECT_GE(std::abs(foot->gap), 0.9 * std::abs(g));
  }
}

TEST(Prism, FailsBeyondTheFocalDistance) {
  const Prism concave =
      make_prism({Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 0)},
                 {Vec3(-0.3, 0, 1).normalized(), Vec3(0, -0.3, 1).normalized(), Vec3(0, 0, 1)});
  // Both normals lean inwards by 0.3 / 1.044 a mm: they meet at g = 3.48.
  EXPECT_TRUE(locate_in_prism(concave, Vec3(0.2, 0.2, 1)).is_valid);
  for (double z : {3.6, 5.0, 30.0}) {
    const PrismPoint place = locate_in_prism(concave, Vec3(0.01, 0.01, z));
    EXPECT_FALSE(place.is_valid && place.smallest() >= 0.0 && place.g > 3.5);
  }
}

class PrismGradients : public testing::TestWithParam<bool> {};

TEST_P(PrismGradients, AgreeWithDifferences) {
  TriangleMesh mesh = test::make_torus(30, 10, 48, 32);
  if (GetParam()) flip_mesh(mesh);
  const MeshSurface tool(mesh);
  Dice dice(5);
  const double step = 1e-5;  // truncation ~ step^2 / R^2, rounding ~ 1e-15 / step: both below 1e-9
  int inside = 0;
  for (int i = 0; i < 2000; ++i) {
    const double g = i % 4 == 0 ? 0.0 : dice.number(-2, 2);
    const Vec3 x = place_randomly(tool, dice, g);
    SearchHint hint;
    const int facet = tool.find_foot_point(x, 5, 5, hint)->facet;
    bool is_inside = true;  // within one facet: over its edges the gradient jumps
    for (int k = 0; k < 6; ++k) {
      const Vec3 y = x + (k < 3 ? 2 : -2) * step * Vec3::Unit(k % 3);
      is_inside = is_inside && tool.find_foot_point(y, 5, 5, hint)->facet == facet;
    }
    if (!is_inside) continue;
    ++inside;
    const test::GradientError error = test::measure_gradients(tool, x, step);
    EXPECT_LT(error.normal, 1e-6);
    EXPECT_LT(error.gap, 1e-6);
  }
  EXPECT_GT(inside, 1900);
}

INSTANTIATE_TEST_SUITE_P(ConvexAndConcave, PrismGradients, testing::Bool());

TEST(Prism, GradientHasTheShapeOfANormals) {
  const MeshSurface tool(test::make_torus(30, 10, 48, 32));
  Dice dice(6);
  for (int i = 0; i < 200; ++i) {
    SearchHint hint;
    const auto foot = tool.find_foot_point(place_randomly(tool, dice, dice.number(-2, 2)), 5, 5, hint);
    EXPECT_LT((foot->normal.transpose() * foot->normal_gradient).norm(), 1e-12);  // a unit vector only turns
    EXPECT_LT((foot->normal_gradient * foot->normal).norm(), 1e-12);  // moving along n changes nothing
    EXPECT_NEAR(foot->normal.dot(foot->gap_gradient), 1.0, 1e-12);
  }
}

TEST(Prism, GapGradientAtTheSurfaceIsTheFacetsNormal) {
  const TriangleMesh mesh = test::make_icosphere(10, 2);
  const MeshSurface tool(mesh);
  const auto facet_normals = calc_facet_normals(mesh);
  Dice dice(8);
  for (int i = 0; i < 100; ++i) {
    SearchHint hint;
    const auto foot = tool.find_foot_point(place_randomly(tool, dice, 0.0), 5, 5, hint);
    const Vec3& facet_normal = facet_normals[at(foot->facet)];
    EXPECT_LT((foot->gap_gradient - facet_normal / facet_normal.dot(foot->normal)).norm(), 1e-9);
  }
}

/// Mean curvature of dn/dx over random points at the surface, times R / 2: +1 convex, -1 concave.
double calc_mean_curvature(const MeshSurface& tool, double radius) {
  Dice dice(9);
  double sum = 0.0;
  for (int i = 0; i < 4000; ++i) {
    SearchHint hint;
    sum += tool.find_foot_point(place_randomly(tool, dice, 0.0), 5, 5, hint)->normal_gradient.trace();
  }
  return sum / 4000 * radius / 2;
}

TEST(Prism, CurvatureIsPositiveOnConvexAndNegativeOnConcaveTools) {
  TriangleMesh mesh = test::make_icosphere(10, 3);
  // Area weights give 0.6 % too much at 1280 facets (mechanics 8.2).
  EXPECT_NEAR(calc_mean_curvature(MeshSurface(mesh), 10), 1.006, 0.004);
  flip_mesh(mesh);
  EXPECT_NEAR(calc_mean_curvature(MeshSurface(mesh), 10), -1.006, 0.004);
}

TEST(Prism, ExactNormalsGiveTheSphereItsExactCurvature) {
  const MeshSurface tool(test::make_icosphere(10, 2), {NormalRule::max, 60.0});
  Dice dice(10);
  SearchHint hint;
  for (int i = 0; i < 200; ++i) {
    const auto foot = tool.find_foot_point(place_randomly(tool, dice, 0.0), 5, 5, hint);
    // dm/dx is then 1/R in the facet's plane; dividing by |m| turns 1/R into 1/|point|.
    const Mat3 round = (Mat3::Identity() - foot->normal * foot->normal.transpose()) / foot->point.norm();
    EXPECT_LT((foot->normal_gradient - round).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace hydroscope
