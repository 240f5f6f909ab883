// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/reflection.h"

#include <algorithm>

namespace hydroscope {

std::vector<Reflection> calc_reflections(const std::vector<Plane>& mirrors) {
  std::vector<Reflection> all{Reflection{}};
  for (const Plane& plane : mirrors) {
    const Vec3 n = plane.normal.normalized();
    const Mat3 Q = Mat3::Identity() - 2.0 * n * n.transpose();
    const Vec3 c = 2.0 * n * n.dot(plane.point);
    const std::size_t made = all.size();
    for (std::size_t i = 0; i < made; ++i) {
      const Reflection before = all[i];
      all.push_back({Q * before.Q, Q * before.c + c, !before.flips});
    }
  }
  return all;
}

std::vector<Plane> find_open_mirrors(const std::vector<Plane>& mirrors, const std::vector<Vec3>& points) {
  std::vector<Plane> open;
  for (const Plane& plane : mirrors) {
    double below = 0.0, above = 0.0;
    for (const Vec3& x : points) {
      const double s = plane.normal.dot(x - plane.point);
      below = std::max(below, -s);
      above = std::max(above, s);
    }
    if (std::min(below, above) > 0.5 * std::max(below, above)) continue;
    open.push_back({plane.point, below >= above ? plane.normal : Vec3(-plane.normal)});
  }
  return open;
}

}  // namespace hydroscope
