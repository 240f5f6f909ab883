// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/base/types.h"
#include "solver/material/hardening.h"

namespace hydroscope {

/// Elastoplastic sheet material in plane stress, J2 or Hill 1948, with
/// isotropic hardening. Components in material axes, order 11, 22, 12, with
/// the engineering shear strain (axis 1 along the tube's axis).
struct SheetMaterial {
  double youngs_modulus = 0.0;  ///< [MPa]
  double poisson = 0.0;
  double r0 = 1.0, r45 = 1.0, r90 = 1.0;  ///< Lankford values; all 1: J2
  Hardening hardening;
  double yield_rounding = 0.0;  ///< half width of the rounded onset of yielding, of the flow stress; 0: sharp

  double shear_modulus() const { return youngs_modulus / (2.0 * (1.0 + poisson)); }
  /// C of plane stress (mechanics 2.1).
  Mat3 calc_elasticity() const;
  /// P such that sbar^2 = 3/2 s^T P s (mechanics 2.1, 2.3).
  Mat3 calc_yield_matrix() const;
};

/// What an integration point remembers.
struct MaterialPoint {
  Vec3 stress = Vec3::Zero();  ///< sigma - sigma33 (1, 1, 0) [MPa]: J2 does not feel the hydrostatic shift
  double plastic_strain = 0.0;
};

/// Constants of a material, computed once a run.
struct SheetLaw {
  explicit SheetLaw(const SheetMaterial& m = {});
  SheetMaterial material;
  Mat3 elasticity, compliance, yield_matrix;
  Mat3 modes;        ///< columns v_i with v_i . C^-1 v_j = delta_ij and v_i . P v_j = lambda_i delta_ij
  Vec3 eigenvalues;  ///< lambda_i [MPa]
  Mat3 to_modes;     ///< modes^T C^-1: stress to its components a_i
};

/// Which tangent a stress update is to bring along.
enum class TangentKind {
  kConsistent,  ///< with the return
  kFlow,        ///< a predictor's: points on their yield surface flow on, even before they move
  kNone         ///< stresses only; what stands in its place is of no use
};

struct StressUpdate {
  MaterialPoint point;  ///< at the end
  Mat3 tangent;         ///< d stress / d strain, consistent with the return (Simo & Taylor 1986)
  bool is_plastic = false;
  double plastic_increment = 0.0;
  double elastic_share = 1.0;  ///< of the increment before the point first reaches its yield surface (r1)
};

/// One strain increment (D dt), integrated by the closest-point return in the
/// plane-stress subspace (mechanics 2.5). The yield function is evaluated with
/// stresses shifted by sigma33; the elastic strain of a change of sigma33
/// [MPa] is taken off first: (1 - 2 nu)/E d sigma33 on both normal strains.
/// With TangentKind::kFlow a point that stands on its yield surface is given the
/// continuum elastoplastic tangent even before it moves: what a predictor needs.
/// With `yield_rounding` rho the elastic trial turns plastic over a band of +-rho of the flow stress
/// instead of at a corner: within it the return ends inside the surface by (band - overstress)^2 / (4 band).
/// Points that flow on are not touched by it; points in neutral loading, which a backed wall has by the
/// thousand, no longer switch between two moduli a hundredfold apart.
/// Throws ContractError when the local iteration fails (never seen for
/// hardening with a slope >= 0).
StressUpdate update_stress(const SheetLaw& law, const MaterialPoint& start, const Vec3& strain_increment,
                           double sigma33_increment = 0.0, TangentKind tangent = TangentKind::kConsistent);

/// Equivalent stress sqrt(3/2 s^T P s) [MPa].
double calc_equivalent_stress(const Mat3& yield_matrix, const Vec3& stress);

}  // namespace hydroscope
