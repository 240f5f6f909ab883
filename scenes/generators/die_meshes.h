// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/base/types.h"

namespace hydroscope {

/// How much of a die's circumference is written. A quarter reaches from the x axis to the y axis,
/// an octant from the x axis to the 45 degree line, both two facets beyond them,
/// so that nodes on symmetry planes lie well inside the mesh.
enum class Coverage { full, quarter, octant };

/// Straight square cavity with rounded corners along z, |z| <= length / 2.
struct SquareDie {
  double half_width = 30.75;    ///< [mm]: touches a tube of mid-surface radius 30 and wall 1.5
  double corner_radius = 10.0;  ///< [mm]
  double length = 40.0;         ///< [mm]
  int corner_facets = 14;       ///< around a corner of 90 degrees, even
  int flat_facets = 20;         ///< along a flat, even; as fine as the corner's at the tangent lines
  double row = 4.0;             ///< [mm]: facet size along z
  Coverage coverage = Coverage::quarter;
};

/// Six flat facets a corner, 15 degrees each: what noise of facets does (scenes/coarse-die.toml).
inline constexpr SquareDie kCoarseDie{30.75, 20.0, 40.0, 6, 4, 4.0, Coverage::quarter};

/// Round guides lofted into a square cavity with rounded corners; square for |z| <= square_end,
/// round for |z| >= round_start. The radius goes from one to the other along half a cosine wave.
struct SquareBulgeDie {
  double guide_radius = 30.80;  ///< [mm]: tube outer radius 30.75 and 0.05 clearance
  double half_width = 36.0;     ///< [mm]
  double corner_radius = 12.0;  ///< [mm]
  double square_end = 30.0;     ///< [mm]
  double round_start = 70.0;    ///< [mm]
  double half_length = 95.0;    ///< [mm]: a tube of 2 x 90 ends inside
  int corner_facets = 18;       ///< around a corner, even
  int flat_facets = 26;         ///< along a flat, even
  int loft_rows = 32;           ///< facets along the transition
  double row = 3.0;             ///< [mm]: largest facet along z where the section is constant
  Coverage coverage = Coverage::quarter;
  bool is_half_length = true;  ///< z >= 0 and a little beyond, instead of both halves
};

/// Part of a round punch about the z axis, the sheet outside, |z| <= length / 2.
struct Punch {
  double radius = 29.25;     ///< [mm]: bends a sheet of 1.5 mm to a mid-surface radius of 30
  double start = 180.0;      ///< [deg] from the x axis
  double end = 360.0;        ///< [deg]
  double length = 20.0;      ///< [mm]
  double facet_angle = 3.0;  ///< [deg], at most
  double row = 2.0;          ///< [mm]
};

/// Facets are counter-clockwise seen from the sheet. Meshes mirror exactly about x = 0, y = 0, the
/// 45 degree planes and z = 0, so that averaged normals on symmetry planes lie in them.
TriangleMesh make_square_die(const SquareDie& die);
TriangleMesh make_square_bulge_die(const SquareBulgeDie& die);
TriangleMesh make_punch(const Punch& punch);

}  // namespace hydroscope
