// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "solver/base/types.h"
#include "solver/shell/layer.h"
#include "solver/shell/thickness_rule.h"

namespace hydroscope {

inline constexpr int kDofs = 5;  ///< u_x, u_y, u_z [mm], alpha, beta [rad] (about V1, V2)
inline constexpr int kElementDofs = 20;
inline constexpr int kGaussPoints = 4;  ///< 2 x 2 in the plane

using ElementVector = Eigen::Matrix<double, kElementDofs, 1>;
using ElementMatrix = Eigen::Matrix<double, kElementDofs, kElementDofs>;

/// Orthonormal triad of a node: V is the fibre (director); rotation increments
/// are theta = alpha V1 + beta V2, so that dV = -alpha V2 + beta V1.
struct Triad {
  Vec3 v1 = Vec3::UnitX(), v2 = Vec3::UnitY(), v = Vec3::UnitZ();
};

/// Nodes of one element in one configuration.
struct ElementNodes {
  std::array<Vec3, 4> x;  ///< mid-surface [mm]
  std::array<Triad, 4> triad;
  std::array<double, 4> thickness{};  ///< h [mm]
};

/// What a Gauss point remembers beside its layers.
struct GaussState {
  Vec2 shear = Vec2::Zero();  ///< contravariant transverse shear S^1, S^2 (tied, elastic)
  double volume = 0.0;        ///< reference volume [mm^3]: constant, so mass is kept
  double dilatation =
      1.0;  ///< elastic volume ratio J = 1 + (1 - 2 nu)/E tr sigma, of the last accepted state
};

struct ElementPart {                   ///< views into the state of one element
  std::span<const LayerState> layers;  ///< 4 x n_z
  std::span<const GaussState> gauss;   ///< 4
};
struct ElementPartOut {
  std::span<LayerState> layers;
  std::span<GaussState> gauss;
};

struct ElementResponse {
  ElementVector force;             ///< internal force [N, N mm]
  std::array<double, 4> area{};    ///< tributary mid-surface area of each node [mm^2]
  std::array<double, 4> volume{};  ///< tributary volume of each node [mm^3]
  double strain_increment = 0.0;   ///< largest equivalent total strain increment
  double elastic_share = 1.0;      ///< smallest share of the increment before a point begins to yield
  double plastic_increment = 0.0;  ///< largest equivalent plastic strain increment
};

/// Material and integration shared by all elements.
struct ShellLaw {
  SheetLaw sheet;
  ThicknessRule rule;
  double shear_correction = 5.0 / 6.0;
  bool director_stiffness = true;  ///< the tangent holds the second variation of the fibre (mechanics 1.4)
  bool curvature_terms = true;     ///< the metric is quadratic in zeta; false: linear
};

/// Stress through the wall at the four nodes of an element: sigma33 at the
/// start and at the end of the increment [MPa] (zero when switched off).
struct ThroughWallStress {
  std::array<double, 4> start{}, end{};
};

/// How an element is to be evaluated.
struct ElementSettings {
  ThroughWallStress sigma33;
  bool assume_flow = false;  ///< tangent of a predictor: points on their yield surface flow on
};

/// MITC4 (Dvorkin & Bathe 1984), five degrees of freedom a node, updated
/// Lagrangian. Each layer zeta is a surface with metric
///   a_ij(zeta) = g_i . g_j,  g_i = x_,i + zeta (h/2 V)_,i ,
/// integrated by advance_layer() between the configurations `start` (last
/// accepted state) and `end`; the force is the work conjugate of the metric,
/// so its derivative with respect to `end` is exactly symmetric. Transverse
/// shear is tied at the mid-sides (A, B, C, D) and elastic.
/// If `stiffness` is not null it is set to d force / d (u, alpha, beta) of `end`:
/// material, initial stress and director terms (mechanics 1.4), thickness frozen.
ElementResponse evaluate_element(const ShellLaw& law, const ElementNodes& start, const ElementNodes& end,
                                 const ElementPart& state, const ElementSettings& settings,
                                 const ElementPartOut& out, ElementMatrix* stiffness);

/// Stress-free state of an element: reference volumes, and layer frames whose
/// first axis is `axis` (unit) projected into the layer.
void initialise_element(const ElementNodes& nodes, const Vec3& axis, const ThicknessRule& rule,
                        const ElementPartOut& out);

/// Shape functions and their derivatives at (xi, eta); nodes at (-1,-1), (1,-1), (1,1), (-1,1).
struct ShapeFunctions {
  std::array<double, 4> n, n1, n2;
};
ShapeFunctions calc_shape_functions(double xi, double eta);

/// Local coordinates of Gauss point `i`.
Vec2 gauss_point(int i);

}  // namespace hydroscope
