// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// A point set z(x, y) on a regular grid (method 1a), free space above. Points may be missing.
struct HeightField {
  int columns = 0, rows = 0;    ///< points along x and y, at least two each
  Vec2 origin = Vec2::Zero();   ///< x, y of the first point [mm]
  Vec2 pitch = Vec2::Ones();    ///< between columns and rows [mm]
  std::vector<double> heights;  ///< [mm], row by row; not a number where there is no surface

  double height(int i, int j) const { return heights[static_cast<std::size_t>(j * columns + i)]; }
  bool has_point(int i, int j) const;
  /// All four corners of the cell from (i, j) to (i + 1, j + 1) are there.
  bool has_cell(int i, int j) const;
  Vec3 point(int i, int j) const {
    return {origin.x() + i * pitch.x(), origin.y() + j * pitch.y(), height(i, j)};
  }
};

/// Steepest wall of a point set against its base [deg]: leaves a draft of five degrees.
inline constexpr double kSteepestWall = 85.0;

/// Throws InputError for a field that is no surface: fewer than two columns or rows, a number of
/// heights that does not fit, a pitch of 0, no cell, or a cell steeper than kSteepestWall (where it lies).
void check_height_field(const HeightField& field, const std::string& name);

/// Samples a mesh whose free side is above at points `pitch` [mm] apart, or a little closer, so that the grid
/// spans its box. Throws InputError for walls that are vertical or overhang, naming the place: a point
/// set cannot describe them.
HeightField sample_heights(const TriangleMesh& mesh, double pitch, const std::string& name);

}  // namespace hydroscope
