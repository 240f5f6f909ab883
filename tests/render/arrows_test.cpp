// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/arrows.h"

#include <gtest/gtest.h>

#include "render/shape/sheet_shape.h"

namespace hydroscope {
namespace {

std::vector<Vec3> make_grid(int n) {
  std::vector<Vec3> points;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) points.emplace_back(i, j, 0.0);
  return points;
}

TEST(Arrows, ReachFromStartToTip) {
  const Surface arrow = make_arrows({{Vec3(1, 2, 3), Vec3(0, 0, 10), 7.0}}, 1.0, {Reflection{}});
  Bounds bounds;
  for (const Vec3f& x : arrow.points) bounds.include(x.cast<double>());
  EXPECT_NEAR(bounds.least.z(), 3.0, 1e-5);
  EXPECT_NEAR(bounds.greatest.z(), 13.0, 1e-5);
  for (float value : arrow.values) EXPECT_EQ(value, 7.0f);
}

TEST(Arrows, NoVectorNoArrow) {
  EXPECT_TRUE(make_arrows({{Vec3::Zero(), Vec3::Zero(), 0.0}}, 1.0, {Reflection{}}).polygons.empty());
  const Vec3 nan = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(make_arrows({{Vec3::Zero(), nan, 0.0}}, 1.0, {Reflection{}}).polygons.empty());
}

TEST(Arrows, LookOutwards) {
  const Surface arrow = make_arrows({{Vec3::Zero(), Vec3(0, 0, 10), 0.0}}, 1.0, {Reflection{}});
  for (const auto& p : arrow.polygons) {
    const auto x = [&](std::size_t k) { return arrow.points[static_cast<std::size_t>(p[k])]; };
    const Vec3f area = (x(2) - x(0)).cross(x(3) - x(1));
    const Vec3f n =
        arrow.normals[static_cast<std::size_t>(p[0])] + arrow.normals[static_cast<std::size_t>(p[1])];
    EXPECT_GT(area.dot(n), 0.0f);
  }
}

TEST(SpreadPoints, AreFewEnoughAndFillTheField) {
  const auto points = make_grid(40);
  const auto chosen = find_spread_points(points, 100);
  EXPECT_LE(chosen.size(), 100u);
  EXPECT_GE(chosen.size(), 50u) << "a sensible share of what is allowed";
  for (const Vec3& x : points) {
    double nearest = 1e9;
    for (int i : chosen) nearest = std::min(nearest, (points[static_cast<std::size_t>(i)] - x).norm());
    EXPECT_LT(nearest, 40.0 / 5.0);
  }
}

TEST(SpreadPoints, AreTheSameEveryTime) {
  EXPECT_EQ(find_spread_points(make_grid(30), 77), find_spread_points(make_grid(30), 77));
}

TEST(SpreadPoints, TakeAllWhenTheyAreFewAndSurviveCoincidentOnes) {
  EXPECT_EQ(find_spread_points(make_grid(3), 9).size(), 9u);
  EXPECT_EQ(find_spread_points(std::vector<Vec3>(50, Vec3(1, 1, 1)), 9).size(), 1u);
  EXPECT_TRUE(find_spread_points({}, 9).empty());
}

}  // namespace
}  // namespace hydroscope
