// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace hydroscope::verification {

/// J2 with Swift hardening, sy = k (eps0 + ep)^n [MPa].
struct Metal {
  double youngs_modulus, poisson, k, eps0, n;
};

inline constexpr Metal kM1{206e3, 0.3, 550.0, 0.01, 0.2};   // steel-like
inline constexpr Metal kM2{193e3, 0.3, 1400.0, 0.05, 0.5};  // stainless-like

/// The wall of a long tube: hoop strain given, no axial strain, no stress through the wall.
struct WallState {
  double hoop_strain = 0.0;
  double hoop_stress = 0.0;   ///< Cauchy [MPa]
  double axial_stress = 0.0;  ///< [MPa]
  double plastic_strain = 0.0;
  double thinning = 0.0;  ///< -ln(t / t0)
};

/// Elastic-plastic wall under a growing hoop strain, from the rates (no return mapping, nothing of the
/// solver): an answer of its own, kept as a table and read by interpolation.
class PlaneStrainWall {
 public:
  PlaneStrainWall(const Metal& metal, double last_hoop_strain);
  WallState at(double hoop_strain) const;

 private:
  double step_ = 0.0;
  std::vector<WallState> states_;
};

}  // namespace hydroscope::verification
