// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "solver/geometry/pose.h"
#include "solver/geometry/tool_surface.h"
#include "solver/import/tool_mesh.h"
#include "solver/scene/scene.h"

namespace hydroscope {

/// Path of the file of a mesh or a point set. Throws InputError when none is given.
std::string find_tool_file(const ToolScene& scene, const std::string& name,
                           const std::string& scene_directory);

/// The surface over a tool's mesh, read and oriented alike, before it is flipped and placed. `name`: of the
/// tool, for messages. Throws InputError where the mesh does not allow the form that the scene asks for.
std::shared_ptr<const ToolSurface> make_mesh_surface(const ImportedMesh& imported, const ToolScene& scene,
                                                     const std::string& name);

/// The surface of one [tool.NAME], as placed at the start. `display_extent` [mm]: how far infinite
/// surfaces (plane, cylinder, box) reach in pictures. Throws InputError naming the tool's key.
std::shared_ptr<const ToolSurface> make_tool_surface(const ToolScene& scene, const std::string& name,
                                                     const std::string& scene_directory,
                                                     double display_extent);

}  // namespace hydroscope
