// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/surface_error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/geometry/analytic_surface.h"
#include "solver/geometry/mesh_surface.h"
#include "solver/geometry/nagata_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using testing::HasSubstr;

std::vector<Vec3> place_points(double radius) {
  std::vector<Vec3> points;
  for (int i = 0; i < 400; ++i) {
    const double a = 2 * std::numbers::pi * i / 400;
    points.emplace_back(radius * std::cos(a), radius * std::sin(a), 0.01 * i - 2);
  }
  return points;
}

TEST(SurfaceError, IsZeroAgainstItself) {
  const CylinderSurface exact(Pose{}, 10, Side::outside, 5);
  const SurfaceError error = measure_surface_error(exact, exact, place_points(10.3), 1.0);
  EXPECT_EQ(error.points, 400);
  EXPECT_EQ(error.lost, 0);
  EXPECT_EQ(error.gap_max, 0.0);
  EXPECT_EQ(error.normal_max, 0.0);
  EXPECT_EQ(error.curvature_rms, 0.0);
}

TEST(SurfaceError, OfADifferentRadiusAndAxis) {
  const CylinderSurface exact(Pose{}, 10, Side::outside, 5), wide(Pose{}, 10.2, Side::outside, 5);
  const SurfaceError gap = measure_surface_error(wide, exact, place_points(10.0), 1.0);
  EXPECT_NEAR(gap.gap_rms, 0.2, 1e-12);
  EXPECT_NEAR(gap.gap_max, 0.2, 1e-12);
  EXPECT_NEAR(gap.normal_max, 0.0, 1e-12);
  // The axis moved by 0.1 mm: normals turn by up to 0.1 / 10, rms that over sqrt 2.
  const CylinderSurface moved(make_pose({0, 0, 0}, {0.1, 0, 0}), 10, Side::outside, 5);
  const SurfaceError turn = measure_surface_error(moved, exact, place_points(10.0), 1.0);
  EXPECT_NEAR(turn.normal_max, 0.573, 0.001);
  EXPECT_NEAR(turn.normal_rms, 0.405, 0.001);
  EXPECT_NEAR(turn.gap_rms, 0.0707, 0.0001);
  EXPECT_THAT(format_surface_error(turn), HasSubstr("normal rms 0.405, max 0.573 deg"));
}

TEST(SurfaceError, CountsWhatIsLost) {
  const CylinderSurface exact(Pose{}, 10, Side::outside, 5);
  const TriangleMesh half = make_grid_mesh(37, 9, [](int i, int j) {
    const double a = std::numbers::pi * i / 36;
    return Vec3(10 * std::cos(a), 10 * std::sin(a), j - 4.0);
  });
  MeshSurfaceOptions options;
  options.projection = Projection::orthogonal;
  const SurfaceError error =
      measure_surface_error(MeshSurface(half, options), exact, place_points(10.3), 1.0);
  EXPECT_NEAR(error.lost, 200, 20);
  EXPECT_EQ(error.lost + error.points, 400);
}

TEST(SurfaceError, RanksTheFormsOnACylinder) {
  const CylinderSurface exact(Pose{}, 10, Side::outside, 5);
  const TriangleMesh mesh = make_grid_mesh(25, 5, [](int i, int j) {
    const double a = 2 * std::numbers::pi * (i % 24) / 24;
    return Vec3(10 * std::cos(a), 10 * std::sin(a), 2.0 * (j - 2));
  });
  const auto points = place_points(10.0);
  const SurfaceError own = measure_surface_error(MeshSurface(mesh, {NormalRule::facet}), exact, points, 1.0);
  const SurfaceError flat = measure_surface_error(MeshSurface(mesh), exact, points, 1.0);
  const SurfaceError bent = measure_surface_error(MeshSurface(mesh, {.is_smooth = true}), exact, points, 1.0);
  const SurfaceError nagata = measure_surface_error(NagataSurface(mesh), exact, points, 1.0);
  EXPECT_NEAR(own.normal_max, 7.5, 0.1);  // half of the facet angle
  EXPECT_LT(flat.normal_max, 0.2);
  EXPECT_GT(flat.gap_max, 0.05);
  EXPECT_LT(bent.gap_max, 0.02 * flat.gap_max);
  EXPECT_LT(nagata.gap_max, 0.02 * flat.gap_max);
  EXPECT_NEAR(own.curvature_rms, 0.1, 1e-3);  // facets have none
  EXPECT_LT(nagata.curvature_rms, 0.005);
}

}  // namespace
}  // namespace hydroscope
