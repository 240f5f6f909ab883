// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

Bounds make_box() {
  Bounds bounds;
  bounds.include(Vec3(-20, -10, -50));
  bounds.include(Vec3(20, 10, 50));
  return bounds;
}

/// Whether all corners of the box are in the picture.
bool holds(const CameraPose& camera, const Bounds& box, double aspect) {
  const Vec3 direction = (camera.position - camera.focal).normalized();
  const Vec3 right = camera.up.cross(direction).normalized(), upright = direction.cross(right);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 x((corner & 1) != 0 ? box.least.x() : box.greatest.x(),
                 (corner & 2) != 0 ? box.least.y() : box.greatest.y(),
                 (corner & 4) != 0 ? box.least.z() : box.greatest.z());
    if (std::abs(right.dot(x - camera.focal)) > aspect * camera.scale) return false;
    if (std::abs(upright.dot(x - camera.focal)) > camera.scale) return false;
  }
  return true;
}

TEST(Camera, HoldsTheBoxFromEveryDirection) {
  FrameOptions options;
  for (double azimuth = 0.0; azimuth < 360.0; azimuth += 30.0)
    for (double elevation : {-90.0, -40.0, 0.0, 25.0, 90.0}) {
      options.azimuth = azimuth;
      options.elevation = elevation;
      EXPECT_TRUE(holds(calc_camera(options, make_box(), std::nullopt, 0, 1), make_box(), 1280.0 / 720.0))
          << azimuth << " " << elevation;
    }
}

TEST(Camera, StandsStillWhenFixed) {
  const FrameOptions options;
  const CameraPose first = calc_camera(options, make_box(), std::nullopt, 0, 10);
  const CameraPose last = calc_camera(options, make_box(), std::nullopt, 9, 10);
  EXPECT_EQ(first.position, last.position);
  EXPECT_EQ(first.scale, last.scale);
}

TEST(Camera, AnOrbitTurnsEvenlyKeepsItsScaleAndHoldsTheBox) {
  FrameOptions options;
  options.camera = "orbit";
  const double scale = calc_camera(options, make_box(), std::nullopt, 0, 8).scale;
  for (int i = 0; i < 8; ++i) {
    const CameraPose camera = calc_camera(options, make_box(), std::nullopt, i, 8);
    EXPECT_EQ(camera.scale, scale);
    EXPECT_TRUE(holds(camera, make_box(), 1280.0 / 720.0));
    const Vec3 direction = camera.position - camera.focal;
    const double angle = std::atan2(direction.z(), direction.x()) * 180.0 / std::numbers::pi;
    EXPECT_NEAR(std::remainder(angle - 35.0 - 45.0 * i, 360.0), 0.0, 1e-9);
  }
}

TEST(Camera, FollowsTheNodeItLooksAt) {
  FrameOptions options;
  options.camera = "look-at";
  options.zoom = 4.0;
  const CameraPose camera = calc_camera(options, make_box(), Vec3(1, 2, 3), 0, 1);
  EXPECT_EQ(camera.focal, Vec3(1, 2, 3));
  options.zoom = 1.0;
  EXPECT_DOUBLE_EQ(4.0 * camera.scale, calc_camera(options, make_box(), Vec3(1, 2, 3), 0, 1).scale);
}

TEST(Camera, TheCutTakesTheViewersHalf) {
  FrameOptions options;
  for (double azimuth : {0.0, 35.0, 80.0, 200.0, 290.0}) {
    options.azimuth = azimuth;
    const CameraPose camera = calc_camera(options, make_box(), std::nullopt, 0, 1);
    const Plane cut = calc_cut(options, camera, make_box());
    EXPECT_GT(cut.normal.dot(camera.position - camera.focal), 0.0);
    EXPECT_EQ(cut.normal.cwiseAbs().maxCoeff(), 1.0) << "along a coordinate direction";
  }
}

TEST(Camera, RefusesValuesOutOfRange) {
  const auto check = [](auto change) {
    FrameOptions options;
    change(options);
    EXPECT_THROW(check_camera(options, 10), InputError);
  };
  check([](FrameOptions& o) { o.camera = "orbital"; });
  check([](FrameOptions& o) { o.zoom = 0.0; });
  check([](FrameOptions& o) { o.elevation = 91.0; });
  check([](FrameOptions& o) { o.size = {10, 720}; });
  check([](FrameOptions& o) { o.camera = "look-at", o.look_at_node = 10; });
  FrameOptions good;
  EXPECT_NO_THROW(check_camera(good, 10));
}

}  // namespace
}  // namespace hydroscope
