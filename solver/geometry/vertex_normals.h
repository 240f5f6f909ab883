// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "solver/base/types.h"
#include "solver/geometry/mesh_topology.h"
#include "solver/geometry/quad_prism.h"

namespace hydroscope {

/// How the normals of the facets around a tool node are weighted into its own.
enum class NormalRule {
  facet,  ///< not at all: every facet keeps its own, discontinuous normal (4.1)
  plain,  ///< equal weights (4.3)
  area,   ///< by area (4.4), the source's choice
  angle,  ///< by the facet's angle at the node
  max,    ///< N. Max 1999: exact for nodes on a sphere
};

/// "facet", "plain", "area", "angle" or "max"; throws InputError otherwise.
NormalRule parse_normal_rule(const std::string& name);

/// What a corner of an element adds to the normal of its node, by weight: `e1`, `e2` the element's edges
/// there, counter-clockwise; `area` that of the element [mm^2]. Of rule `facet`: the corner's own normal
/// (4.1).
Vec3 weigh_corner(const Vec3& e1, const Vec3& e2, double area, NormalRule rule);

/// One unit normal for each group of facets around a point that no crease parts.
/// A point on a crease has one for each side of it.
struct CornerNormals {
  std::vector<Vec3> normals;                // unit
  std::vector<int> points;                  // mesh point of each normal
  std::vector<std::array<int, 3>> corners;  // index into `normals` for each corner of each facet
};

/// `crease_angle` [rad]: normals are not averaged over an edge whose facets differ by more. A quadrilateral
/// of `cover` counts as one element with a normal at each of its vertices (4.1); its diagonal is no edge.
CornerNormals calc_corner_normals(const TriangleMesh& mesh, const MeshTopology& topology, NormalRule rule,
                                  double crease_angle, const QuadCover& cover = {});

/// True when edge `edge` of `facet` parts the normals: sharper than `crease_angle` [rad],
/// or its facets face opposite ways.
bool is_crease(const MeshTopology& topology, const std::vector<Vec3>& facet_normals, int facet, int edge,
               double crease_angle);

}  // namespace hydroscope
