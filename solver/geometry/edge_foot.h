// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "solver/base/types.h"
#include "solver/geometry/tool_surface.h"

namespace hydroscope {

/// An edge that no prism answers for beyond itself: a crease (two normals a node) or an open rim (one).
struct ToolEdge {
  Vec3 start, end;              // [mm], counter-clockwise on the facet it belongs to
  Vec3 start_left, end_left;    // normals on the side of that facet
  Vec3 start_right, end_right;  // normals on the side of its neighbour; of a rim the same as left
  double bend = 0.0;            // of a rim of smooth facets, see Prism::bend [mm]
};

/// Foot point on a crease for `x` in the wedge between the prisms of its two sides; the normal
/// swings from one to the other like on a fillet of no radius. `floor` [mm]: the curvature is
/// 1 / |gap|, but no more than 1 / floor. Nothing when `x` is outside of the wedge.
std::optional<FootPoint> find_crease_foot(const ToolEdge& edge, const Vec3& x, double floor);

/// Foot point on an open rim for `x` beyond it.
struct RimFoot {
  FootPoint foot;
  int end = 0;  ///< -1, +1: `x` lies beyond the start or the end of the edge, and the foot there
};
RimFoot find_rim_foot(const ToolEdge& edge, const Vec3& x);

/// Foot point in the tip `corner` where creases meet; `normal`: which side is free. `floor` as above.
FootPoint find_tip_foot(const Vec3& corner, const Vec3& normal, const Vec3& x, double floor);

}  // namespace hydroscope
