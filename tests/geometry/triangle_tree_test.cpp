// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/triangle_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::at;
using test::Dice;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TriangleTree::Nearest find_by_trying_all(const TriangleMesh& mesh, const Vec3& x) {
  TriangleTree::Nearest best{-1, kInfinity};
  for (int f = 0; f < static_cast<int>(mesh.triangles.size()); ++f) {
    const auto& t = mesh.triangles[at(f)];
    const double d =
        find_closest_point(x, mesh.points[at(t[0])], mesh.points[at(t[1])], mesh.points[at(t[2])]).distance2;
    if (d < best.distance2) best = {f, d};
  }
  return best;
}

/// Distance to a triangle by sampling it finely: an upper bound, off by the sampling at most.
double sample_distance(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) {
  double best = kInfinity;
  const int n = 200;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      best = std::min(best, (a + (b - a) * i / n + (c - a) * j / n - x).norm());
    }
  }
  return best;
}

TEST(ClosestPoint, BeatsEverySampleOfTheTriangle) {
  Dice dice(7);
  for (int i = 0; i < 200; ++i) {
    Vec3 corner[3];
    for (Vec3& p : corner) p = Vec3(dice.number(-1, 1), dice.number(-1, 1), dice.number(-1, 1));
    if (i % 4 == 0)
      corner[2] = corner[0] + 0.3 * (corner[1] - corner[0]) + 1e-3 * dice.direction();  // obtuse
    const Vec3 x = 2.0 * dice.direction() * dice.number(0, 1);
    const ClosestPoint closest = find_closest_point(x, corner[0], corner[1], corner[2]);
    const double sampled = sample_distance(x, corner[0], corner[1], corner[2]);
    const double distance = std::sqrt(closest.distance2);
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GE(distance, sampled - 0.02);  // sampling step of edges up to 3.5 long
    EXPECT_NEAR(closest.weights.sum(), 1.0, 1e-12);
    EXPECT_GE(closest.weights.minCoeff(), 0.0);
    const Vec3 point =
        closest.weights[0] * corner[0] + closest.weights[1] * corner[1] + closest.weights[2] * corner[2];
    EXPECT_LT((point - closest.point).norm(), 1e-12);
  }
}

TEST(TriangleTree, FindsWhatTryingAllFinds) {
  Dice dice(1);
  for (const TriangleMesh& mesh : {test::make_icosphere(10, 2), test::make_torus(20, 5, 40, 24)}) {
    const TriangleTree tree(mesh);
    for (int i = 0; i < 2000; ++i) {
      const Vec3 x = 30.0 * dice.direction() * dice.number(0, 1);
      const auto wanted = find_by_trying_all(mesh, x);
      const auto found = tree.find_nearest(x, {-1, kInfinity});
      EXPECT_EQ(found.facet, wanted.facet);
      EXPECT_EQ(found.distance2, wanted.distance2);
    }
  }
}

TEST(TriangleTree, AnswerDoesNotDependOnTheStart) {
  const TriangleMesh mesh = test::make_icosphere(10, 2);
  const TriangleTree tree(mesh);
  Dice dice(2);
  for (int i = 0; i < 2000; ++i) {
    // Corners, middles of edges and the centre have many nearest facets: the ties matter.
    Vec3 x = mesh.points[at(i % static_cast<int>(mesh.points.size()))];
    if (i % 3 == 1) x *= 0.7;
    if (i % 3 == 2) x = 12.0 * dice.direction();
    const auto cold = tree.find_nearest(x, {-1, kInfinity});
    const int other = static_cast<int>(dice.number(0, static_cast<double>(mesh.triangles.size())));
    const auto warm = tree.find_nearest(x, {other, tree.calc_distance2(x, other)});
    EXPECT_EQ(cold.facet, warm.facet);
    EXPECT_EQ(cold.distance2, warm.distance2);
  }
}

TEST(TriangleTree, FindsNothingBeyondTheBound) {
  const TriangleTree tree(test::make_icosphere(10, 1));
  EXPECT_EQ(tree.find_nearest(Vec3(15, 0, 0), {-1, 4.0}).facet, -1);
  EXPECT_GE(tree.find_nearest(Vec3(11, 0, 0), {-1, 4.0}).facet, 0);
}

TEST(TriangleTree, VisitsEveryFacetWithinTheRadius) {
  const TriangleMesh mesh = test::make_torus(20, 5, 40, 24);
  const TriangleTree tree(mesh);
  Dice dice(3);
  for (int i = 0; i < 100; ++i) {
    const Vec3 x = 25.0 * dice.direction();
    const double radius = dice.number(0, 10);
    std::set<int> visited;
    tree.visit_within(x, radius, [&](int f) { EXPECT_TRUE(visited.insert(f).second); });
    for (int f = 0; f < static_cast<int>(mesh.triangles.size()); ++f) {
      if (tree.calc_distance2(x, f) <= radius * radius) {
        EXPECT_EQ(visited.count(f), 1u);
      }
    }
  }
}

TEST(TriangleTree, StaysShallowForFacetsOnTopOfEachOther) {
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles.assign(1000, {0, 1, 2});
  const TriangleTree tree(mesh);
  EXPECT_LE(tree.depth(), 10);
  EXPECT_EQ(tree.find_nearest(Vec3(0.2, 0.2, 1), {-1, kInfinity}).facet, 0);
}

}  // namespace
}  // namespace hydroscope
