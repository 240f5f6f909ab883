// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/plane_strain_wall.h"

#include <cmath>

namespace hydroscope {
namespace {

/// Change of a plastic wall with the hoop strain. Flow is normal to sbar^2 = s1^2 - s1 s2 + s2^2,
/// stress rates are C (e - flow), and sbar follows the hardening law.
WallPoint calc_slope(const SwiftSteel& m, const WallPoint& w) {
  const double sbar = std::sqrt(w.hoop_stress * w.hoop_stress - w.hoop_stress * w.axial_stress +
                                w.axial_stress * w.axial_stress);
  const double flow_hoop = (w.hoop_stress - 0.5 * w.axial_stress) / sbar;
  const double flow_axial = (w.axial_stress - 0.5 * w.hoop_stress) / sbar;
  const double stiff = m.youngs_modulus / (1.0 - m.poisson * m.poisson);
  const double force_hoop = stiff * (flow_hoop + m.poisson * flow_axial);
  const double force_axial = stiff * (flow_axial + m.poisson * flow_hoop);
  const double hardening = m.n * m.k * std::pow(m.eps0 + w.plastic_strain, m.n - 1.0);
  WallPoint slope;
  slope.plastic_strain = force_hoop / (hardening + flow_hoop * force_hoop + flow_axial * force_axial);
  slope.hoop_stress = stiff - force_hoop * slope.plastic_strain;
  slope.axial_stress = m.poisson * stiff - force_axial * slope.plastic_strain;
  slope.thinning = m.poisson / m.youngs_modulus * (slope.hoop_stress + slope.axial_stress) +
                   (flow_hoop + flow_axial) * slope.plastic_strain;
  return slope;
}

WallPoint move(const WallPoint& w, double step, const WallPoint& slope) {
  return {w.hoop_stress + step * slope.hoop_stress, w.axial_stress + step * slope.axial_stress,
          w.plastic_strain + step * slope.plastic_strain, w.thinning + step * slope.thinning};
}

}  // namespace

WallPoint integrate_wall(const SwiftSteel& m, double hoop_strain) {
  const double stiff = m.youngs_modulus / (1.0 - m.poisson * m.poisson);
  const double yield =
      m.k * std::pow(m.eps0, m.n) / std::sqrt(1.0 - m.poisson + m.poisson * m.poisson) / stiff;
  const double elastic = std::fmin(hoop_strain, yield);
  WallPoint wall{stiff * elastic, m.poisson * stiff * elastic, 0.0,
                 m.poisson / m.youngs_modulus * stiff * (1.0 + m.poisson) * elastic};
  if (hoop_strain <= yield) return wall;
  // Classical Runge-Kutta, with steps that grow with the distance from first yield: there the
  // stress ratio turns quickly.
  constexpr int kSteps = 4000;
  double strain = yield;
  for (int i = 1; i <= kSteps; ++i) {
    const double share = static_cast<double>(i) / kSteps;
    const double next = yield + (hoop_strain - yield) * share * share * share;
    const double h = next - strain;
    const WallPoint a = calc_slope(m, wall), b = calc_slope(m, move(wall, 0.5 * h, a));
    const WallPoint c = calc_slope(m, move(wall, 0.5 * h, b)), d = calc_slope(m, move(wall, h, c));
    wall = move(move(move(move(wall, h / 6.0, a), h / 3.0, b), h / 3.0, c), h / 6.0, d);
    strain = next;
  }
  return wall;
}

}  // namespace hydroscope
