// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "solver/scene/scene.h"
#include "solver/session/mesh_facts.h"

namespace hydroscope {

/// Whether something holds, and what stands against it.
struct Symmetry {
  bool holds = true;
  std::string obstacle;  ///< empty when it holds

  void refuse(const std::string& why) {
    if (holds) obstacle = why;
    holds = false;
  }
};

/// What loads, ends and tools of a tube have in common with their images.
struct PartSymmetry {
  Symmetry around;                       ///< the same at every angle
  Symmetry plane_0, plane_45, plane_90;  ///< mirror planes through the axis, at that angle from +x
  Symmetry middle;                       ///< mirror plane z = 0
  Symmetry along;                        ///< the same at every z, and nothing moves along z: plane strain
};

/// Tools as placed, with their motion and friction, the ends, and the sign of the pressure. Tools from meshes
/// are judged by their facts; a tool from a mesh without facts, and a point set, has no symmetry.
PartSymmetry find_symmetry(const Scene& scene, const std::map<std::string, MeshFacts>& facts);

}  // namespace hydroscope
