// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/mesh_cleaning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>

namespace hydroscope {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Cell = std::array<std::int64_t, 3>;

struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t h = 1469598103934665603ULL;
    for (std::int64_t c : cell) h = (h ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15ULL;
    return static_cast<std::size_t>(h ^ (h >> 29));
  }
};

Cell find_cell(const Vec3& x, double size) {
  Cell cell{};
  for (int i = 0; i < 3; ++i) cell[at(i)] = static_cast<std::int64_t>(std::floor(x[i] / size));
  return cell;
}

bool is_thin(const std::vector<Vec3>& points, const std::array<int, 3>& t, double tolerance) {
  const Vec3& a = points[at(t[0])];
  const Vec3& b = points[at(t[1])];
  const Vec3& c = points[at(t[2])];
  const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
  return !((b - a).cross(c - a).norm() > tolerance * longest);
}

/// Renumbers the points so that only those of a triangle stay.
void drop_unused_points(TriangleMesh& mesh) {
  std::vector<int> number(mesh.points.size(), -1);
  std::vector<Vec3> kept;
  for (auto& triangle : mesh.triangles) {
    for (int& point : triangle) {
      int& n = number[at(point)];
      if (n < 0) {
        n = static_cast<int>(kept.size());
        kept.push_back(mesh.points[at(point)]);
      }
      point = n;
    }
  }
  mesh.points = std::move(kept);
}

}  // namespace

double calc_weld_tolerance(const std::vector<Vec3>& points) {
  if (points.empty()) return 0.0;
  Vec3 low = points[0];
  Vec3 high = points[0];
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double farthest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  return 5e-7 * (high - low).norm() + 2.5e-7 * farthest;
}

std::vector<int> weld_points(const std::vector<Vec3>& points, double tolerance) {
  std::vector<int> first(points.size());
  if (!(tolerance > 0.0)) {
    for (std::size_t i = 0; i < points.size(); ++i) first[i] = static_cast<int>(i);
    return first;
  }
  // Cells wider than the tolerance: mostly one cell to look into, eight at most.
  const double size = 4.0 * tolerance;
  std::unordered_map<Cell, std::vector<int>, CellHash> cells;
  const Vec3 margin = Vec3::Constant(tolerance);
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const Vec3& x = points[at(i)];
    const Cell low = find_cell(x - margin, size);
    const Cell high = find_cell(x + margin, size);
    int found = i;
    for (std::int64_t a = low[0]; a <= high[0]; ++a) {
      for (std::int64_t b = low[1]; b <= high[1]; ++b) {
        for (std::int64_t c = low[2]; c <= high[2]; ++c) {
          const auto cell = cells.find({a, b, c});
          if (cell == cells.end()) continue;
          for (int j : cell->second) {
            if (j < found && (points[at(j)] - x).norm() <= tolerance) found = j;
          }
        }
      }
    }
    first[at(i)] = found;
    if (found == i) cells[find_cell(x, size)].push_back(i);
  }
  return first;
}

int split_polygons(const PolygonSoup& soup, std::vector<std::array<int, 3>>& triangles,
                   std::vector<int>& quad_of) {
  int split = 0;
  int quads = 0;
  for (const std::vector<int>& polygon : soup.polygons) {
    if (polygon.size() < 3) continue;
    if (polygon.size() > 3) ++split;
    std::size_t start = 0;
    if (polygon.size() == 4) {
      const auto length2 = [&](std::size_t i, std::size_t j) {
        return (soup.points[at(polygon[i])] - soup.points[at(polygon[j])]).squaredNorm();
      };
      start = length2(0, 2) <= length2(1, 3) ? 0 : 1;
    }
    const auto corner = [&](std::size_t i) { return polygon[(start + i) % polygon.size()]; };
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
      triangles.push_back({corner(0), corner(i), corner(i + 1)});
      quad_of.push_back(polygon.size() == 4 ? quads : -1);
    }
    if (polygon.size() == 4) ++quads;
  }
  return split;
}

CleanedMesh clean_mesh(const PolygonSoup& soup) {
  CleanedMesh cleaned;
  const double tolerance = calc_weld_tolerance(soup.points);
  const std::vector<int> first = weld_points(soup.points, tolerance);
  for (std::size_t i = 0; i < first.size(); ++i) cleaned.points_welded += at(first[i]) != i ? 1 : 0;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> quad_of;
  cleaned.polygons_split = split_polygons(soup, triangles, quad_of);
  cleaned.mesh.points = soup.points;
  std::set<std::array<int, 3>> known;
  int last_quad = -1;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    auto& t = triangles[i];
    for (int& point : t) point = first[at(point)];
    const bool is_collapsed = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    if (is_collapsed || is_thin(soup.points, t, tolerance)) {
      ++cleaned.degenerate_dropped;
      continue;
    }
    std::array<int, 3> sorted = t;
    std::sort(sorted.begin(), sorted.end());
    if (!known.insert(sorted).second) {
      ++cleaned.duplicates_dropped;
      continue;
    }
    // Both halves of a quadrilateral follow each other, if both are kept.
    const int count = static_cast<int>(cleaned.mesh.triangles.size());
    if (quad_of[i] >= 0 && quad_of[i] == last_quad) cleaned.quads.push_back({count - 1, count});
    last_quad = quad_of[i];
    cleaned.mesh.triangles.push_back(t);
  }
  drop_unused_points(cleaned.mesh);
  return cleaned;
}

}  // namespace hydroscope
