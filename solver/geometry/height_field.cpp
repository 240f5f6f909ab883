// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/height_field.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

constexpr double kMostPoints = 2e7;

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
  throw InputError(name + ": " + what);
}

std::string describe_place(const Vec3& x) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.3f, %.3f, %.3f) mm", x.x(), x.y(), x.z());
  return text;
}

std::string describe_wall(const Vec3& x, double steepness) {
  char angle[64];
  std::snprintf(angle, sizeof angle, "%.1f deg", steepness);
  return "the surface at " + describe_place(x) + " is a wall of " + angle +
         " against the base; a point set z(x, y) describes no wall steeper than 85 deg: give it a draft, "
         "choose "
         "another height_axis, or keep the mesh (surface = \"smooth\")";
}

double calc_steepness(const Vec3& normal) {
  return std::atan2(std::hypot(normal.x(), normal.y()), normal.z()) * 180.0 / std::numbers::pi;
}

void check_facet(const std::array<Vec3, 3>& x, const std::string& name) {
  const double steepness = calc_steepness((x[1] - x[0]).cross(x[2] - x[0]));
  const Vec3 middle = (x[0] + x[1] + x[2]) / 3.0;
  if (steepness > 90.0 + 1e-6) {
    refuse(name, "the surface overhangs at " + describe_place(middle) +
                     ": a point set z(x, y) describes one height at each place; choose another height_axis, "
                     "or set flip if the free side is below");
  }
  if (steepness > kSteepestWall) refuse(name, describe_wall(middle, steepness));
}

/// Raises the heights of the points that lie under one facet.
void add_facet(const std::array<Vec3, 3>& x, HeightField& field) {
  const Vec3 low = x[0].cwiseMin(x[1]).cwiseMin(x[2]);
  const Vec3 high = x[0].cwiseMax(x[1]).cwiseMax(x[2]);
  const double area2 = (x[1] - x[0]).cross(x[2] - x[0]).z();
  // A point on an edge belongs to both facets, and one on the rim to the surface, in spite of rounding.
  const double slack = 1e-6;
  const auto first = [&](int k) {
    return static_cast<int>(std::max(0.0, std::ceil((low[k] - field.origin[k]) / field.pitch[k] - slack)));
  };
  const auto last = [&](int k, int count) {
    const double place = std::floor((high[k] - field.origin[k]) / field.pitch[k] + slack);
    return static_cast<int>(std::min(static_cast<double>(count - 1), place));
  };
  for (int j = first(1); j <= last(1, field.rows); ++j) {
    for (int i = first(0); i <= last(0, field.columns); ++i) {
      const Vec3 p(field.origin.x() + i * field.pitch.x(), field.origin.y() + j * field.pitch.y(), 0.0);
      double height = 0.0;
      bool is_inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = x[(k + 1) % 3];
        const Vec3& b = x[(k + 2) % 3];
        const double l = ((a.x() - p.x()) * (b.y() - p.y()) - (b.x() - p.x()) * (a.y() - p.y())) / area2;
        is_inside = is_inside && l >= -slack;
        height += l * x[k].z();
      }
      double& here = field.heights[static_cast<std::size_t>(j * field.columns + i)];
      if (is_inside && !(here >= height)) here = height;  // a missing one compares as false
    }
  }
}

}  // namespace

bool HeightField::has_point(int i, int j) const { return std::isfinite(height(i, j)); }

bool HeightField::has_cell(int i, int j) const {
  return has_point(i, j) && has_point(i + 1, j) && has_point(i, j + 1) && has_point(i + 1, j + 1);
}

void check_height_field(const HeightField& field, const std::string& name) {
  if (field.columns < 2 || field.rows < 2) refuse(name, "a point set needs two columns and two rows or more");
  if (!(field.pitch.minCoeff() > 0.0) || !field.pitch.allFinite() || !field.origin.allFinite()) {
    refuse(name, "the pitch of a point set must be above 0");
  }
  if (field.heights.size() !=
      static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows)) {
    refuse(name, "a point set of " + std::to_string(field.columns) + " columns and " +
                     std::to_string(field.rows) + " rows has " + std::to_string(field.heights.size()) +
                     " heights");
  }
  int cells = 0;
  for (int j = 0; j + 1 < field.rows; ++j) {
    for (int i = 0; i + 1 < field.columns; ++i) {
      if (!field.has_cell(i, j)) continue;
      ++cells;
      for (const auto& [di, dj] : {std::array{0, 0}, std::array{1, 0}, std::array{1, 1}, std::array{0, 1}}) {
        const Vec3 along_x = field.point(i + 1, j + dj) - field.point(i, j + dj);
        const Vec3 along_y = field.point(i + di, j + 1) - field.point(i + di, j);
        const double steepness = calc_steepness(along_x.cross(along_y));
        if (steepness > kSteepestWall) refuse(name, describe_wall(field.point(i + di, j + dj), steepness));
      }
    }
  }
  if (cells == 0) refuse(name, "no four neighbouring points of the point set have a height");
}

HeightField sample_heights(const TriangleMesh& mesh, double pitch, const std::string& name) {
  require(!mesh.triangles.empty() && pitch > 0.0, "sampling needs a mesh and a pitch");
  Vec3 low = mesh.points[static_cast<std::size_t>(mesh.triangles[0][0])];
  Vec3 high = low;
  const auto corners = [&](const std::array<int, 3>& t) {
    return std::array{mesh.points[static_cast<std::size_t>(t[0])],
                      mesh.points[static_cast<std::size_t>(t[1])],
                      mesh.points[static_cast<std::size_t>(t[2])]};
  };
  for (const auto& t : mesh.triangles) {
    for (const Vec3& x : corners(t)) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    check_facet(corners(t), name);
  }
  HeightField field;
  const auto count = [&](int k) { return std::max(2.0, std::ceil((high[k] - low[k]) / pitch - 1e-9) + 1.0); };
  if (!(count(0) * count(1) <= kMostPoints)) {
    refuse(name, "pitch_mm is too small: more than 20 million points");
  }
  field.columns = static_cast<int>(count(0));
  field.rows = static_cast<int>(count(1));
  field.origin = low.head<2>();
  field.pitch = Vec2((high.x() - low.x()) / (field.columns - 1), (high.y() - low.y()) / (field.rows - 1));
  field.heights.assign(static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows),
                       std::numeric_limits<double>::quiet_NaN());
  for (const auto& t : mesh.triangles) add_facet(corners(t), field);
  check_height_field(field, name);
  return field;
}

}  // namespace hydroscope
