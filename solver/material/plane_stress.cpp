// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/material/plane_stress.h"

#include <Eigen/Eigenvalues>
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

/// Where the return ends: plastic multiplier and all that follows from it. In the modes of (C^-1, P) the
/// stress is s_i = a_i / (1 + gamma lambda_i).
struct Return {
  double gamma = 0.0;
  Vec3 modal;  ///< s_i
  double equivalent = 0.0;
  double plastic_strain = 0.0;
  double flow_stress = 0.0, slope = 0.0;  ///< at the end [MPa]
};

/// Where between elastic and plastic an overstress of the trial lies.
struct Onset {
  double inside = 0.0;      ///< distance of the end from the yield surface [MPa]
  double flow_share = 1.0;  ///< d inside / d overstress + 1
};
Onset calc_onset(double overstress, double band) {
  if (overstress >= band) return {};
  const double elastic_share = 0.5 * (band - overstress) / band;
  return {elastic_share * elastic_share * band, 1.0 - elastic_share};
}

/// Safeguarded Newton on f(gamma) / sbar(gamma), f = sbar - sy(ep + 2/3 gamma sbar) + inside: 1 / sbar is
/// almost linear in gamma, so that even large increments take few passes. `flow`: of the start, at `ep`.
Return find_return(const SheetLaw& law, const Vec3& modal_trial, double ep, Hardening::Value flow,
                   double start_stress, double inside) {
  double low = 0.0, high = -1.0;
  Return r;
  for (int iteration = 0; iteration < 100; ++iteration) {
    double square = 0.0, fall = 0.0;  // sum of lambda s^2, and minus half its derivative
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double lambda = law.eigenvalues[i], share = 1.0 / (1.0 + r.gamma * lambda);
      r.modal[i] = modal_trial[i] * share;
      const double energy = lambda * r.modal[i] * r.modal[i];
      square += energy;
      fall += energy * lambda * share;
    }
    r.equivalent = std::sqrt(1.5 * square);
    r.plastic_strain = ep + 2.0 / 3.0 * r.gamma * r.equivalent;
    if (iteration > 0) flow = law.material.hardening(r.plastic_strain);
    r.slope = flow.slope;
    r.flow_stress = flow.stress;
    const double f = r.equivalent - flow.stress + inside;
    if (std::abs(f) <= 1e-12 * start_stress) return r;
    (f > 0.0 ? low : high) = r.gamma;
    if (high >= 0.0 && high - low <= 1e-15 * high) return r;
    const double dq = -1.5 / r.equivalent * fall;  // d sbar / d gamma
    const double slope = dq - flow.slope * 2.0 / 3.0 * (r.equivalent + r.gamma * dq);
    double next = r.gamma - f / (slope - f * dq / r.equivalent);
    const bool is_outside = next <= low || (high >= 0.0 && next >= high) || !std::isfinite(next);
    if (is_outside) next = high >= 0.0 ? 0.5 * (low + high) : 2.0 * low + 1e-12;
    r.gamma = next;
  }
  throw ContractError("plane-stress return mapping did not converge");
}

/// C_ep = C - (C P s)(C P s)^T / (s^T P C P s + 4/9 H sbar^2) (mechanics 2.1).
Mat3 calc_flow_tangent(const SheetLaw& law, const MaterialPoint& point, const Hardening::Value& flow) {
  const Vec3 ps = law.yield_matrix * point.stress, direction = law.elasticity * ps;
  const double denominator = ps.dot(direction) + 4.0 / 9.0 * flow.slope * flow.stress * flow.stress;
  return law.elasticity - direction * direction.transpose() / denominator;
}

/// Consistent with the return (Simo & Taylor 1986), in the modes of (C^-1, P).
Mat3 calc_consistent_tangent(const SheetLaw& law, const Return& r, double flow_share) {
  const Vec3 shares = (1.0 + r.gamma * law.eigenvalues.array()).inverse();
  const Mat3 moduli = law.modes * shares.asDiagonal() * law.modes.transpose();  // (C^-1 + gamma P)^-1
  const Vec3 weighted = law.eigenvalues.cwiseProduct(r.modal);
  const Vec3 direction = law.modes * shares.cwiseProduct(weighted);  // moduli P s
  const double curvature = shares.dot(weighted.cwiseAbs2());         // s P moduli P s
  const double hardening =
      4.0 / 9.0 * r.slope * r.equivalent * r.equivalent / (1.0 - 2.0 / 3.0 * r.gamma * r.slope);
  return moduli - flow_share / (curvature + hardening) * direction * direction.transpose();
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
      yield_matrix(m.calc_yield_matrix()) {
  // The normal block: P and C^-1 are diagonal together in the modes of L^T P L with C = L L^T.
  const Mat3 root = elasticity.llt().matrixL();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(Mat3(root.transpose() * yield_matrix * root));
  modes = root * solver.eigenvectors();
  eigenvalues = solver.eigenvalues();
  to_modes = modes.transpose() * compliance;
}

double calc_equivalent_stress(const Mat3& p, const Vec3& s) { return std::sqrt(1.5 * s.dot(p * s)); }

StressUpdate update_stress(const SheetLaw& law, const MaterialPoint& start, const Vec3& strain_increment,
                           double sigma33_increment, TangentKind tangent) {
  const SheetMaterial& m = law.material;
  const double hydrostatic = (1.0 - 2.0 * m.poisson) / m.youngs_modulus * sigma33_increment;
  const Vec3 strain = strain_increment - Vec3(hydrostatic, hydrostatic, 0.0);
  StressUpdate out;
  const Vec3 trial = start.stress + law.elasticity * strain;
  out.point = {trial, start.plastic_strain};
  out.tangent = law.elasticity;
  if (!m.hardening.is_plastic()) return out;
  const Hardening::Value flow = m.hardening(start.plastic_strain);
  const double trial_stress = calc_equivalent_stress(law.yield_matrix, trial);
  const double band = m.yield_rounding * flow.stress, overstress = trial_stress - flow.stress;
  if (overstress <= -band) {
    constexpr double kOnSurface = 1.0 - 1e-8;
    if (tangent == TangentKind::kFlow && trial_stress > kOnSurface * flow.stress)
      out.tangent = calc_flow_tangent(law, out.point, flow);
    return out;
  }

  const double before = flow.stress - calc_equivalent_stress(law.yield_matrix, start.stress);
  constexpr double kElastic = 0.01;  // of the flow stress: nearer points flow already
  if (overstress > 0.0 && before > kElastic * flow.stress) out.elastic_share = before / (before + overstress);
  const Onset onset = calc_onset(overstress, band);
  const Return r =
      find_return(law, law.to_modes * trial, start.plastic_strain, flow, trial_stress, onset.inside);
  out.point = {law.modes * r.modal, r.plastic_strain};
  out.is_plastic = true;
  out.plastic_increment = r.plastic_strain - start.plastic_strain;
  if (tangent == TangentKind::kFlow) {
    out.tangent = calc_flow_tangent(law, out.point, {r.flow_stress, r.slope});
  } else if (tangent == TangentKind::kConsistent) {
    out.tangent = calc_consistent_tangent(law, r, onset.flow_share);
  }
  return out;
}

}  // namespace hydroscope
