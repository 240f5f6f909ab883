// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/base/types.h"
#include "solver/scene/scene.h"

namespace hydroscope {

/// Structured mid-surface mesh of a tube or a strip with what the model needs to
/// know about its borders. Direction 1 of the quads runs around (along the
/// strip), direction 2 along z; g1 x g2 points to the outer face.
struct SheetMesh {
  QuadMesh mesh;                  ///< [mm]
  std::vector<Vec3> directors;    ///< unit, towards the outer face
  int n_around = 0, n_along = 0;  ///< node counts; node = along * n_around + around
  bool is_ring = false;           ///< closed around
  std::vector<double> positions;  ///< of the node columns: angle [deg] or share of the strip's length
  std::vector<double> z;          ///< of the node rows [mm]
  struct SymmetryPlane {
    Vec3 normal;
    std::vector<int> nodes;
  };
  std::vector<SymmetryPlane> symmetry;
  std::vector<Plane> mirrors;  ///< for pictures, in doubling order
  std::vector<int> start_nodes,
      end_nodes;       ///< tube: ends at low and high z that are not symmetry planes; strip: its two edges
  double width = 0.0;  ///< modelled length along z [mm]

  int node(int around, int along) const { return along * n_around + around % n_around; }
};

/// Throws InputError for element counts and sizes that make no mesh.
SheetMesh make_tube_mesh(const TubeScene& scene);
SheetMesh make_strip_mesh(const StripScene& scene);

/// Cuts [from, to] into n parts whose lengths follow the piecewise-linear size
/// function `grading` of (position, relative size).
std::vector<double> divide(double from, double to, int n, const std::vector<std::array<double, 2>>& grading);

}  // namespace hydroscope
