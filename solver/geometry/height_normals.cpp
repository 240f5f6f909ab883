// SPDX-License-Identifier: GPL-3.0-or-later
// Normals of a point set, and its picture.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/base/error.h"
#include "solver/geometry/height_surface.h"

namespace hydroscope {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

HeightSurface::HeightSurface(HeightField field, const Pose& pose, NormalRule normals, double crease_angle)
    : field_(std::move(field)), pose_(pose), keeps_cell_normals_(normals == NormalRule::facet) {
  require(field_.columns > 1 && field_.rows > 1, "a point set needs two columns and two rows");
  low_ = std::numeric_limits<double>::infinity();
  high_ = -low_;
  for (double height : field_.heights) {
    if (!std::isfinite(height)) continue;
    low_ = std::min(low_, height);
    high_ = std::max(high_, height);
  }
  make_normals(normals);
  count_sharp_edges(crease_angle);
  make_display();
}

void HeightSurface::make_normals(NormalRule rule) {
  const int cells = (field_.columns - 1) * (field_.rows - 1);
  normals_.assign(keeps_cell_normals_ ? at(4 * cells) : field_.heights.size(), Vec3::Zero());
  for (int c = 0; c < cells; ++c) {
    const Cell cell = cell_of(c);
    if (!has_cell(cell)) continue;
    const std::array<Vec3, 4> x = list_corners(cell);
    const double area = 0.5 * (x[2] - x[0]).cross(x[3] - x[1]).norm();
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec3 share = weigh_corner(x[(k + 1) % 4] - x[k], x[(k + 3) % 4] - x[k], area, rule);  // (4.1)
      const int i = cell.i + (k == 1 || k == 2 ? 1 : 0);
      const int j = cell.j + (k >= 2 ? 1 : 0);
      normals_[keeps_cell_normals_ ? at(4 * c) + k : at(j * field_.columns + i)] += share;  // (4.3), (4.4)
    }
  }
  for (Vec3& normal : normals_) {
    if (normal.norm() > 0.0) normal.normalize();
  }
}

void HeightSurface::count_sharp_edges(double crease_angle) {
  const auto normal_of = [&](const Cell& cell) {
    const std::array<Vec3, 4> x = list_corners(cell);
    return Vec3((x[2] - x[0]).cross(x[3] - x[1]));
  };
  const double limit = crease_angle * std::numbers::pi / 180.0;
  for (int c = 0; c < (field_.columns - 1) * (field_.rows - 1); ++c) {
    const Cell cell = cell_of(c);
    for (const Cell& next : {Cell{cell.i + 1, cell.j}, Cell{cell.i, cell.j + 1}}) {
      if (!has_cell(cell) || !has_cell(next)) continue;
      const Vec3 a = normal_of(cell), b = normal_of(next);
      if (std::atan2(a.cross(b).norm(), a.dot(b)) > limit) ++sharp_edges_;
    }
  }
}

void HeightSurface::make_display() {
  // Two facets a cell, in order; missing cells have none.
  const int cells = (field_.columns - 1) * (field_.rows - 1);
  std::vector<int> number(field_.heights.size(), -1);
  for (int j = 0; j < field_.rows; ++j) {
    for (int i = 0; i < field_.columns; ++i) {
      if (!field_.has_point(i, j)) continue;
      number[at(j * field_.columns + i)] = static_cast<int>(display_mesh_.points.size());
      display_mesh_.points.push_back(pose_.place_point(field_.point(i, j)));
      display_normals_.push_back(Vec3::Zero());
    }
  }
  for (int c = 0; c < cells; ++c) {
    const Cell cell = cell_of(c);
    if (!has_cell(cell)) continue;
    const std::array<Vec3, 4> normals = list_normals(cell);
    std::array<int, 4> p{};
    for (int k = 0; k < 4; ++k) {
      p[at(k)] =
          number[at((cell.j + (k >= 2 ? 1 : 0)) * field_.columns + cell.i + (k == 1 || k == 2 ? 1 : 0))];
      display_normals_[at(p[at(k)])] += pose_.place_direction(normals[at(k)]);
    }
    display_mesh_.triangles.push_back({p[0], p[1], p[2]});
    display_mesh_.triangles.push_back({p[0], p[2], p[3]});
  }
  for (Vec3& normal : display_normals_) {
    normal = normal.norm() > 0.0 ? Vec3(normal.normalized()) : pose_.place_direction(Vec3::UnitZ());
  }
}

}  // namespace hydroscope
