// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hydroscope {

/// J2 with Swift hardening, K (eps0 + ep)^n. MPa.
struct SwiftSteel {
  double youngs_modulus = 0.0, poisson = 0.3, k = 0.0, eps0 = 0.0, n = 0.0;
};

/// A wall in plane strain that has been stretched along the hoop.
struct WallPoint {
  double hoop_stress = 0.0, axial_stress = 0.0;  ///< Cauchy [MPa]
  double plastic_strain = 0.0;
  double thinning = 0.0;  ///< ln(t0 / t)
};

/// Integrates the elastic-plastic rate equations of a thin wall (no stress through it, no bending)
/// from nothing to `hoop_strain` (logarithmic, axial strain 0). Error below 1e-7.
WallPoint integrate_wall(const SwiftSteel& metal, double hoop_strain);

}  // namespace hydroscope
