// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/markers.h"

#include <cmath>
#include <numbers>

namespace hydroscope {
namespace {

constexpr int kAround = 10, kBands = 5;  // of a ball: round enough at the size of a letter

void add_ball(Surface& surface, const Vec3& centre, double radius) {
  const int first = static_cast<int>(surface.points.size());
  for (int j = 0; j <= kBands; ++j)
    for (int i = 0; i < kAround; ++i) {
      const double polar = std::numbers::pi * j / kBands, turn = 2.0 * std::numbers::pi * i / kAround;
      const Vec3 out(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
      surface.add_point(centre + radius * out, out);
    }
  for (int j = 0; j < kBands; ++j)
    for (int i = 0; i < kAround; ++i) {
      const int a = first + j * kAround + i, b = first + j * kAround + (i + 1) % kAround;
      surface.polygons.push_back({a, a + kAround, b + kAround, b});
    }
}

}  // namespace

Surface make_markers(const std::vector<Vec3>& centres, double radius,
                     const std::vector<Reflection>& reflections) {
  Surface piece;
  for (const Vec3& centre : centres) add_ball(piece, centre, radius);
  return calc_reflected(piece, reflections);
}

}  // namespace hydroscope
