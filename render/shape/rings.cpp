// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/rings.h"

#include <cmath>
#include <numbers>

namespace hydroscope {

Surface make_rings(const std::vector<Vec3>& centres, double inner, double outer, const Vec3& towards_viewer) {
  constexpr int kSides = 20;
  const Vec3 e1 = towards_viewer.unitOrthogonal(), e2 = towards_viewer.cross(e1);
  Surface rings;
  for (const Vec3& centre : centres) {
    const int first = static_cast<int>(rings.points.size());
    for (int k = 0; k < kSides; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kSides;
      const Vec3 radial = std::cos(angle) * e1 + std::sin(angle) * e2;
      rings.add_point(centre + inner * radial, towards_viewer);
      rings.add_point(centre + outer * radial, towards_viewer);
      const int a = first + 2 * k, b = first + 2 * ((k + 1) % kSides);
      rings.polygons.push_back({a, a + 1, b + 1, b});
    }
  }
  return rings;
}

}  // namespace hydroscope
