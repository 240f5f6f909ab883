// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/plane_strain_ring.h"
#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

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
yield = "hill48"
[load]
control = "volume"
volume_ratio = [[0.0, 1.0], [1.0, 1.3]]
[quantity.r_mid_mm]
kind = "radius"
angle_deg = 45.0
[quantity.t_mm]
kind = "thickness"
angle_deg = 45.0
)";

/// Hill 1948 of equal Lankford values R in plane stress, principal axes: sbar^2 = s1^2 - 2R/(1+R) s1 s2 +
/// s2^2. Rates under a growing hoop strain 1 with none along the axis 2, as in PlaneStrainWall; R = 1 is J2.
class HillWall {
 public:
  /// Begins at first yield, elastic until there: s2 = nu s1, s1 = E e/(1 - nu^2).
  explicit HillWall(double lankford) : half_(lankford / (1.0 + lankford)) {
    const Metal& m = kM1;
    const double shape = std::sqrt(1.0 - 2.0 * half_ * m.poisson + m.poisson * m.poisson);
    state.hoop_stress = m.k * std::pow(m.eps0, m.n) / shape;
    state.axial_stress = m.poisson * state.hoop_stress;
    state.hoop_strain = state.hoop_stress * (1.0 - m.poisson * m.poisson) / m.youngs_modulus;
    state.thinning = m.poisson / m.youngs_modulus * (state.hoop_stress + state.axial_stress);
  }

  static WallState add(const WallState& a, double h, const WallState& b) {
    return {a.hoop_strain + h * b.hoop_strain, a.hoop_stress + h * b.hoop_stress,
            a.axial_stress + h * b.axial_stress, a.plastic_strain + h * b.plastic_strain,
            a.thinning + h * b.thinning};
  }
  /// Midpoint rule in steps of at most 1e-5.
  void strain_to(double hoop_strain) {
    const int steps = static_cast<int>(std::ceil((hoop_strain - state.hoop_strain) / 1e-5));
    const double h = (hoop_strain - state.hoop_strain) / steps;
    for (int i = 0; i < steps; ++i) state = add(state, h, calc_rates(add(state, 0.5 * h, calc_rates(state))));
  }
  double calc_pressure() const {
    return state.hoop_stress * 1.5 * std::exp(-state.thinning) / (30.0 * std::exp(state.hoop_strain));
  }

  WallState state;

 private:
  WallState calc_rates(const WallState& s) const {
    const Metal& m = kM1;
    const double c = m.youngs_modulus / (1.0 - m.poisson * m.poisson);
    const double sbar =
        std::sqrt(s.hoop_stress * s.hoop_stress - 2.0 * half_ * s.hoop_stress * s.axial_stress +
                  s.axial_stress * s.axial_stress);
    const double n1 = (s.hoop_stress - half_ * s.axial_stress) / sbar,
                 n2 = (s.axial_stress - half_ * s.hoop_stress) / sbar;
    const double cn1 = c * (n1 + m.poisson * n2), cn2 = c * (m.poisson * n1 + n2);
    const double slope = m.k * m.n * std::pow(m.eps0 + s.plastic_strain, m.n - 1.0);
    WallState rate;
    rate.hoop_strain = 1.0;
    rate.plastic_strain = cn1 / (slope + n1 * cn1 + n2 * cn2);
    rate.hoop_stress = c - cn1 * rate.plastic_strain;
    rate.axial_stress = m.poisson * c - cn2 * rate.plastic_strain;
    rate.thinning = m.poisson / m.youngs_modulus * (rate.hoop_stress + rate.axial_stress) +
                    (n1 + n2) * rate.plastic_strain;
    return rate;
  }

  double half_;  ///< R / (1 + R)
};

TEST(HillTube, ReferenceIsJ2ForROneAndMeetsTheClosedForm) {
  HillWall wall(1.0);
  const PlaneStrainWall j2(kM1, 0.12);
  for (const double e : {0.01, 0.05, 0.1}) {
    wall.strain_to(e);
    EXPECT_LT(relative_error(wall.state.hoop_stress, j2.at(e).hoop_stress), 1e-4);
    EXPECT_LT(relative_error(wall.state.thinning, j2.at(e).thinning), 1e-4);
  }
  // Rigid-plastic: s = f sbar, ebar = f e with f = (1 + R)/sqrt(1 + 2R); elasticity takes off some tenths of
  // a %.
  for (const double r : {0.5, 2.0}) {
    HillWall hill(r);
    hill.strain_to(0.1);
    const double f = (1.0 + r) / std::sqrt(1.0 + 2.0 * r);
    EXPECT_LT(relative_error(hill.state.hoop_stress, f * 550.0 * std::pow(0.01 + f * 0.1, 0.2)), 0.006) << r;
  }
}

/// V15: a tube of planar isotropy R in plane strain, past its pressure maximum.
TEST(HillTube, FollowsTheAnisotropicRing) {
  for (const char* lankford : {"0.5", "1.0", "2.0"}) {
    const std::string r = lankford;
    const History h = run_text(kScene, {"material.r0=" + r, "material.r45=" + r, "material.r90=" + r});
    ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
    HillWall wall(std::stod(r));
    const auto p = h.column("pressure"), radius = h.column("r_mid_mm"), t = h.column("t_mm");
    double largest = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double strain = std::log(radius[i] / 30.0);
      if (strain < 0.005) continue;  // the increments over first yield: docs/verification.md
      wall.strain_to(strain);
      largest = std::max(largest, relative_error(p[i], wall.calc_pressure()));
      EXPECT_LT(relative_error(t[i], 1.5 * std::exp(-wall.state.thinning)), 0.002)
          << "R " << r << " at " << strain;
    }
    EXPECT_LT(largest, 0.002) << "R " << r;
    EXPECT_GT(std::log(radius.back() / 30.0), 0.12);
    RecordProperty("largest_error_R_" + r, std::to_string(largest));
  }
}

}  // namespace
}  // namespace hydroscope::verification
