// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/stability/gallery.h"

namespace hydroscope::stability {
namespace {

History run_behind(const std::string& r_safe) {
  return run_gallery("one-step-behind.toml", {"increment.correction=one-step-behind",
                                              "increment.r_safe=" + r_safe, "increment.smallest=1e-3"});
}

// r' = (1 - rho/R_safe) r + e: large R_safe leave a rest in proportion to R_safe, and the wall lags behind
// its load; below 1/2 each correction overshoots by more than it corrects.
TEST(StabilityCorrection, OneStepBehindStarvesAndOvershoots) {
  const History newton = run_gallery("one-step-behind.toml");
  ASSERT_EQ(newton.summary.outcome, Outcome::kCompleted) << newton.summary.message;
  const double r45 = newton.column("r45_mm").back();
  const History starved = run_behind("200"), overshooting = run_behind("0.3"), between = run_behind("2");
  EXPECT_GT(calc_median_residual(starved), 0.05);
  EXPECT_GT(relative_error(starved.column("r45_mm").back(), r45), 0.01);
  EXPECT_GT(overshooting.summary.increments, 4 * between.summary.increments);
  EXPECT_LT(calc_median_residual(between), 0.01);
  EXPECT_LT(relative_error(between.column("r45_mm").back(), r45), 0.002);
  for (const IncrementReport& row : newton.rows) EXPECT_LE(row.residual, 1e-3);
  RecordProperty("residuals", std::to_string(calc_median_residual(starved)) + " " +
                                  std::to_string(calc_median_residual(between)) + " " +
                                  std::to_string(calc_median_residual(newton)));
  RecordProperty("r45", std::to_string(starved.column("r45_mm").back()) + " " +
                            std::to_string(overshooting.column("r45_mm").back()) + " " +
                            std::to_string(between.column("r45_mm").back()) + " " + std::to_string(r45));
  RecordProperty("increments", std::to_string(overshooting.summary.increments) + " " +
                                   std::to_string(between.summary.increments) + " " +
                                   std::to_string(newton.summary.increments));
}

// Without friction the tensions differ by the chords' share of bending only, 0.8 to 0.9 %. Explicit steps
// that do not turn the force with the normal leave a part of it along the strip.
TEST(StabilityCorrection, ForceLeftBehindActsAsFriction) {
  const std::vector<std::string> behind = {"increment.largest=0.02", "increment.correction=one-step-behind",
                                           "increment.r_safe=1"};
  std::vector<std::string> flat = behind;
  flat.push_back("contact.curvature=none");
  const Range naive = calc_range(run_gallery("slide.toml", flat), "force_ratio", 0.25),
              turned = calc_range(run_gallery("slide.toml", behind), "force_ratio", 0.25),
              sound = calc_range(run_gallery("slide.toml", {"increment.largest=0.02"}), "force_ratio", 0.25);
  EXPECT_GT(naive.high, 1.03);
  EXPECT_LT(turned.high, 1.015);
  EXPECT_GT(sound.low, 1.007);
  EXPECT_LT(sound.high, 1.010);
  RecordProperty("ratios", std::to_string(naive.high) + " " + std::to_string(turned.high) + " " +
                               std::to_string(sound.low) + " to " + std::to_string(sound.high));
}

// The source's law keeps the force and its direction for one increment: after a turn friction pushes for a
// while instead of braking, and the tensions swing far beyond what friction can hold.
TEST(StabilityReversal, FrictionOneStepBehindSwings) {
  const double forward = std::exp(0.2 * std::numbers::pi / 2.0);
  const History h = run_gallery("reversal.toml", {"contact.friction_law=one-step-behind"});
  const Range on = calc_range(h, "force_ratio", 0.35, 1.0), turned = calc_range(h, "force_ratio", 1.0);
  EXPECT_LT(relative_error(on.high, forward), 0.02);  // one way, it is as good
  EXPECT_GT(turned.high, 2.0 * forward);
  EXPECT_LT(turned.low, 0.5 / forward);
  RecordProperty("ratio", std::to_string(turned.low) + " to " + std::to_string(turned.high));
}

double calc_deepest(const History& history) {
  const auto& gap = history.states.back()->gap;
  return -*std::min_element(gap.begin(), gap.end());
}

// A penalty is a spring. As soft as 27 N/mm per mm^2 it lets the wall half a millimetre into the die; as soft
// as 1e6 N/mm at the supports as well, the iteration does not end. At 1e40 it is the elimination.
TEST(StabilityCorrection, SoftPenaltiesPenetrateHardOnesAreElimination) {
  const std::string up = "load.pressure_MPa=[[0, 0], [1, 30]]", rigid = "contact.wall_stiffness=0",
                    penalty = "contact.constraint=penalty";
  const History soft = run_gallery("backed-wall.toml", {up, "contact.wall_stiffness=1e-4"});
  ASSERT_EQ(soft.summary.outcome, Outcome::kCompleted) << soft.summary.message;
  EXPECT_GT(calc_deepest(soft), 0.3);
  const History weak = run_gallery("backed-wall.toml", {up, rigid, penalty, "contact.penalty_N_per_mm=1e4"});
  EXPECT_NE(weak.summary.outcome, Outcome::kCompleted);

  const History hard = run_gallery("backed-wall.toml", {up, rigid, penalty}),
                eliminated = run_gallery("backed-wall.toml", {up, rigid});
  ASSERT_EQ(hard.summary.outcome, Outcome::kCompleted) << hard.summary.message;
  ASSERT_EQ(eliminated.summary.outcome, Outcome::kCompleted) << eliminated.summary.message;
  EXPECT_LT(calc_deepest(hard), 1e-6);
  EXPECT_LT(relative_error(hard.column("force_N_per_mm").back(), eliminated.column("force_N_per_mm").back()),
            1e-9);
  RecordProperty("penetration",
                 std::to_string(calc_deepest(soft)) + " " + std::to_string(calc_deepest(hard)));
  RecordProperty("weak", std::to_string(weak.rows.back().pressure) + " MPa: " + weak.summary.message);
}

}  // namespace
}  // namespace hydroscope::stability
