// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "solver/base/types.h"
#include "solver/geometry/tool_surface.h"

namespace hydroscope {

/// The space that a bilinear quadrilateral answers for: all points sum N_a(xi, eta) (X_a + g V_a), (4.2),
/// with xi and eta from 0 to 1. Corners 0, 1, 2, 3 lie at (0, 0), (1, 0), (1, 1), (0, 1). Edges are straight
/// and normals linear along them: quads share their sides with each other and with the prisms of triangles.
struct QuadPrism {
  Vec3 x0, a, b, c;    // X = x0 + xi a + eta b + xi eta c [mm]
  Vec3 v0, p, q, r;    // V = v0 + xi p + eta q + xi eta r
  double area2 = 0.0;  // |(X2 - X0) x (X3 - X1)| [mm^2], twice the area
};

QuadPrism make_quad_prism(const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& normals);

/// Where a point lies in the prism of a quadrilateral.
struct QuadPoint {
  double xi = 0.5, eta = 0.5;
  double g = 0.0;         ///< height along the interpolated normal, which is shorter than 1
  bool is_valid = false;  ///< found, and before the focal distance
};

/// Projects `x` along the interpolated normal: Newton on sum N_a (X_a + g V_a) = x.
QuadPoint locate_in_quad(const QuadPrism& quad, const Vec3& x);

/// Gap, normal and their derivatives of `x` at its place in the prism.
FootPoint make_foot_point(const QuadPrism& quad, const QuadPoint& at, const Vec3& x);

/// Foot point at the given xi and eta for an `x` that does not project there: normal and gap
/// along it, without curvature.
FootPoint make_fixed_foot(const QuadPrism& quad, double xi, double eta, const Vec3& x);

/// A facet that is half of a quadrilateral.
struct QuadHalf {
  int quad = -1;                ///< number of the quad; -1: a triangle of its own
  std::array<int, 3> corner{};  ///< the quad's corner at each corner of the facet
};

/// Which facets of a triangle mesh are quadrilaterals, for search by splitting.
struct QuadCover {
  std::vector<std::array<int, 4>> quads;  ///< points, counter-clockwise; corners 0 and 2 lie on the diagonal
  std::vector<QuadHalf> halves;           ///< one a facet
};

/// `pairs`: facets that were split from one quadrilateral. Pairs that do not share an edge, and quads
/// that are not convex, stay triangles.
QuadCover cover_with_quads(const TriangleMesh& mesh, const std::vector<std::array<int, 2>>& pairs);

}  // namespace hydroscope
