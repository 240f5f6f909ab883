// SPDX-License-Identifier: GPL-3.0-or-later
// What `accuracy` promises, against answers that are known: the true error is below it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/plane_strain_ring.h"
#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

void expect_estimate(const History& h, double accuracy) {
  ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  ASSERT_TRUE(h.summary.estimate.has_value());
  EXPECT_EQ(h.summary.estimate->trouble, "");
  EXPECT_EQ(h.summary.estimate->errors.size(), h.summary.quantity_names.size());
  EXPECT_GT(h.summary.estimate->worst, 1e-4) << "of the right order";
  EXPECT_LT(h.summary.estimate->worst, 2.0 * accuracy) << "of the right order";
  EXPECT_LE(h.summary.estimate->factorisations, 1.2 * h.summary.factorisations);
  EXPECT_LE(h.summary.estimate->degrees_of_freedom, h.summary.degrees_of_freedom);
}

// V10, thin wall: wall thickness at a corner radius, against the elastic-plastic ring.
TEST(Accuracy, OfASquareDieIsKept) {
  for (const double accuracy : {0.05, 0.01}) {
    const History h = run_scene("square-die-thin.toml", {"accuracy=" + std::to_string(accuracy)});
    expect_estimate(h, accuracy);
    const PlaneStrainWall wall(kM2, 0.25);
    for (const double rho : {20.0, 12.0, 9.0}) {
      const double quarter = std::numbers::pi / 4.0;
      const WallState s = wall.at(std::log((30.0 - rho * (1.0 - quarter)) / (quarter * 30.0)));
      const double wanted = 0.3 * std::exp(-s.thinning), t = h.value_at("t_corner_mm", "rho_mm", rho);
      EXPECT_LT(relative_error(t, wanted), accuracy) << "rho " << rho;
      RecordProperty("t_rho" + std::to_string(static_cast<int>(rho)) + "_asked_" + std::to_string(accuracy),
                     std::to_string(t) + " wanted " + std::to_string(wanted));
    }
  }
}

// V9: the die takes the pressure beyond that of touching; springback is elastic. The quarter becomes a wedge.
TEST(Accuracy, OfACircularDieIsKept) {
  for (const double accuracy : {0.05, 0.01, 0.003}) {
    const History h = run_scene("circular-die.toml", {"accuracy=" + std::to_string(accuracy)});
    expect_estimate(h, accuracy);
    const WallState s = PlaneStrainWall(kM1, 0.1).at(std::log(32.0 / 30.0));
    const double touch = s.hoop_stress * 1.5 * std::exp(-s.thinning) / 32.0;
    EXPECT_LT(relative_error(h.value_at("contact_pressure_MPa", "time", 1.0), 30.0 - touch), accuracy);
    EXPECT_LT(relative_error(h.column("r_mid_mm").back(), 31.94554), accuracy);
    EXPECT_LE(h.summary.degrees_of_freedom, 40) << "a wedge";
  }
}

// V8: pressure and thickness of a free bulge against the membrane (values of the free-bulge test), in a whole
// tube of which the program models a wedge of one half.
TEST(Accuracy, OfAFreeBulgeIsKept) {
  const History h = run_scene("free-bulge.toml", {"accuracy=0.01", "tube.section=full", "tube.extent=full"});
  expect_estimate(h, 0.01);
  const struct {
    double displacement, pressure, thickness;
  } points[] = {{2.0, 17.103, 1.40650}, {4.0, 17.619, 1.32007}, {6.0, 17.511, 1.23994}};
  for (const auto& point : points) {
    EXPECT_LT(
        relative_error(h.value_at("pressure", "r_centre_mm", 30.0 + point.displacement), point.pressure),
        0.01);
    EXPECT_LT(
        relative_error(h.value_at("t_centre_mm", "r_centre_mm", 30.0 + point.displacement), point.thickness),
        0.01);
  }
  EXPECT_LT(h.summary.degrees_of_freedom, 200);
}

// V19: tensions over a drum, exp(mu pi / 2).
TEST(Accuracy, OfACapstanIsKept) {
  const History h = run_scene("capstan.toml", {"accuracy=0.01"});
  ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  EXPECT_LT(relative_error(h.column("force_ratio").back(), std::exp(0.1 * std::numbers::pi)), 0.01);
}

}  // namespace
}  // namespace hydroscope::verification
