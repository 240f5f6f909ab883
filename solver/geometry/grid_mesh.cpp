// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/grid_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

/// Sum of a geometric series of n terms from 1 with ratio q.
double calc_series(double q, int n) {
  return std::abs(q - 1.0) < 1e-12 ? n : (std::pow(q, n) - 1.0) / (q - 1.0);
}

double calc_distance(const TriangleMesh& mesh, int p, int q) {
  return (mesh.points[static_cast<std::size_t>(p)] - mesh.points[static_cast<std::size_t>(q)]).norm();
}

}  // namespace

TriangleMesh make_grid_mesh(int columns, int rows, const std::function<Vec3(int, int)>& point,
                            const std::function<bool(int, int)>& rises) {
  require(columns > 1 && rows > 1, "a grid needs at least two points each way");
  TriangleMesh mesh;
  std::map<std::array<double, 3>, int> known;
  std::vector<int> ids(static_cast<std::size_t>(columns * rows));
  const auto id = [&](int i, int j) -> int& { return ids[static_cast<std::size_t>(j * columns + i)]; };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const Vec3 p = point(i, j);
      const auto [slot, is_new] =
          known.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(mesh.points.size()));
      if (is_new) mesh.points.push_back(p);
      id(i, j) = slot->second;
    }
  }
  const auto add = [&](int a, int b, int c) {
    if (a != b && b != c && c != a) mesh.triangles.push_back({a, b, c});
  };
  for (int j = 0; j + 1 < rows; ++j) {
    for (int i = 0; i + 1 < columns; ++i) {
      const int a = id(i, j), b = id(i + 1, j), c = id(i + 1, j + 1), d = id(i, j + 1);
      const bool is_rising =
          rises ? rises(i, j) : calc_distance(mesh, a, c) <= calc_distance(mesh, b, d) * (1.0 + 1e-9);
      if (is_rising) {
        add(a, b, c);
        add(a, c, d);
      } else {
        add(a, b, d);
        add(b, c, d);
      }
    }
  }
  return mesh;
}

std::vector<double> make_graded_steps(double end_size, int steps) {
  require(steps > 1 && end_size > 0.0, "grading needs two steps or more and a size");
  const int half = steps / 2;
  // Half of the range is filled by a geometric series that begins with end_size.
  double low = 1.0;
  double high = 1e6;
  const double wanted = 0.5 / end_size;
  if (calc_series(1.0, half) >= wanted) high = 1.0;
  for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
    const double q = 0.5 * (low + high);
    (calc_series(q, half) < wanted ? low : high) = q;
  }
  std::vector<double> steps_to(static_cast<std::size_t>(2 * half + 1), 0.5);
  const double whole = calc_series(high, half);
  for (int i = 0; i < half; ++i) {
    const double s = 0.5 * calc_series(high, i) / whole;
    steps_to[static_cast<std::size_t>(i)] = s;
    steps_to[static_cast<std::size_t>(2 * half - i)] = 1.0 - s;
  }
  return steps_to;
}

std::vector<Vec2> make_rounded_outline(double half_width, double half_height, double corner_radius,
                                       int corner_steps, int flat_steps) {
  const Vec2 centre(half_width - corner_radius, half_height - corner_radius);
  std::vector<Vec2> outline;
  const double arc = corner_radius * std::numbers::pi / 2.0 / corner_steps;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const double sx = quarter == 0 || quarter == 3 ? 1.0 : -1.0;
    const double sy = quarter < 2 ? 1.0 : -1.0;
    for (int i = 0; i <= (corner_radius > 0.0 ? corner_steps : 0); ++i) {
      const double angle = std::numbers::pi / 2.0 * (quarter + static_cast<double>(i) / corner_steps);
      outline.emplace_back(sx * centre.x() + corner_radius * std::cos(angle),
                           sy * centre.y() + corner_radius * std::sin(angle));
    }
    const double length = 2.0 * (quarter % 2 == 0 ? centre.x() : centre.y());
    if (!(length > 0.0)) {
      outline.pop_back();
      continue;
    }
    const Vec2 start = outline.back();
    const Vec2 end(start.x() * (quarter % 2 == 0 ? -1.0 : 1.0), start.y() * (quarter % 2 == 0 ? 1.0 : -1.0));
    const double end_size = arc > 0.0 ? arc / length : 1.0 / flat_steps;
    const std::vector<double> steps = make_graded_steps(std::min(end_size, 0.5), std::max(flat_steps, 2));
    for (std::size_t i = 1; i + 1 < steps.size(); ++i) outline.push_back(start + steps[i] * (end - start));
  }
  return outline;
}

}  // namespace hydroscope
