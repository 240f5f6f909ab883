// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <numeric>
#include <set>

#include "render/shape/quad_blocks.h"
#include "render/shape/sheet_shape.h"
#include "render/shape/wall_section.h"
#include "tests/render/live/live_scene.h"

namespace hydroscope {
namespace {

std::vector<int> list_quads(const QuadBlocks& found) {
  std::vector<int> all = found.singles;
  for (const auto& block : found.blocks) all.insert(all.end(), block.quads.begin(), block.quads.end());
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<int> count_up(std::size_t count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

double calc_area(const Surface& surface) {
  double area = 0.0;
  for (const auto& p : surface.polygons) {
    const auto x = [&](std::size_t k) -> Vec3 {
      return surface.points[static_cast<std::size_t>(p[k])].cast<double>();
    };
    area += 0.5 * (x(1) - x(0)).cross(x(2) - x(0)).norm();
    if (p[3] >= 0) area += 0.5 * (x(2) - x(0)).cross(x(3) - x(0)).norm();
  }
  return area;
}

TEST(QuadBlocks, AGridIsTakenTwoByTwo) {
  const FlatStrip strip{.columns = 6, .rows = 4};
  const auto snapshot = strip.make();
  const QuadBlocks found = find_quad_blocks(snapshot->model->quads);
  EXPECT_EQ(found.blocks.size(), 6u);
  EXPECT_TRUE(found.singles.empty());
  EXPECT_EQ(list_quads(found), count_up(24));
  for (const auto& block : found.blocks) {
    const auto x = [&](std::size_t k) {
      return snapshot->points[static_cast<std::size_t>(block.corners[k])];
    };
    EXPECT_EQ((x(1) - x(0)).cross(x(3) - x(0)).z(), 4.0) << "two by two, in the order of the quads";
    EXPECT_EQ((x(3) - x(2)).cross(x(1) - x(2)).z(), 4.0);
  }
}

TEST(QuadBlocks, OddRowsAreLeftSingle) {
  const QuadBlocks found = find_quad_blocks(FlatStrip{.columns = 5, .rows = 3}.make()->model->quads);
  EXPECT_EQ(found.blocks.size(), 2u);
  EXPECT_EQ(list_quads(found), count_up(15));
}

TEST(QuadBlocks, RingsOfAnyNumberAndCornersOfThreeHoldEachQuadOnce) {
  for (const int around : {4, 5, 8}) {
    std::vector<std::array<int, 4>> ring;
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < around; ++i) {
        const int a = j * around + i, b = j * around + (i + 1) % around;
        ring.push_back({a, b, b + around, a + around});
      }
    const QuadBlocks found = find_quad_blocks(ring);
    EXPECT_EQ(list_quads(found), count_up(ring.size())) << around;
    // Where the ring closes, rows and columns disagree and quads stay single.
    EXPECT_GE(static_cast<int>(found.blocks.size()), around / 2 - 1) << around;
  }
  // The corner of a cube: three quads around node 0.
  const std::vector<std::array<int, 4>> corner{{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}};
  EXPECT_EQ(list_quads(find_quad_blocks(corner)), count_up(3));
}

TEST(CoarseWall, HasTheSameAreaInAQuarterOfTheQuads) {
  const FlatStrip strip{.columns = 8, .rows = 4};
  const auto snapshot = strip.make();
  const SheetShape sheet(*snapshot, false);
  const Surface fine = sheet.make_wall(*snapshot, std::nullopt);
  const Surface coarse = sheet.make_wall(*snapshot, std::nullopt, true);
  const std::size_t rim = 2u * (8u + 4u);
  EXPECT_EQ(fine.polygons.size(), 2u * 32u + rim);
  EXPECT_EQ(coarse.polygons.size(), 2u * 8u + rim);
  EXPECT_NEAR(calc_area(coarse), calc_area(fine), 1e-5);
  EXPECT_EQ(sheet.make_element_edges(*snapshot).lines.size(), 2u * (5u * 8u + 9u * 4u));
  EXPECT_EQ(sheet.make_element_edges(*snapshot, true).lines.size(), 2u * (3u * 4u + 5u * 2u));
}

TEST(CoarseWall, OneNodeOfAnotherClassIsNotLost) {
  const FlatStrip strip{.columns = 8, .rows = 4};
  const auto snapshot = strip.make();
  const SheetShape sheet(*snapshot, false);
  const auto calc_class_area = [&](const Surface& wall, ContactClass wanted) {
    Surface part = wall;
    part.polygons.clear();
    for (const auto& p : wall.polygons)
      if (wall.colours[static_cast<std::size_t>(p[0])] == class_colour(wanted)) part.polygons.push_back(p);
    return calc_area(part);
  };
  // In the middle of a square of two by two, and on its corner.
  for (const int node : {strip.node(3, 1), strip.node(4, 2)}) {
    auto classes = snapshot->contact_state;
    classes[static_cast<std::size_t>(node)] = ContactClass::kDetachedNow;
    const Surface wall = sheet.make_wall(*snapshot, NodePaint{.values = {}, .classes = classes}, true);
    EXPECT_NEAR(calc_class_area(wall, ContactClass::kDetachedNow), 2.0 * 1.0, 1e-5) << node;
  }
}

TEST(WallSection, IsAsLargeAsWidthTimesThickness) {
  const auto snapshot = FlatStrip{}.make();
  for (const double x : {0.3, 1.7, 2.0, 3.999}) {  // also through nodes
    const WallSection section = calc_wall_section(*snapshot, {Reflection{}}, {Vec3(x, 0, 0), Vec3::UnitX()});
    EXPECT_NEAR(calc_area(section.area), 2.0 * 0.2, 1e-6) << x;
    for (const Vec3f& p : section.area.points) EXPECT_NEAR(p.x(), x, 1e-6);
    double length = 0.0;
    for (const auto& line : section.borders.lines)
      length += static_cast<double>((section.borders.points[static_cast<std::size_t>(line[0])] -
                                     section.borders.points[static_cast<std::size_t>(line[1])])
                                        .norm());
    EXPECT_NEAR(length, 2.0 * 2.0, 1e-5) << "on both faces";
  }
  EXPECT_TRUE(
      calc_wall_section(*snapshot, {Reflection{}}, {Vec3(5, 0, 0), Vec3::UnitX()}).area.points.empty());
}

TEST(WallSection, OnAPlaneOfSymmetryItIsThereOnceOnEitherSide) {
  FlatStrip strip;
  strip.mirrors = {{Vec3::Zero(), Vec3(-1, 0, 0)}};
  const auto snapshot = strip.make();
  // Rounding moves the nodes on the plane to either side.
  for (const double noise : {-1e-15, 0.0, 1e-15}) {
    for (int row = 0; row <= 2; ++row)
      snapshot->points[static_cast<std::size_t>(strip.node(0, row))].x() = noise;
    for (const double side : {1.0, -1.0}) {
      const WallSection section = calc_wall_section(*snapshot, calc_reflections(snapshot->model->mirrors),
                                                    {Vec3::Zero(), side * Vec3::UnitX()});
      EXPECT_NEAR(calc_area(section.area), 2.0 * 0.2, 1e-6) << noise << " " << side;
    }
  }
}

}  // namespace
}  // namespace hydroscope
