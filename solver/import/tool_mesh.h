// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// Reads STL (text or binary), OBJ or PLY through assimp; quads are split,
/// points welded, degenerate triangles dropped (counted in the report).
/// Throws InputError naming the file and what is wrong (missing, truncated,
/// no mesh, NaN coordinates, no triangles, ...).
struct ImportedMesh {
  TriangleMesh mesh;  ///< [mm], after `unit_scale`
  int points_read = 0, points_welded = 0, degenerate_dropped = 0, quads_split = 0;
  int duplicates_dropped = 0;             ///< triangles given twice
  std::vector<std::array<int, 2>> quads;  ///< triangles that are the halves of one quadrilateral of the file
};
ImportedMesh read_tool_mesh(const std::string& file, double unit_scale);

}  // namespace hydroscope
