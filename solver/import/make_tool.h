// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "solver/geometry/pose.h"
#include "solver/geometry/tool_surface.h"
#include "solver/scene/scene.h"

namespace hydroscope {

/// Path of a mesh tool's file. Throws InputError when none is given.
std::string find_tool_file(const ToolScene& scene, const std::string& name,
                           const std::string& scene_directory);

/// A tool's mesh as placed: read, oriented alike, flipped on request, turned and moved.
/// `name`: of the tool, for messages; `scene_directory`: relative files start there.
TriangleMesh make_tool_mesh(const ToolScene& scene, const std::string& name,
                            const std::string& scene_directory);

/// The surface of one [tool.NAME], as placed at the start. `display_extent` [mm]: how far infinite
/// surfaces (plane, cylinder, box) reach in pictures. Throws InputError naming the tool's key.
std::shared_ptr<const ToolSurface> make_tool_surface(const ToolScene& scene, const std::string& name,
                                                     const std::string& scene_directory,
                                                     double display_extent);

}  // namespace hydroscope
