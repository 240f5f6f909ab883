// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "solver/shell/shell_element.h"
#include "solver/system/block_matrix.h"

namespace hydroscope::verification {

/// A point of a mid-surface with its unit normal and one unit tangent, which becomes V1 of the node.
struct SurfacePoint {
  Vec3 x, normal, tangent;
};

/// A linear elastic shell of our elements about its stress-free state, small displacements.
struct LinearShell {
  double youngs_modulus = 0.0, poisson = 0.0, thickness = 0.0;
  std::vector<Vec3> x;
  std::vector<Triad> triad;
  std::vector<std::array<int, 4>> quads;
  std::vector<char> is_held;  ///< one a degree of freedom
  Vector load;                ///< [N, N mm]

  /// A patch of n1 x n2 elements; `point(i, j)` for i = 0..n1, j = 0..n2. Points nearer than `merge` to an
  /// earlier one are that one. Returns the node of (i, j) at [j * (n1 + 1) + i].
  std::vector<int> add_patch(int n1, int n2, const std::function<SurfacePoint(int, int)>& point,
                             double merge);
  /// To be called once, after the patches.
  void finish_mesh();

  void hold(int node, const std::vector<int>& components);
  /// Dead load per mid-surface area [MPa].
  void add_area_load(const Vec3& per_area);

  /// Displacements and rotations: K q = load.
  Vector solve() const;
};

}  // namespace hydroscope::verification
