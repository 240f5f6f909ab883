// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>

#include "solver/base/types.h"
#include "solver/scene/scene.h"

namespace hydroscope {

/// What the triangles of a tool, as placed, say about its shape.
struct MeshFacts {
  TriangleMesh mesh;                 ///< as placed [mm]
  double low_z = 0.0, high_z = 0.0;  ///< [mm]
  bool is_prismatic = false;         ///< every facet stands along z
  double least_radius =
      std::numeric_limits<double>::infinity();  ///< of curvature of what is not creased [mm]
  double facet_angle = 0.0;  ///< between neighbours, the largest that is not a crease [deg]
};

/// Reads the mesh of `tool`. Throws InputError.
MeshFacts inspect_mesh(const ToolScene& tool, const std::string& name, const std::string& directory);

/// The same of a mesh that is placed. Edges sharper than `crease_angle` [deg] have no radius.
MeshFacts inspect_mesh(const TriangleMesh& mesh, double crease_angle);

/// Whether each vertex has its mirror image among the vertices. `normal`: unit, of a plane through the
/// origin.
bool is_mirrored(const TriangleMesh& mesh, const Vec3& normal);

}  // namespace hydroscope
