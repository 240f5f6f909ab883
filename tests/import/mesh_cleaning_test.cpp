// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/mesh_cleaning.h"

#include <gtest/gtest.h>

#include <random>

namespace hydroscope {
namespace {

TEST(WeldPoints, FindsTheFirstPointWithinTheTolerance) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1e-4}, {1, 2e-3, 0}, {-9e-4, 0, 0}};
  EXPECT_EQ(weld_points(points, 1e-3), (std::vector<int>{0, 1, 0, 3, 0}));
}

TEST(WeldPoints, WeldsAcrossTheBordersOfItsCells) {
  // The same random points again, each moved by less than the tolerance, in any direction.
  std::mt19937 dice(3);
  const auto number = [&] { return static_cast<double>(dice()) / 4294967296.0; };
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(number(), number(), number());
  for (int i = 0; i < 500; ++i) {
    points.push_back(points[static_cast<std::size_t>(i)] +
                     0.5e-3 * Vec3(number() - 0.5, number() - 0.5, number() - 0.5));
  }
  const std::vector<int> first = weld_points(points, 1e-3);
  for (int i = 0; i < 500; ++i) {
    EXPECT_EQ(first[static_cast<std::size_t>(500 + i)], first[static_cast<std::size_t>(i)]);
  }
}

TEST(WeldTolerance, GrowsWithSizeAndDistance) {
  const double near = calc_weld_tolerance({{0, 0, 0}, {100, 0, 0}});
  EXPECT_GT(near, 1e-5);  // above what single precision blurs at 100 mm: 4e-6
  EXPECT_LT(near, 1e-3);  // below any facet that matters
  EXPECT_GT(calc_weld_tolerance({{1e5, 0, 0}, {1e5 + 100, 0, 0}}), 0.01);
}

TEST(SplitPolygons, FansLargerPolygons) {
  PolygonSoup soup;
  for (int i = 0; i < 6; ++i) soup.points.emplace_back(std::cos(i * 1.0472), std::sin(i * 1.0472), 0);
  soup.polygons = {{0, 1, 2, 3, 4, 5}, {0, 1}, {0, 1, 2}};
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> quad_of;
  EXPECT_EQ(split_polygons(soup, triangles, quad_of), 1);
  EXPECT_EQ(triangles.size(), 5u);
  EXPECT_EQ(quad_of, std::vector<int>(5, -1));
}

TEST(SplitPolygons, RemembersQuads) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  soup.polygons = {{0, 1, 2}, {0, 1, 2, 3}, {1, 4, 5, 2}};
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> quad_of;
  split_polygons(soup, triangles, quad_of);
  EXPECT_EQ(quad_of, (std::vector<int>{-1, 0, 0, 1, 1}));
}

TEST(CleanMesh, PairsTheHalvesOfQuadsThatAreBothKept) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  // The second quad has lost a corner, the third is one side of the first again.
  soup.polygons = {{0, 1, 2, 3}, {1, 4, 4, 2}, {1, 4, 5, 2}};
  const CleanedMesh cleaned = clean_mesh(soup);
  EXPECT_EQ(cleaned.mesh.triangles.size(), 5u);
  EXPECT_EQ(cleaned.quads, (std::vector<std::array<int, 2>>{{0, 1}, {3, 4}}));
}

TEST(CleanMesh, ClosesACubeWrittenAsSixSeparateQuads) {
  PolygonSoup soup;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side : {0, 1}) {
      std::vector<int> quad;
      for (int k = 0; k < 4; ++k) {
        Vec3 p;
        p[axis] = side;
        p[(axis + 1) % 3] = (k == 1 || k == 2) ? 1 : 0;
        p[(axis + 2) % 3] = k >= 2 ? 1 : 0;
        quad.push_back(static_cast<int>(soup.points.size()));
        soup.points.push_back(p);
      }
      if (side == 0) std::swap(quad[1], quad[3]);
      soup.polygons.push_back(quad);
    }
  }
  const CleanedMesh cleaned = clean_mesh(soup);
  EXPECT_EQ(cleaned.mesh.points.size(), 8u);
  EXPECT_EQ(cleaned.points_welded, 16);
  EXPECT_EQ(cleaned.polygons_split, 6);
  EXPECT_EQ(cleaned.mesh.triangles.size(), 12u);
}

TEST(CleanMesh, DropsFacetsThinnerThanTheTolerance) {
  PolygonSoup soup;
  soup.points = {{0, 0, 0}, {100, 0, 0}, {50, 1e-6, 0}, {50, 30, 0}};
  soup.polygons = {{0, 1, 2}, {0, 1, 3}};
  const CleanedMesh cleaned = clean_mesh(soup);
  EXPECT_EQ(cleaned.degenerate_dropped, 1);
  EXPECT_EQ(cleaned.mesh.points.size(), 3u);
}

}  // namespace
}  // namespace hydroscope
