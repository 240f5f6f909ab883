// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include "solver/base/types.h"
#include "solver/geometry/grid_mesh.h"
#include "solver/geometry/pose.h"
#include "solver/geometry/tool_surface.h"

namespace hydroscope::test {

inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Repeatable random numbers and points.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  double number(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v(number(-1, 1), number(-1, 1), number(-1, 1));
      if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
    }
  }

 private:
  std::mt19937 engine_;
};

/// Icosahedron on a sphere of `radius` [mm], each facet split into four `times` times: 20, 80, 320, ...
/// facets.
inline TriangleMesh make_icosphere(double radius, int times) {
  const double p = std::numbers::phi;
  TriangleMesh mesh;
  mesh.points = {{-1, p, 0},  {1, p, 0},  {-1, -p, 0}, {1, -p, 0}, {0, -1, p},  {0, 1, p},
                 {0, -1, -p}, {0, 1, -p}, {p, 0, -1},  {p, 0, 1},  {-p, 0, -1}, {-p, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int i = 0; i < times; ++i) {
    std::map<std::pair<int, int>, int> middle;
    std::vector<std::array<int, 3>> finer;
    const auto split = [&](int a, int b) {
      const auto [slot, is_new] =
          middle.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(mesh.points.size()));
      if (is_new) {
        const Vec3 sum = mesh.points[at(a)].normalized() + mesh.points[at(b)].normalized();
        mesh.points.push_back(sum.normalized());
      }
      return slot->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
      const int ab = split(a, b), bc = split(b, c), ca = split(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& point : mesh.points) point = radius * point.normalized();
  return mesh;
}

/// Torus about z, closed; normals outwards.
inline TriangleMesh make_torus(double radius, double minor_radius, int around, int turns) {
  return make_grid_mesh(around + 1, turns + 1, [&](int i, int j) {
    const double a = 2 * std::numbers::pi * (i % around) / around;
    const double t = 2 * std::numbers::pi * (j % turns) / turns;
    const double rho = radius + minor_radius * std::cos(t);
    return Vec3(rho * std::cos(a), rho * std::sin(a), minor_radius * std::sin(t));
  });
}

/// Axis-parallel cube of edge 2 `half`, every face a grid of `cells` (a power of two: exact) squares.
inline TriangleMesh make_cube(double half, int cells) {
  TriangleMesh cube;
  for (int axis = 0; axis < 3; ++axis) {
    for (double sign : {-1.0, 1.0}) {
      const TriangleMesh face = make_grid_mesh(cells + 1, cells + 1, [&](int i, int j) {
        Vec3 p;
        p[axis] = sign * half;
        p[(axis + 1) % 3] = sign * half * (2.0 * i / cells - 1.0);
        p[(axis + 2) % 3] = half * (2.0 * j / cells - 1.0);
        return p;
      });
      const int offset = static_cast<int>(cube.points.size());
      cube.points.insert(cube.points.end(), face.points.begin(), face.points.end());
      for (auto t : face.triangles) cube.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    }
  }
  std::map<std::array<double, 3>, int> known;
  TriangleMesh welded;
  for (auto t : cube.triangles) {
    for (int& p : t) {
      const Vec3& x = cube.points[at(p)];
      const auto [slot, is_new] =
          known.try_emplace({x[0] + 0.0, x[1] + 0.0, x[2] + 0.0}, static_cast<int>(welded.points.size()));
      if (is_new) welded.points.push_back(x);
      p = slot->second;
    }
    welded.triangles.push_back(t);
  }
  return welded;
}

/// Largest difference between the gradients of a foot point and central differences.
struct GradientError {
  double normal = 0.0, gap = 0.0;
};
inline GradientError measure_gradients(const ToolSurface& tool, const Vec3& x, double step) {
  SearchHint hint;
  const FootPoint here = *tool.find_foot_point(x, 1e3, 1e3, hint);
  GradientError error;
  for (int i = 0; i < 3; ++i) {
    const FootPoint up = *tool.find_foot_point(x + step * Vec3::Unit(i), 1e3, 1e3, hint);
    const FootPoint down = *tool.find_foot_point(x - step * Vec3::Unit(i), 1e3, 1e3, hint);
    const Vec3 n_rate = (up.normal - down.normal) / (2 * step);
    error.normal = std::max(error.normal, (n_rate - here.normal_gradient.col(i)).norm());
    error.gap = std::max(error.gap, std::abs((up.gap - down.gap) / (2 * step) - here.gap_gradient[i]));
  }
  return error;
}

}  // namespace hydroscope::test
