// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/stability/gallery.h"
#include "tests/verification/plane_strain_ring.h"

namespace hydroscope::stability {
namespace {

// V5: p = s_th t / r of a ring in plane strain; its largest value is 17.1332 MPa.
TEST(StabilityLimitPoints, PressureControlEndsAtTheMaximumVolumeControlPassesIt) {
  const History pressure = run_gallery("pressure-maximum.toml", {"load.control=pressure"});
  EXPECT_EQ(pressure.summary.outcome, Outcome::kPressureMaximum) << pressure.summary.message;
  EXPECT_LT(relative_error(pressure.rows.back().pressure, 17.1332), 0.002);

  const History volume = run_gallery("pressure-maximum.toml");
  ASSERT_EQ(volume.summary.outcome, Outcome::kCompleted) << volume.summary.message;
  const verification::PlaneStrainWall wall(verification::kM1, 0.2);
  for (const double hoop : {0.05, 0.0953102, 0.15}) {
    const double r = 30.0 * std::exp(hoop);
    const verification::WallState s = wall.at(hoop);
    const double wanted = s.hoop_stress * 1.5 * std::exp(-s.thinning) / r;
    EXPECT_LT(relative_error(volume.value_at("pressure", "r_mm", r), wanted), 0.002) << hoop;
  }
  EXPECT_LT(volume.rows.back().pressure, 16.75);
  RecordProperty("p_end", std::to_string(pressure.rows.back().pressure) + " " +
                              std::to_string(volume.rows.back().pressure));
}

// V24: E t^3 / (4 (1 - nu^2) R^3) with the following pressure's stiffness, 4/3 of it without: that tangent
// sees nothing at the buckling pressure, and the run goes on until its corrector finds no way. The other one
// ends in the increment that would reach it; 0.03 MPa is one increment.
TEST(StabilityLimitPoints, BucklingUnderOuterPressure) {
  constexpr double kCritical = 7.0742, kIncrement = 0.03;
  const History naive = run_gallery("external-pressure.toml", {"load.load_stiffness=false"});
  EXPECT_GT(-naive.rows.back().pressure, 1.15 * kCritical) << naive.summary.message;

  const History follower = run_gallery("external-pressure.toml");
  EXPECT_EQ(follower.summary.outcome, Outcome::kBuckling) << follower.summary.message;
  EXPECT_NEAR(-follower.rows.back().pressure, kCritical, 0.01 * kCritical + kIncrement);
  RecordProperty("p_critical", std::to_string(-naive.rows.back().pressure) + " " +
                                   std::to_string(-follower.rows.back().pressure));
}

}  // namespace
}  // namespace hydroscope::stability
