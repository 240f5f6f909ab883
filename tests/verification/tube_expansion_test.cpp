// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/plane_strain_ring.h"
#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

// Tube of mid radius 30 and wall 1.5, M1, plane strain. A polygon whose elements span an angle d
// carries d^2/8 more pressure than the circle: 48 elements in a quarter (1.9 degrees) make that 0.013 %.
const char* const kScene = R"(
[tube]
radius_mm = 30.0
thickness_mm = 1.5
length_mm = 2.0
section = "quarter"
extent = "slice"
elements_around = 48
[material]
youngs_modulus_MPa = 206e3
poisson = 0.3
hardening = "swift"
swift_K_MPa = 550.0
swift_eps0 = 0.01
swift_n = 0.2
[load]
pressure_MPa = [[0.0, 0.0], [1.0, 20.0]]
[quantity.r_mid_mm]
kind = "radius"
angle_deg = 45.0
[quantity.t_mm]
kind = "thickness"
angle_deg = 45.0
)";
// 1.38 times the volume: r / r0 = 1.175, eth = 0.161, well past the maximum at 0.093.
const std::vector<std::string> kByVolume = {"load.control=volume", "load.volume_ratio=[[0, 1], [1, 1.38]]"};

/// A ring's equilibrium: p r = s_th t.
double calc_ring_pressure(const PlaneStrainWall& wall, double hoop_strain) {
  const WallState s = wall.at(hoop_strain);
  return s.hoop_stress * 1.5 * std::exp(-s.thinning) / (30.0 * std::exp(hoop_strain));
}

TEST(TubeExpansion, ReferenceMeetsTheClosedFormWithoutElasticity) {
  // Rigid-plastic plane strain: s_z = s_th / 2, so ebar = 2 eth / sqrt3, s_th = 2 sbar / sqrt3, and
  // p = (2/sqrt3) (t0/r0) K (eps0 + 2 eth/sqrt3)^n exp(-2 eth), highest at eth = n/2 - sqrt3/2 eps0.
  Metal stiff = kM1;
  stiff.youngs_modulus = 5e6;  // elasticity left: 0.05 %; stiffer, and the explicit rates need finer steps
  const PlaneStrainWall wall(stiff, 0.2);
  const double a = 2.0 / std::sqrt(3.0);
  for (const double e : {0.01, 0.05, 0.1, 0.15}) {
    const double p = a * 1.5 / 30.0 * 550.0 * std::pow(0.01 + a * e, 0.2) * std::exp(-2.0 * e);
    EXPECT_LT(relative_error(calc_ring_pressure(wall, e), p), 1e-3) << e;
  }
}

TEST(TubeExpansion, PressureFollowsTheElasticPlasticRingPastItsMaximum) {
  const History h = run_text(kScene, kByVolume);
  ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  const PlaneStrainWall wall(kM1, 0.2);
  const auto p = h.column("pressure"), r = h.column("r_mid_mm"), t = h.column("t_mm");
  double highest = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double strain = std::log(r[i] / 30.0);
    highest = std::max(highest, p[i]);
    if (strain < 0.005) continue;  // the increments over first yield: docs/verification.md
    EXPECT_LT(relative_error(p[i], calc_ring_pressure(wall, strain)), 0.002) << "strain " << strain;
    EXPECT_LT(relative_error(t[i], 1.5 * std::exp(-wall.at(strain).thinning)), 0.002) << "strain " << strain;
  }
  EXPECT_GT(std::log(r.back() / 30.0), 0.15);
  EXPECT_LT(relative_error(highest, 17.1332), 0.002);
  EXPECT_LT(p.back(), 0.99 * highest) << "the maximum is passed";
  RecordProperty("highest_pressure_MPa", std::to_string(highest));
}

TEST(TubeExpansion, PressureAtGivenStrains) {
  const struct {
    double strain, pressure;
  } kPoints[] = {{0.01, 14.2479}, {0.02, 15.2848}, {0.05, 16.6904}, {0.0953102, 17.1323}, {0.15, 16.7314}};
  const PlaneStrainWall wall(kM1, 0.2);
  std::vector<std::string> fine = kByVolume;  // only so that the figure can be read off between increments
  fine.push_back("increment.max_strain=0.002");
  fine.push_back("increment.largest=0.01");
  const History h = run_text(kScene, fine);
  for (const auto& point : kPoints) {
    EXPECT_LT(relative_error(calc_ring_pressure(wall, point.strain), point.pressure), 2e-5) << point.strain;
    const double p = h.value_at("pressure", "r_mid_mm", 30.0 * std::exp(point.strain));
    EXPECT_LT(relative_error(p, point.pressure), 0.002) << point.strain;
    RecordProperty("p_at_strain_" + std::to_string(point.strain), std::to_string(p));
  }
}

TEST(TubeExpansion, PressureControlReportsTheMaximumAndStops) {
  const History shipped = run_text(kScene);
  EXPECT_EQ(shipped.summary.outcome, Outcome::kPressureMaximum) << shipped.summary.message;
  RecordProperty("shipped_pressure_maximum_MPa", std::to_string(shipped.rows.back().pressure));
  // At a maximum the wall answers a small imbalance with a large expansion. The imbalance allowed by
  // default is too much there (docs/verification.md, Open), so the figure is asked of a tenth of it.
  const History h = run_text(kScene, {"increment.tolerance=1e-4"});
  EXPECT_EQ(h.summary.outcome, Outcome::kPressureMaximum) << h.summary.message;
  const auto p = h.column("pressure");
  EXPECT_LT(relative_error(p.back(), 17.1332), 0.002);
  RecordProperty("pressure_maximum_MPa", std::to_string(p.back()));
}

}  // namespace
}  // namespace hydroscope::verification
