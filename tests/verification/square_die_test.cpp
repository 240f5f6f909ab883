// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/plane_strain_ring.h"
#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

// Tube of mid radius r0 = 30 and wall t0 = 0.3 (thin, so that bending's share of t/(2 rho) is small),
// M2, in a square die that touches its four sides at the start. An eighth of the section is a flat of
// length r0 - rho and an arc of rho pi/4, where rho is the mid-surface radius of the corner.
constexpr double kR0 = 30.0, kT0 = 0.3;
constexpr double kRadii[] = {25.0, 20.0, 15.0, 12.0, 9.0};

History run_square_die(const std::string& friction) {
  return run_scene("square-die-thin.toml", {"tube.elements_around=72", "tool.die.friction=" + friction});
}

double calc_corner_thickness(const History& h, double rho) {
  return h.value_at("t_corner_mm", "rho_mm", rho);
}

TEST(SquareDie, FrictionlessCornerFollowsTheElasticPlasticRing) {
  // Without friction the strain is even: eth = ln[(r0 - rho (1 - pi/4)) / (pi r0/4)], and p = N/rho.
  const PlaneStrainWall wall(kM2, 0.25);
  const History h = run_square_die("0");
  for (const double rho : kRadii) {
    const double quarter = std::numbers::pi / 4.0;
    const WallState s = wall.at(std::log((kR0 - rho * (1.0 - quarter)) / (quarter * kR0)));
    const double wanted_t = kT0 * std::exp(-s.thinning);
    const double wanted_p = s.hoop_stress * wanted_t / rho;
    const double t = calc_corner_thickness(h, rho), p = h.value_at("pressure", "rho_mm", rho);
    EXPECT_LT(relative_error(p, wanted_p), 0.015) << "rho " << rho << " p " << p << " wanted " << wanted_p;
    EXPECT_LT(relative_error(t, wanted_t), 0.01) << "rho " << rho << " t " << t << " wanted " << wanted_t;
    const std::string at = "_rho" + std::to_string(static_cast<int>(rho));
    RecordProperty("p" + at, std::to_string(p) + " wanted " + std::to_string(wanted_p));
    RecordProperty("t" + at, std::to_string(t) + " wanted " + std::to_string(wanted_t));
  }
}

TEST(SquareDie, CornerThinsAsTheStickingLimitAndInOrderOfFriction) {
  // Sticking: what lies on the flat rests, the arc alone stretches. d(arc) = arc de + what it lays down:
  // de = (4/pi - 1) (-d rho)/rho, hence t = t0 (rho/r0)^(4/pi - 1).
  const History free = run_square_die("0"), low = run_square_die("0.05"), mid = run_square_die("0.1"),
                stuck = run_square_die("1.0");
  for (const double rho : kRadii) {
    const double wanted = kT0 * std::pow(rho / kR0, 4.0 / std::numbers::pi - 1.0);
    const double t[] = {calc_corner_thickness(free, rho), calc_corner_thickness(low, rho),
                        calc_corner_thickness(mid, rho), calc_corner_thickness(stuck, rho)};
    EXPECT_LT(relative_error(t[3], wanted), 0.015) << "rho " << rho << " t " << t[3] << " wanted " << wanted;
    EXPECT_GT(t[0], t[1]) << "rho " << rho;
    EXPECT_GT(t[1], t[2]) << "rho " << rho;
    EXPECT_GT(t[2], t[3]) << "rho " << rho;
    RecordProperty("t_rho" + std::to_string(static_cast<int>(rho)),
                   std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) + " " +
                       std::to_string(t[3]) + " sticking limit " + std::to_string(wanted));
  }
}

}  // namespace
}  // namespace hydroscope::verification
