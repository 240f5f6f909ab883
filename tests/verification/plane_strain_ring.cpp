// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/plane_strain_ring.h"

#include <algorithm>
#include <cmath>

namespace hydroscope::verification {

namespace {

constexpr int kSteps = 40000;

/// Rates for one unit of hoop strain. With a = 1 hoop, 2 axial and the plane-stress J2 flow direction
///   n1 = (s1 - s2/2)/sbar,  n2 = (s2 - s1/2)/sbar,  dep_i = n_i dep
/// the hypoelastic law ds = C (de - n dep), C = E/(1-nu^2) [[1, nu], [nu, 1]], de = (1, 0), and
/// consistency n . ds = H dep give dep = n . C de / (H + n . C n).
/// The wall thins by its elastic strain -nu/E (ds1 + ds2) and its plastic strain -(n1 + n2) dep.
WallState calc_rates(const Metal& m, const WallState& s) {
  const double c = m.youngs_modulus / (1.0 - m.poisson * m.poisson);
  const double sbar = std::sqrt(s.hoop_stress * s.hoop_stress - s.hoop_stress * s.axial_stress +
                                s.axial_stress * s.axial_stress);
  WallState rate;
  rate.hoop_strain = 1.0;
  // The table starts at first yield, so that the wall is plastic in every state asked for here.
  const double n1 = (s.hoop_stress - 0.5 * s.axial_stress) / sbar;
  const double n2 = (s.axial_stress - 0.5 * s.hoop_stress) / sbar;
  const double slope = m.k * m.n * std::pow(m.eps0 + s.plastic_strain, m.n - 1.0);
  const double cn1 = c * (n1 + m.poisson * n2), cn2 = c * (m.poisson * n1 + n2);
  rate.plastic_strain = cn1 / (slope + n1 * cn1 + n2 * cn2);
  rate.hoop_stress = c - cn1 * rate.plastic_strain;
  rate.axial_stress = m.poisson * c - cn2 * rate.plastic_strain;
  rate.thinning =
      m.poisson / m.youngs_modulus * (rate.hoop_stress + rate.axial_stress) + (n1 + n2) * rate.plastic_strain;
  return rate;
}

WallState add(const WallState& a, double h, const WallState& b) {
  return {a.hoop_strain + h * b.hoop_strain, a.hoop_stress + h * b.hoop_stress,
          a.axial_stress + h * b.axial_stress, a.plastic_strain + h * b.plastic_strain,
          a.thinning + h * b.thinning};
}

}  // namespace

PlaneStrainWall::PlaneStrainWall(const Metal& m, double last_hoop_strain) {
  // Elastic up to first yield: s1 = E' e, s2 = nu s1, sbar = s1 sqrt(1 - nu + nu^2).
  WallState s;
  s.hoop_stress = m.k * std::pow(m.eps0, m.n) / std::sqrt(1.0 - m.poisson + m.poisson * m.poisson);
  s.axial_stress = m.poisson * s.hoop_stress;
  s.hoop_strain = s.hoop_stress * (1.0 - m.poisson * m.poisson) / m.youngs_modulus;
  s.thinning = m.poisson / m.youngs_modulus * (s.hoop_stress + s.axial_stress);
  step_ = (last_hoop_strain - s.hoop_strain) / kSteps;
  states_.push_back(s);
  for (int i = 0; i < kSteps; ++i) {  // midpoint rule: an error of order step^2, 1e-10 here
    s = add(s, step_, calc_rates(m, add(s, 0.5 * step_, calc_rates(m, s))));
    states_.push_back(s);
  }
}

WallState PlaneStrainWall::at(double hoop_strain) const {
  const WallState& first = states_.front();
  if (hoop_strain <= first.hoop_strain) {
    const double share = hoop_strain / first.hoop_strain;
    return add({}, share, first);
  }
  const double place = (hoop_strain - first.hoop_strain) / step_;
  const std::size_t i = std::min(static_cast<std::size_t>(place), states_.size() - 2);
  const WallState& a = states_[i];
  const double share = place - static_cast<double>(i);
  return add(add(a, share, states_[i + 1]), -share, a);
}

}  // namespace hydroscope::verification
