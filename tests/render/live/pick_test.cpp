// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/live/pick.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/live/live_camera.h"
#include "solver/base/error.h"
#include "tests/render/live/live_scene.h"

namespace hydroscope {
namespace {

using testing::ElementsAre;

/// Millimetres a pixel.
double calc_pixel(const LiveView& view, const Snapshot& first) {
  return 2.0 * calc_live_camera(view, calc_live_bounds(first, view.is_mirrored)).scale / view.height;
}

class PickOnStrip : public testing::Test {
 protected:
  /// Looks along -z so that (x, y) lies in the middle of the picture.
  LiveView look_at(double x, double y) const {
    LiveView view = make_front_view();
    view.focus = Vec3(x, y, 0.0);
    return view;
  }
  std::optional<Pick> pick_middle(const LiveView& view, double right = 0.0, double down = 0.0) const {
    return pick_point(view, *snapshot, *snapshot, 160.0 + right, 90.0 + down);
  }

  FlatStrip strip;
  std::shared_ptr<Snapshot> snapshot = strip.make();
};

TEST_F(PickOnStrip, FindsPlaceElementAndNearestNode) {
  const auto pick = pick_middle(look_at(1.2, 0.9));
  ASSERT_TRUE(pick);
  EXPECT_NEAR((pick->place - Vec3(1.2, 0.9, 0.1)).norm(), 0.0, 1e-9) << "on the outer face";
  EXPECT_EQ(pick->element, 1);
  EXPECT_EQ(pick->node, strip.node(1, 1));
  EXPECT_EQ(pick->image, 0);
}

TEST_F(PickOnStrip, FromBehindItIsTheInnerFace) {
  LiveView view = look_at(2.8, 1.3);
  view.azimuth = 270.0;
  const auto pick = pick_middle(view);
  ASSERT_TRUE(pick);
  EXPECT_NEAR((pick->place - Vec3(2.8, 1.3, -0.1)).norm(), 0.0, 1e-9);
  EXPECT_EQ(pick->node, strip.node(3, 1));
}

TEST_F(PickOnStrip, PixelsRunToTheRightAndDown) {
  const LiveView view = look_at(2.0, 1.0);
  const double pixel = calc_pixel(view, *snapshot);
  const auto pick = pick_middle(view, 0.6 / pixel, -0.4 / pixel);
  ASSERT_TRUE(pick);
  EXPECT_NEAR(pick->place.x(), 2.6, 1e-9);
  EXPECT_NEAR(pick->place.y(), 1.4, 1e-9);
}

TEST_F(PickOnStrip, BesideTheStripThereIsNothing) {
  EXPECT_TRUE(pick_middle(look_at(3.999, 1.0)));
  EXPECT_FALSE(pick_middle(look_at(4.001, 1.0)));
  EXPECT_FALSE(pick_middle(look_at(2.0, -0.001)));
}

TEST_F(PickOnStrip, ARectangleHoldsTheNodesInIt) {
  const LiveView view = look_at(2.0, 1.0);
  const double pixel = calc_pixel(view, *snapshot);
  const auto x = [&](double place) { return 160.0 + (place - 2.0) / pixel; };
  const auto y = [&](double place) { return 90.0 - (place - 1.0) / pixel; };
  const auto nodes = pick_rectangle(view, *snapshot, *snapshot, x(0.5), y(1.5), x(2.5), y(-1.0));
  EXPECT_THAT(nodes, ElementsAre(strip.node(1, 0), strip.node(2, 0), strip.node(1, 1), strip.node(2, 1)));
  // Corners in any order.
  EXPECT_EQ(pick_rectangle(view, *snapshot, *snapshot, x(2.5), y(1.5), x(0.5), y(-1.0)), nodes);
  EXPECT_TRUE(pick_rectangle(view, *snapshot, *snapshot, x(1.2), y(0.8), x(1.8), y(0.2)).empty());
}

TEST_F(PickOnStrip, OnlyWhatThePictureShowsIsInARectangle) {
  LiveView view = look_at(0.0, 0.0);
  view.zoom = 40.0;  // one node in the picture
  EXPECT_THAT(pick_rectangle(view, *snapshot, *snapshot, -1e5, -1e5, 1e5, 1e5), ElementsAre(0));
}

TEST_F(PickOnStrip, AMirrorImageLeadsToTheModelledNode) {
  strip.mirrors = {{Vec3::Zero(), Vec3(-1, 0, 0)}};
  snapshot = strip.make();
  LiveView view = look_at(-1.2, 0.9);
  auto pick = pick_middle(view);
  ASSERT_TRUE(pick);
  EXPECT_EQ(pick->node, strip.node(1, 1));
  EXPECT_EQ(pick->element, 1);
  EXPECT_EQ(pick->image, 1);
  EXPECT_NEAR(pick->place.x(), -1.2, 1e-9) << "where it is drawn";
  view.is_mirrored = false;
  EXPECT_FALSE(pick_middle(view));
  // Each node once, though two images of it are seen.
  const auto nodes = pick_rectangle(make_front_view(), *snapshot, *snapshot, 0, 0, 320, 180);
  EXPECT_EQ(nodes.size(), snapshot->points.size());
}

TEST_F(PickOnStrip, WhatTheClipPlaneTakesIsNotPicked) {
  LiveView view = look_at(1.2, 0.9);
  view.clip_axis = 0;
  view.clip_share = 0.5;  // x = 2: the larger x are taken
  EXPECT_TRUE(pick_middle(view));
  view.clip_flip = true;
  EXPECT_FALSE(pick_middle(view));
  for (const int node : pick_rectangle(view, *snapshot, *snapshot, 0, 0, 320, 180))
    EXPECT_GE(snapshot->points[static_cast<std::size_t>(node)].x(), 2.0);
}

TEST_F(PickOnStrip, AViewThatCannotBeIsRefused) {
  LiveView view = make_front_view();
  view.zoom = -1.0;
  EXPECT_THROW(pick_point(view, *snapshot, *snapshot, 0, 0), InputError);
  EXPECT_THROW(pick_rectangle(view, *snapshot, *snapshot, 0, 0, 9, 9), InputError);
}

/// A closed tube around the y axis, without mirror planes.
class PickOnTube : public testing::Test {
 protected:
  PickOnTube() {
    auto model = std::make_shared<SnapshotModel>();
    for (int j = 0; j <= kAlong; ++j)
      for (int i = 0; i < kAround; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + 0.5) / kAround;
        snapshot.directors.push_back(Vec3(std::sin(angle), 0.0, std::cos(angle)));
        snapshot.points.push_back(kRadius * snapshot.directors.back() + 5.0 * j * Vec3::UnitY());
        snapshot.thickness.push_back(kThickness);
      }
    for (int j = 0; j < kAlong; ++j)
      for (int i = 0; i < kAround; ++i) {
        const int a = j * kAround + i, b = j * kAround + (i + 1) % kAround;
        model->quads.push_back({a, b, b + kAround, a + kAround});
      }
    snapshot.model = std::move(model);
    fill_fields(snapshot);
  }
  /// Seen over the picture's middle, `x` mm to the right of the axis.
  std::optional<Pick> pick_at(const LiveView& view, double x) const {
    LiveView moved = view;
    moved.focus = Vec3(x, 12.0, 0.0);
    return pick_point(moved, snapshot, snapshot, 160, 90);
  }
  double facing(int node) const { return snapshot.directors[static_cast<std::size_t>(node)].z(); }

  static constexpr int kAround = 120, kAlong = 5;
  static constexpr double kRadius = 10.0, kThickness = 0.8;
  static constexpr double kSagitta = 0.005;  // > R (1 - cos(pi / 120)) = 0.0034 mm, seen head on
  Snapshot snapshot;
};

TEST_F(PickOnTube, MeetsTheFrontOfTheOuterFace) {
  const double outer = kRadius + 0.5 * kThickness;
  for (const double x : {-7.0, -2.0, 0.3, 5.0}) {
    const auto pick = pick_at(make_front_view(), x);
    ASSERT_TRUE(pick);
    EXPECT_NEAR(pick->place.z(), std::sqrt(outer * outer - x * x), 1.5 * kSagitta) << x;
    EXPECT_GT(facing(pick->node), 0.0);
  }
  EXPECT_FALSE(pick_at(make_front_view(), outer + 0.01));
}

TEST_F(PickOnTube, ClippedItShowsTheInnerFaceBehind) {
  const double inner = kRadius - 0.5 * kThickness;
  LiveView view = make_front_view();
  view.clip_axis = 2;
  view.clip_share = 0.5;  // z = 0, the front is taken
  for (const double x : {-7.0, 0.3, 5.0}) {
    const auto pick = pick_at(view, x);
    ASSERT_TRUE(pick);
    EXPECT_NEAR(pick->place.z(), -std::sqrt(inner * inner - x * x), 1.5 * kSagitta) << x;
  }
}

TEST_F(PickOnTube, ARectangleLeavesOutTheNodesBehind) {
  const LiveView view = make_front_view();
  const auto seen = pick_rectangle(view, snapshot, snapshot, 0, 0, 320, 180);
  for (int node = 0; node < static_cast<int>(snapshot.points.size()); ++node) {
    const bool is_seen = std::binary_search(seen.begin(), seen.end(), node);
    // At the outline the polygons decide.
    if (std::abs(facing(node)) > 0.03) {
      EXPECT_EQ(is_seen, facing(node) > 0.0) << node;
    }
  }
}

TEST_F(PickOnTube, TheClipPlaneUncoversTheNodesBehind) {
  LiveView view = make_front_view();
  view.clip_axis = 2;
  const auto seen = pick_rectangle(view, snapshot, snapshot, 0, 0, 320, 180);
  for (int node = 0; node < static_cast<int>(snapshot.points.size()); ++node) {
    const bool is_seen = std::binary_search(seen.begin(), seen.end(), node);
    if (std::abs(facing(node)) > 0.03) {
      EXPECT_EQ(is_seen, facing(node) < 0.0) << node;
    }
  }
}

}  // namespace
}  // namespace hydroscope
