// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

struct ToolPictureOptions {
  std::array<int, 2> size{1280, 720};       ///< [px]
  std::string theme = "light";              ///< light | dark
  double azimuth = 35.0, elevation = 25.0;  ///< [deg] as FrameOptions
  std::vector<std::string> notes{};         ///< lines of the health report, beside the picture
};

/// Picture of a tool for its health report: facets coloured by the angle against
/// the continuous normals, these normals (one a point) as arrows, highlighted
/// facets (indices) in vermillion, open and sharp edges as lines.
/// Throws EnvironmentError; ContractError for an index out of range.
void render_tool_picture(const TriangleMesh& mesh, const std::vector<Vec3>& normals,
                         const std::vector<int>& highlighted_facets, const std::string& title,
                         const std::string& file, const ToolPictureOptions& options = {});

}  // namespace hydroscope
