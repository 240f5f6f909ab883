// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/wall_section.h"

#include <algorithm>
#include <cmath>

namespace hydroscope {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

constexpr double kSame = 1e-9;  // [mm]

/// A corner of the wall, and how far it lies beyond the plane [mm].
struct Corner {
  Vec3 x = Vec3::Zero();
  double s = 0.0;
};

/// Both faces of one copy.
struct CopyOfWall {
  std::vector<Corner> outer, inner;
};

CopyOfWall make_copy(const Snapshot& snapshot, const Reflection& reflection, const Plane& plane) {
  CopyOfWall copy;
  const auto make_corner = [&](const Vec3& x) {
    const Vec3 y = reflection.point(x);
    const double s = plane.normal.dot(y - plane.point);
    // Rounding decides nothing: on a plane of symmetry the copies on both sides must agree.
    return Corner{y, std::abs(s) < kSame ? 0.0 : s};
  };
  for (std::size_t i = 0; i < snapshot.points.size(); ++i) {
    const Vec3 half = 0.5 * snapshot.thickness[i] * snapshot.directors[i];
    copy.outer.push_back(make_corner(snapshot.points[i] + half));
    copy.inner.push_back(make_corner(snapshot.points[i] - half));
  }
  return copy;
}

/// At most one crossing an edge; half-open, so that a corner in the plane is met once.
bool cross(const Corner& a, const Corner& b, Vec3& x) {
  if ((a.s < 0.0) == (b.s < 0.0)) return false;
  x = a.x + a.s / (a.s - b.s) * (b.x - a.x);
  return true;
}

void add_border(LineSet& borders, const std::array<Corner, 3>& face) {
  std::array<Vec3, 3> hits;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (cross(face[k], face[(k + 1) % 3], hits[count])) ++count;
  if (count == 2) borders.add_line(hits[0], hits[1]);
}

/// The prism below a triangle of the outer face: its cut has at most five corners.
void add_area(Surface& area, const std::array<Corner, 3>& outer, const std::array<Corner, 3>& inner,
              const Vec3& normal) {
  std::vector<Vec3> hits;
  Vec3 hit;
  for (std::size_t k = 0; k < 3; ++k) {
    if (cross(outer[k], outer[(k + 1) % 3], hit)) hits.push_back(hit);
    if (cross(inner[k], inner[(k + 1) % 3], hit)) hits.push_back(hit);
    if (cross(outer[k], inner[k], hit)) hits.push_back(hit);
  }
  if (hits.size() < 3) return;
  Vec3 middle = Vec3::Zero();
  for (const Vec3& x : hits) middle += x / static_cast<double>(hits.size());
  const Vec3 e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  const auto turn = [&](const Vec3& x) { return std::atan2(e2.dot(x - middle), e1.dot(x - middle)); };
  std::sort(hits.begin(), hits.end(), [&](const Vec3& a, const Vec3& b) { return turn(a) < turn(b); });
  const int first = static_cast<int>(area.points.size());
  for (const Vec3& x : hits) area.add_point(x, normal);
  for (int k = 2; k < static_cast<int>(hits.size()); ++k)
    area.polygons.push_back({first, first + k - 1, first + k, -1});
}

}  // namespace

WallSection calc_wall_section(const Snapshot& snapshot, const std::vector<Reflection>& reflections,
                              const Plane& plane) {
  WallSection section;
  for (const Reflection& reflection : reflections) {
    const CopyOfWall copy = make_copy(snapshot, reflection, plane);
    for (const auto& quad : snapshot.model->quads)
      for (const std::size_t half : {1u, 2u}) {
        const std::array<std::size_t, 3> nodes{at(quad[0]), at(quad[half]), at(quad[half + 1])};
        std::array<Corner, 3> outer, inner;
        int beyond = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          outer[k] = copy.outer[nodes[k]];
          inner[k] = copy.inner[nodes[k]];
          beyond += (outer[k].s < 0.0 ? 0 : 1) + (inner[k].s < 0.0 ? 0 : 1);
        }
        if (beyond == 0 || beyond == 6) continue;
        add_area(section.area, outer, inner, plane.normal);
        add_border(section.borders, outer);
        add_border(section.borders, inner);
      }
  }
  return section;
}

}  // namespace hydroscope
