// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "solver/base/types.h"
#include "solver/geometry/tool_surface.h"

namespace hydroscope {

/// Bend of an edge between points `chord` = X1 - X0 apart [mm] with unit normals n0, n1 at its ends: the
/// edge runs X0 + s chord - s (1 - s) bend (Nagata 2005, mechanics 6.2). Where the normals cannot be met by a
/// regular parabola (both lean the same way against the chord, as where a flat meets a fillet), the bend is
/// that along their mean alone.
Vec3 calc_edge_bend(const Vec3& chord, const Vec3& n0, const Vec3& n1);

/// The same for an edge on a crease, with the normals of both sides at each end: the shortest bend that
/// fits all four best. Both sides get the same curve, so that the crease stays closed.
Vec3 calc_crease_bend(const Vec3& chord, const std::array<Vec3, 2>& n0, const std::array<Vec3, 2>& n1);

/// A quadratic triangle, X = sum l_k X_k - sum bend_k l_i l_j, edge k opposite to corner k.
struct NagataPatch {
  std::array<Vec3, 3> x;     // corners [mm]
  std::array<Vec3, 3> bend;  // of the edges [mm]

  /// How far the patch may lie off its flat facet [mm].
  double calc_rise() const {
    return 0.25 * (bend[0].norm() + bend[1].norm() + bend[2].norm());  // l_i l_j <= 1/4
  }
};

/// The patch at l1, l2 (of corners 0 and 1) with its derivatives by them.
struct PatchPlace {
  Vec3 point, a, b;  // X, dX/dl1, dX/dl2 [mm]
  Vec3 aa, ab, bb;   // second derivatives [mm]
  Vec3 normal;       // unit
  PatchPlace(const NagataPatch& patch, double l1, double l2);

  /// dn/dx of a point at height `gap` [mm] over this place [1/mm]: -W (I - gap W)^-1 with the surface's own
  /// Weingarten map W. Symmetric.
  Mat3 calc_normal_gradient(double gap) const;
};

/// The point of a patch nearest to a given one.
struct PatchFoot {
  double l1 = 0.0, l2 = 0.0;
  double distance2 = 0.0;  ///< [mm^2]
  int edge = -1;           ///< the edge that it lies on, if the normal there does not lead to `x`
  int corner = -1;         ///< the corner that it lies in, likewise
};

/// Newton on x - X = g n from (`l1`, `l2`); outside of the patch, the nearest of its edges and corners.
PatchFoot find_closest_on_patch(const NagataPatch& patch, const Vec3& x, double l1, double l2);

/// An edge of a patch at parameter s from corner (k + 1) % 3 to (k + 2) % 3.
struct PatchEdge {
  Vec3 point, tangent, second;  // C, dC/ds, d2C/ds2 [mm]
  PatchEdge(const NagataPatch& patch, int k, double s);
};

/// Coordinates l1, l2 on edge k at s, and back.
std::array<double, 2> place_on_edge(int k, double s);
double read_edge_parameter(int k, double l1, double l2);

}  // namespace hydroscope
