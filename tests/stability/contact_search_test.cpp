// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/stability/gallery.h"

namespace hydroscope::stability {
namespace {

constexpr double kDieRadius = 20.5;  // [mm] of the dies' edges

/// Largest distance of the outer face from the axis in the last good state [mm].
double calc_reach(const History& history) {
  const std::vector<double> radii = calc_face_radii(*history.states.back(), 1.0);
  return *std::max_element(radii.begin(), radii.end());
}

// Each node runs into a concave edge. The wedge behind it is over no facet: the first increment that
// overshoots, as all do, ends there. Nothing ever touches, and the tube bursts as if there were no die.
TEST(StabilitySearch, OrthogonalProjectionLosesNodesInConcaveEdges) {
  const History naive = run_gallery("concave-corner.toml", {"tool.die.projection=orthogonal"});
  EXPECT_EQ(naive.summary.outcome, Outcome::kPressureMaximum) << naive.summary.message;
  EXPECT_EQ(count_events(naive, EventKind::kTouch), 0);
  EXPECT_GT(calc_reach(naive), kDieRadius + 0.5);

  const History prisms = run_gallery("concave-corner.toml");
  ASSERT_EQ(prisms.summary.outcome, Outcome::kCompleted) << prisms.summary.message;
  EXPECT_EQ(count_events(prisms, EventKind::kTouch), 14);
  EXPECT_EQ(count_events(prisms, EventKind::kDetach), 0);
  EXPECT_NEAR(calc_reach(prisms), kDieRadius, 0.001);
  RecordProperty("reach", std::to_string(calc_reach(naive)) + " " + std::to_string(calc_reach(prisms)));
}

// Every node stands 0.1 mm beyond the rim of its die, the wall is 1 mm thick.
TEST(StabilitySearch, NodesJustBeyondTheRimAreHeld) {
  const History naive = run_gallery("narrow-die.toml", {"tool.die.projection=orthogonal"});
  EXPECT_EQ(naive.summary.outcome, Outcome::kPressureMaximum) << naive.summary.message;
  EXPECT_EQ(count_events(naive, EventKind::kTouch), 0);
  EXPECT_GT(calc_reach(naive), kDieRadius + 0.5);

  const History held = run_gallery("narrow-die.toml");
  ASSERT_EQ(held.summary.outcome, Outcome::kCompleted) << held.summary.message;
  EXPECT_EQ(count_events(held, EventKind::kDetach), 0);
  EXPECT_LT(calc_reach(held), kDieRadius + 0.001);
  RecordProperty("reach", std::to_string(calc_reach(naive)) + " " + std::to_string(calc_reach(held)));
}

// The die is drawn away along z: a node that is up to half of the thickness beyond its rim is kept,
// then let go, once, and told as what it is.
TEST(StabilitySearch, NodesSlideOffARimOnce) {
  const std::string still = "tool.die.motion_mm=[[0, 0, 0, 0], [0.9, 0, 0, 0], [1, 0, 0, ";
  const History inside = run_gallery("narrow-die.toml", {still + "0.35]]"});
  EXPECT_EQ(inside.summary.outcome, Outcome::kCompleted) << inside.summary.message;
  EXPECT_EQ(count_events(inside, EventKind::kDetach), 0);
  const History outside = run_gallery("narrow-die.toml", {still + "0.45]]"});
  EXPECT_EQ(outside.summary.outcome, Outcome::kCompleted) << outside.summary.message;
  EXPECT_EQ(count_events(outside, EventKind::kDetach, "edge"), 7);
  EXPECT_EQ(count_events(outside, EventKind::kDetach), 7);
  EXPECT_EQ(count_events(outside, EventKind::kRetouch), 0);
}

// A hole, T-joints and slivers: the wall rests on what there is. Found by orthogonal projection it
// does not touch at all (its nodes stand over edges again).
TEST(StabilitySearch, BadMeshesHold) {
  const History naive =
      run_gallery("bad-mesh.toml", {"tool.die.surface=facets", "tool.die.projection=orthogonal"});
  EXPECT_NE(naive.summary.outcome, Outcome::kCompleted);
  EXPECT_GT(calc_reach(naive), kDieRadius + 0.5);
  for (const char* surface : {"smooth", "facets", "nagata"}) {
    const History held = run_gallery("bad-mesh.toml", {"tool.die.surface=" + std::string(surface)});
    ASSERT_EQ(held.summary.outcome, Outcome::kCompleted) << surface << ": " << held.summary.message;
    const std::vector<double> radii = calc_face_radii(*held.states.back(), 1.0);
    const auto [low, high] = std::minmax_element(radii.begin(), radii.end());
    EXPECT_GT(*low, kDieRadius - 0.01) << surface;
    EXPECT_LT(*high, kDieRadius + 0.02) << surface;  // at the hole
    RecordProperty(std::string("radii_") + surface, std::to_string(*low) + " to " + std::to_string(*high));
  }
}

}  // namespace
}  // namespace hydroscope::stability
