// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// Points and polygons as a file gives them.
struct PolygonSoup {
  std::vector<Vec3> points;  // [mm]
  std::vector<std::vector<int>> polygons;
};

/// Distance within which points of `points` are one [mm]: relative to their extent and to
/// how finely single precision tells them apart.
double calc_weld_tolerance(const std::vector<Vec3>& points);

/// The lowest point within `tolerance` for each point.
std::vector<int> weld_points(const std::vector<Vec3>& points, double tolerance);

/// Splits polygons into triangles: a quadrilateral at its shorter diagonal, larger ones as a fan.
/// Returns the number of polygons split. `quad_of`: number of the quadrilateral that a triangle is half of,
/// or -1.
int split_polygons(const PolygonSoup& soup, std::vector<std::array<int, 3>>& triangles,
                   std::vector<int>& quad_of);

struct CleanedMesh {
  TriangleMesh mesh;
  std::vector<std::array<int, 2>> quads;  // pairs of triangles that are halves of one quadrilateral
  int points_welded = 0;                  // points that fell on an earlier one
  int degenerate_dropped = 0;             // triangles thinner than the tolerance
  int duplicates_dropped = 0;             // triangles of the same three points as an earlier one
  int polygons_split = 0;
};

/// Welds, splits, drops triangles without area and duplicates, and points of no triangle.
CleanedMesh clean_mesh(const PolygonSoup& soup);

}  // namespace hydroscope
