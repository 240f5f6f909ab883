// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "solver/base/types.h"
#include "solver/geometry/tool_surface.h"

namespace hydroscope {

/// The space that one facet answers for: all points sum l_a (X_a + g V_a) with
/// l_a >= 0, where V_a are the node normals. Neighbours share the ruled face between
/// them, so the prisms of a mesh fill the space around it without gap or overlap.
struct Prism {
  Vec3 x3;             // third corner [mm]
  Vec3 e1, e2;         // X1 - X3, X2 - X3 [mm]
  Vec3 v3;             // normal of the third corner
  Vec3 d1, d2;         // V1 - V3, V2 - V3
  Vec3 normal;         // unit normal of the facet
  double area2 = 0.0;  // |e1 x e2| [mm^2]
  /// Rise of the smooth surface over the flat facet, -sum bend_k l_i l_j over the edges k opposite
  /// to corner k [mm]; zero for flat facets. See bend_edges().
  std::array<double, 3> bend{};

  Vec3 corner(int k) const { return k == 0 ? Vec3(x3 + e1) : k == 1 ? Vec3(x3 + e2) : x3; }
  Vec3 corner_normal(int k) const { return k == 0 ? Vec3(v3 + d1) : k == 1 ? Vec3(v3 + d2) : v3; }
};

/// Gives each edge the curve whose slopes at both ends fit the node normals best (after Nagata 2005,
/// with one coefficient an edge: bend = (n_i - n_j) . (X_j - X_i) / 2). Gap and normal then agree to
/// the second order of the facet angle, and the error of the surface falls from its 2nd to its 4th power.
void bend_edges(Prism& prism);

Prism make_prism(const std::array<Vec3, 3>& corners, const std::array<Vec3, 3>& normals);

/// Where a point lies in a prism.
struct PrismPoint {
  double l1 = 0.0, l2 = 0.0;  ///< barycentric coordinates of corners 1 and 2
  double g = 0.0;             ///< height along the interpolated normal, which is shorter than 1
  bool is_valid = false;      ///< found, and before the focal distance of the facet

  double l(int k) const { return k == 0 ? l1 : k == 1 ? l2 : 1.0 - l1 - l2; }
  double smallest() const { return std::min(std::min(l1, l2), 1.0 - l1 - l2); }
};

/// Projects `x` along the interpolated normal: Newton on sum l_a (X_a + g V_a) = x.
PrismPoint locate_in_prism(const Prism& prism, const Vec3& x);

/// Gap, normal and their derivatives of `x` at its place in the prism.
FootPoint make_foot_point(const Prism& prism, const PrismPoint& at, const Vec3& x);

}  // namespace hydroscope
