// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/clip_mesh.h"

#include <algorithm>

namespace hydroscope {

TriangleMesh clip_to_half_spaces(const TriangleMesh& mesh, const std::vector<Plane>& planes, double margin) {
  TriangleMesh clipped;
  std::vector<int> number(mesh.points.size(), -1);
  for (const auto& triangle : mesh.triangles) {
    const bool is_outside = std::any_of(planes.begin(), planes.end(), [&](const Plane& plane) {
      return std::all_of(triangle.begin(), triangle.end(), [&](int p) {
        return (mesh.points[static_cast<std::size_t>(p)] - plane.point).dot(plane.normal) < -margin;
      });
    });
    if (is_outside) continue;
    std::array<int, 3> kept{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = static_cast<std::size_t>(triangle[k]);
      if (number[p] < 0) {
        number[p] = static_cast<int>(clipped.points.size());
        clipped.points.push_back(mesh.points[p]);
      }
      kept[k] = number[p];
    }
    clipped.triangles.push_back(kept);
  }
  return clipped;
}

}  // namespace hydroscope
