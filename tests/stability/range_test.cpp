// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/stability/gallery.h"
#include "tests/verification/plane_strain_ring.h"

namespace hydroscope::stability {
namespace {

using verification::WallState;

// V10 without bending, R/t = 500.
TEST(StabilityRange, ThinShellFollowsTheMembrane) {
  const History h = run_gallery("thin-shell.toml");
  ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  const verification::PlaneStrainWall wall(verification::kM2, 0.25);
  for (const double rho : {20.0, 15.0, 12.0, 9.0}) {
    const double quarter = std::numbers::pi / 4.0;
    const WallState s = wall.at(std::log((30.0 - rho * (1.0 - quarter)) / (quarter * 30.0)));
    const double t = 0.06 * std::exp(-s.thinning), p = s.hoop_stress * t / rho;
    EXPECT_LT(relative_error(h.value_at("pressure", "rho_mm", rho), p), 0.015) << rho;
    EXPECT_LT(relative_error(h.value_at("t_corner_mm", "rho_mm", rho), t), 0.005) << rho;
    RecordProperty("errors_rho" + std::to_string(static_cast<int>(rho)),
                   std::to_string(h.value_at("pressure", "rho_mm", rho) / p - 1.0) + " " +
                       std::to_string(h.value_at("t_corner_mm", "rho_mm", rho) / t - 1.0));
  }
}

// With friction the pseudo-stick stiffness counts against that of the wall between two nodes: 100 times the
// default ends early. Corner thickness lies between that without friction and the sticking limit.
TEST(StabilityRange, ThinShellWithFrictionNeedsASoftStick) {
  const std::vector<std::string> keys = {"tool.die.friction=0.1", "tube.elements_around=36"};
  std::vector<std::string> stiff = keys, soft = keys;
  stiff.emplace_back("contact.stick_stiffness=10");
  soft.emplace_back("contact.stick_stiffness=0.001");
  const History naive = run_gallery("thin-shell.toml", stiff), h = run_gallery("thin-shell.toml", soft);
  EXPECT_NE(naive.summary.outcome, Outcome::kCompleted);
  ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  const double t = h.value_at("t_corner_mm", "rho_mm", 9.0);
  EXPECT_GT(t, 0.06 * std::pow(9.0 / 30.0, 4.0 / std::numbers::pi - 1.0));
  EXPECT_LT(t, 0.0495);
  RecordProperty("end_of_naive", std::to_string(naive.rows.back().pressure));
  RecordProperty("t_corner", std::to_string(t));
}

/// Largest pressure against the limit pressure of the tube as it then is: (2/sqrt 3) sigma_y ln(b/a) (V7).
double calc_limit_ratio(const History& history) {
  const std::vector<double> radius = history.column("r_mm");
  std::size_t top = 0;
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    if (history.rows[i].pressure > history.rows[top].pressure) top = i;
  }
  const double r = radius[top], t = 6.0 * 30.0 / r;  // the plastic wall keeps its volume, in plane strain
  const double limit = 2.0 / std::numbers::sqrt3 * 240.0 * std::log((r + 0.5 * t) / (r - 0.5 * t));
  return history.rows[top].pressure / limit;
}

// The pressure works on the inner face and presses through the wall: both, or neither.
TEST(StabilityRange, ThickShellNeedsBothOrNeither) {
  const double surface_only =
                   calc_limit_ratio(run_gallery("thick-shell.toml", {"shell.through_wall_stress=off"})),
               stress_only = calc_limit_ratio(run_gallery("thick-shell.toml", {"load.pressure_surface=mid"})),
               neither = calc_limit_ratio(run_gallery(
                   "thick-shell.toml", {"load.pressure_surface=mid", "shell.through_wall_stress=off"})),
               both = calc_limit_ratio(run_gallery("thick-shell.toml"));
  EXPECT_GT(surface_only, 1.08);
  EXPECT_LT(stress_only, 0.92);
  EXPECT_NEAR(neither, 1.0, 0.005);
  EXPECT_NEAR(both, 1.0, 0.005);
  RecordProperty("ratios", std::to_string(surface_only) + " " + std::to_string(stress_only) + " " +
                               std::to_string(neither) + " " + std::to_string(both));
}

// Increments may be half of the way; the fine run of 500 is the measure. With the limits off and the
// corrector given all the passes it wants, the wall is thrown into the corner: an equilibrium, but not this
// one.
TEST(StabilityRange, IncrementsWithoutLimitsFindAnotherEquilibrium) {
  const std::vector<std::string> unlimited = {"increment.max_strain=1", "increment.max_rotation_deg=90",
                                              "increment.max_slide=100", "increment.max_penetration=10",
                                              "increment.max_iterations=100"};
  const History naive = run_gallery("large-increments.toml", unlimited),
                limited = run_gallery("large-increments.toml");
  const History fine =
      run_gallery("large-increments.toml", {"increment.largest=0.005", "increment.initial_s=0.001"});
  for (const History* h : {&naive, &limited, &fine}) ASSERT_EQ(h->summary.outcome, Outcome::kCompleted);
  const double wanted = fine.column("t_corner_mm").back(), r45 = fine.column("r45_mm").back();
  EXPECT_GT(relative_error(naive.column("t_corner_mm").back(), wanted), 0.02);
  EXPECT_GT(relative_error(naive.column("r45_mm").back(), r45), 0.08);
  EXPECT_LT(relative_error(limited.column("t_corner_mm").back(), wanted), 0.002);
  EXPECT_LT(relative_error(limited.column("r45_mm").back(), r45), 0.005);
  EXPECT_LT(limited.summary.increments, 40);
  RecordProperty("t_corner", std::to_string(naive.column("t_corner_mm").back()) + " " +
                                 std::to_string(limited.column("t_corner_mm").back()) + " " +
                                 std::to_string(wanted));
  RecordProperty("increments", std::to_string(naive.summary.increments) + " " +
                                   std::to_string(limited.summary.increments) + " " +
                                   std::to_string(fine.summary.increments));
}

}  // namespace
}  // namespace hydroscope::stability
