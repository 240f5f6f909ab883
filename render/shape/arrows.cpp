// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/arrows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "render/shape/sheet_shape.h"

namespace hydroscope {
namespace {

constexpr int kSides = 6;            // of the drawn prism and cone: round enough at arrow size
constexpr double kHeadLength = 1.6;  // of the head's diameter
constexpr double kShaft = 0.38;      // shaft's diameter, of the head's

/// Appends a frustum from `a` (radius ra) to `b` (radius rb) around unit axis t.
void add_frustum(Surface& surface, const Vec3& a, double ra, const Vec3& b, double rb, const Mat3& frame,
                 float value) {
  const Vec3 t = frame.col(2);
  const double length = (b - a).norm();
  const int first = static_cast<int>(surface.points.size());
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kSides;
    const Vec3 radial = std::cos(angle) * frame.col(0) + std::sin(angle) * frame.col(1);
    const Vec3 normal = length > 0.0 ? Vec3((length * radial + (ra - rb) * t).normalized()) : Vec3(-t);
    surface.add_point(a + ra * radial, normal);
    surface.add_point(b + rb * radial, normal);
    surface.values.insert(surface.values.end(), 2, value);
    const int next = (k + 1) % kSides;
    surface.polygons.push_back({first + 2 * k, first + 2 * next, first + 2 * next + 1, first + 2 * k + 1});
  }
}

void add_arrow(Surface& surface, const Arrow& arrow, double width) {
  const double length = arrow.span.norm();
  if (!(length > 0.0)) return;
  const double head_length = std::min(kHeadLength * width, 0.6 * length);
  const double radius = 0.5 * head_length / kHeadLength;
  Mat3 frame;
  frame.col(2) = arrow.span / length;
  frame.col(0) = frame.col(2).unitOrthogonal();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  const Vec3 neck = arrow.start + (length - head_length) * frame.col(2);
  const Vec3 tip = arrow.start + arrow.span;
  const auto value = static_cast<float>(arrow.value);
  add_frustum(surface, arrow.start, 0.0, arrow.start, kShaft * radius, frame,
              value);  // closed: drawn from outside only
  add_frustum(surface, arrow.start, kShaft * radius, neck, kShaft * radius, frame, value);
  add_frustum(surface, neck, kShaft * radius, neck, radius, frame, value);  // the head's back
  add_frustum(surface, neck, radius, tip, 0.0, frame, value);
}

/// Greedy choice in order of the points; gives up past `limit`.
std::vector<int> choose_apart(const std::vector<Vec3>& points, double distance, std::size_t limit) {
  std::map<std::array<long, 3>, std::vector<int>> cells;
  std::vector<int> chosen;
  for (std::size_t i = 0; i < points.size() && chosen.size() <= limit; ++i) {
    std::array<long, 3> cell;
    for (int c = 0; c < 3; ++c) cell[static_cast<std::size_t>(c)] = std::lround(points[i][c] / distance);
    bool is_free = true;
    for (int k = 0; k < 27 && is_free; ++k) {
      const auto near = cells.find({cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1});
      if (near == cells.end()) continue;
      for (int other : near->second)
        is_free = is_free && (points[static_cast<std::size_t>(other)] - points[i]).norm() >= distance;
    }
    if (!is_free) continue;
    cells[cell].push_back(static_cast<int>(i));
    chosen.push_back(static_cast<int>(i));
  }
  return chosen;
}

}  // namespace

Surface make_arrows(const std::vector<Arrow>& arrows, double width,
                    const std::vector<Reflection>& reflections) {
  Surface piece;
  for (const Arrow& arrow : arrows) add_arrow(piece, arrow, width);
  return calc_reflected(piece, reflections);
}

std::vector<int> find_spread_points(const std::vector<Vec3>& points, int count) {
  const auto limit = static_cast<std::size_t>(std::max(count, 1));
  Bounds bounds;
  for (const Vec3& x : points) bounds.include(x);
  if (points.size() <= limit) {
    std::vector<int> all;
    for (std::size_t i = 0; i < points.size(); ++i) all.push_back(static_cast<int>(i));
    return all;
  }
  if (!(bounds.diagonal() > 0.0)) return {0};
  // The distance is halved until there are too many, then bisected.
  double large = bounds.diagonal(), small = 0.5 * large;
  std::vector<int> best = choose_apart(points, large, limit);
  for (int i = 0; i < 40; ++i, large = small, small *= 0.5) {
    std::vector<int> chosen = choose_apart(points, small, limit);
    if (chosen.size() > limit) break;
    best = std::move(chosen);
  }
  for (int i = 0; i < 8; ++i) {
    const double middle = 0.5 * (large + small);
    std::vector<int> chosen = choose_apart(points, middle, limit);
    (chosen.size() > limit ? small : large) = middle;
    if (chosen.size() <= limit) best = std::move(chosen);
  }
  return best;
}

}  // namespace hydroscope
