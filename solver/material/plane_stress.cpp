// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/material/plane_stress.h"

#include <cmath>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

/// Inverse of a symmetric matrix with no coupling of normal and shear parts.
Mat3 invert_orthotropic(const Mat3& m) {
  const double det = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  Mat3 inverse = Mat3::Zero();
  inverse(0, 0) = m(1, 1) / det;
  inverse(1, 1) = m(0, 0) / det;
  inverse(0, 1) = -m(0, 1) / det;
  inverse(1, 0) = -m(1, 0) / det;
  inverse(2, 2) = 1.0 / m(2, 2);
  return inverse;
}

/// Where the return ends: plastic multiplier and all that follows from it.
struct Return {
  double gamma = 0.0;
  Mat3 moduli;  ///< Xi = (C^-1 + gamma P)^-1
  Vec3 stress;
  double equivalent = 0.0;
  double plastic_strain = 0.0;
  double slope = 0.0;
};

Return evaluate_return(const SheetLaw& law, const Vec3& elastic_strain, double ep, double gamma) {
  Return r;
  r.gamma = gamma;
  r.moduli = invert_orthotropic(law.compliance + gamma * law.yield_matrix);
  r.stress = r.moduli * elastic_strain;
  r.equivalent = calc_equivalent_stress(law.yield_matrix, r.stress);
  r.plastic_strain = ep + 2.0 / 3.0 * gamma * r.equivalent;
  return r;
}

/// Safeguarded Newton on f(gamma) = sbar(gamma) - sy(ep + 2/3 gamma sbar).
Return find_return(const SheetLaw& law, const Vec3& elastic_strain, double ep, double start_stress) {
  double low = 0.0, high = -1.0;
  double gamma = 0.0;
  for (int iteration = 0; iteration < 100; ++iteration) {
    Return r = evaluate_return(law, elastic_strain, ep, gamma);
    const auto flow = law.material.hardening(r.plastic_strain);
    r.slope = flow.slope;
    const double f = r.equivalent - flow.stress;
    if (std::abs(f) <= 1e-13 * start_stress) return r;
    (f > 0.0 ? low : high) = gamma;
    if (high >= 0.0 && high - low <= 1e-15 * high) return r;
    const Vec3 ps = law.yield_matrix * r.stress;
    const double dq = -1.5 / r.equivalent * ps.dot(r.moduli * ps);  // d sbar / d gamma
    const double slope = dq - flow.slope * 2.0 / 3.0 * (r.equivalent + gamma * dq);
    double next = gamma - f / slope;
    const bool is_outside = next <= low || (high >= 0.0 && next >= high) || !std::isfinite(next);
    if (is_outside) next = high >= 0.0 ? 0.5 * (low + high) : 2.0 * low + 1e-12;
    gamma = next;
  }
  throw ContractError("plane-stress return mapping did not converge");
}

/// C_ep = C - (C P s)(C P s)^T / (s^T P C P s + 4/9 H sbar^2) (mechanics 2.1).
Mat3 calc_flow_tangent(const SheetLaw& law, const MaterialPoint& point) {
  const auto flow = law.material.hardening(point.plastic_strain);
  const Vec3 ps = law.yield_matrix * point.stress, direction = law.elasticity * ps;
  const double denominator = ps.dot(direction) + 4.0 / 9.0 * flow.slope * flow.stress * flow.stress;
  return law.elasticity - direction * direction.transpose() / denominator;
}

}  // namespace

Mat3 SheetMaterial::calc_elasticity() const {
  const double nu = poisson;
  Mat3 c;
  c << 1.0, nu, 0.0, nu, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - nu);
  return youngs_modulus / (1.0 - nu * nu) * c;
}

Mat3 SheetMaterial::calc_yield_matrix() const {
  const double p12 = -r0 / (1.0 + r0);
  const double p22 = r0 * (1.0 + r90) / (r90 * (1.0 + r0));
  const double p66 = (2.0 * r45 + 1.0) * (r0 + r90) / (r90 * (1.0 + r0));
  Mat3 p;
  p << 1.0, p12, 0.0, p12, p22, 0.0, 0.0, 0.0, p66;
  return 2.0 / 3.0 * p;
}

SheetLaw::SheetLaw(const SheetMaterial& m)
    : material(m),
      elasticity(m.calc_elasticity()),
      compliance(invert_orthotropic(elasticity)),
      yield_matrix(m.calc_yield_matrix()) {}

double calc_equivalent_stress(const Mat3& p, const Vec3& s) { return std::sqrt(1.5 * s.dot(p * s)); }

StressUpdate update_stress(const SheetLaw& law, const MaterialPoint& start, const Vec3& strain_increment,
                           double sigma33_increment, bool assume_flow) {
  const SheetMaterial& m = law.material;
  const double hydrostatic = (1.0 - 2.0 * m.poisson) / m.youngs_modulus * sigma33_increment;
  const Vec3 strain = strain_increment - Vec3(hydrostatic, hydrostatic, 0.0);
  StressUpdate out;
  const Vec3 trial = start.stress + law.elasticity * strain;
  out.point = {trial, start.plastic_strain};
  out.tangent = law.elasticity;
  if (!m.hardening.is_plastic()) return out;
  const double flow_stress = m.hardening(start.plastic_strain).stress;
  const double trial_stress = calc_equivalent_stress(law.yield_matrix, trial);
  if (trial_stress <= flow_stress) {
    constexpr double kOnSurface = 1.0 - 1e-8;
    if (assume_flow && trial_stress > kOnSurface * flow_stress)
      out.tangent = calc_flow_tangent(law, out.point);
    return out;
  }

  const Return r = find_return(law, law.compliance * trial, start.plastic_strain, trial_stress);
  const Vec3 ps = law.yield_matrix * r.stress;
  const Vec3 direction = r.moduli * ps;
  const double hardening =
      4.0 / 9.0 * r.slope * r.equivalent * r.equivalent / (1.0 - 2.0 / 3.0 * r.gamma * r.slope);
  out.tangent = r.moduli - direction * direction.transpose() / (ps.dot(direction) + hardening);
  out.point = {r.stress, r.plastic_strain};
  out.is_plastic = true;
  out.plastic_increment = r.plastic_strain - start.plastic_strain;
  return out;
}

}  // namespace hydroscope
