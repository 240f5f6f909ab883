// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/reflection.h"

#include <gtest/gtest.h>

#include "render/shape/surface.h"

namespace hydroscope {
namespace {

const Plane kX{Vec3::Zero(), Vec3::UnitX()};
const Plane kDiagonal{Vec3::Zero(), Vec3(1.0, -1.0, 0.0).normalized()};

TEST(Reflection, WithoutMirrorsIsThePieceItself) {
  const auto all = calc_reflections({});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].point(Vec3(1, 2, 3)), Vec3(1, 2, 3));
  EXPECT_FALSE(all[0].flips);
}

TEST(Reflection, MovesPointsAboutAPlaneOffTheOriginButVectorsOnlyTurn) {
  const auto all = calc_reflections({{Vec3(5, 0, 0), Vec3::UnitX()}});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].point(Vec3(1, 2, 3)), Vec3(9, 2, 3));
  EXPECT_EQ(all[1].vector(Vec3(1, 2, 3)), Vec3(-1, 2, 3));
  EXPECT_TRUE(all[1].flips);
}

TEST(Reflection, AnOctantMakesEightCopiesInTheOrderOfItsPlanes) {
  // A point of the octant 0..45 degrees: x > y > 0.
  const auto all = calc_reflections({kDiagonal, kX, {Vec3::Zero(), Vec3::UnitY()}});
  ASSERT_EQ(all.size(), 8u);
  const Vec3 p(3, 1, 2);
  EXPECT_TRUE(all[1].point(p).isApprox(Vec3(1, 3, 2), 1e-14));
  EXPECT_TRUE(all[2].point(p).isApprox(Vec3(-3, 1, 2), 1e-14));
  EXPECT_TRUE(all[3].point(p).isApprox(Vec3(-1, 3, 2), 1e-14));  // first the diagonal, then x
  EXPECT_FALSE(all[3].flips);
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT((all[i].point(p) - all[j].point(p)).norm(), 0.5);
}

TEST(Reflection, PolygonsOfAMirrorImageStillTurnCounterClockwise) {
  Surface piece;
  for (const Vec3& x : {Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(1, 1, 0)})
    piece.add_point(x, Vec3::UnitZ());
  piece.polygons = {{0, 1, 2, 3}, {0, 1, 2, -1}};
  const Surface whole = calc_reflected(piece, calc_reflections({kX}));
  ASSERT_EQ(whole.polygons.size(), 4u);
  for (const auto& polygon : whole.polygons) {
    const auto x = [&](std::size_t k) { return whole.points[static_cast<std::size_t>(polygon[k])]; };
    EXPECT_GT((x(1) - x(0)).cross(x(2) - x(0)).z(), 0.0f);
  }
  EXPECT_EQ(whole.polygons[3][3], -1);
}

TEST(Reflection, AToolThatIsWholeAboutAPlaneIsNotDoubledThere) {
  const Plane y{Vec3::Zero(), Vec3::UnitY()};
  EXPECT_EQ(find_open_mirrors({kX, y}, {Vec3(0, -1, 0), Vec3(2, 1, 0)}).size(), 1u);
  // A margin beyond the plane is no other half.
  EXPECT_EQ(find_open_mirrors({kX}, {Vec3(-5.6, 0, 0), Vec3(36, 0, 0)}).size(), 1u);
}

TEST(Reflection, OpenMirrorsPointAwayFromTheTool) {
  EXPECT_EQ(find_open_mirrors({kX}, {Vec3(0, 0, 0), Vec3(2, 0, 0)})[0].normal, Vec3(-1, 0, 0));
  EXPECT_EQ(find_open_mirrors({kX}, {Vec3(0, 0, 0), Vec3(-2, 0, 0)})[0].normal, Vec3(1, 0, 0));
}

}  // namespace
}  // namespace hydroscope
