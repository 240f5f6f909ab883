// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/geometry/tool_surface.h"
#include "solver/import/mesh_statistics.h"
#include "solver/import/tool_mesh.h"
#include "solver/scene/scene.h"

namespace hydroscope {

/// What is known of the sheet that meets the tool. All of it may be left out.
struct SheetSample {
  std::vector<Vec3> points;   ///< contact points of the face that meets the tool, at the start [mm]
  double element_size = 0.0;  ///< of the sheet, typical [mm]; 0 = unknown
  double thickness = 0.0;     ///< [mm]; 0 = unknown
};

/// How the sheet begins against a tool.
struct SheetPlace {
  int points = 0;                     ///< sample points that face the tool
  double free_fraction = 1.0;         ///< of them, on the free side
  double largest_penetration = 0.0;   ///< [mm], of the points of a tool whose sheet is on the right side
  Vec3 deepest_point = Vec3::Zero();  ///< where [mm]
  double smallest_gap = 0.0;          ///< [mm]
};

/// Health of a tool before the run.
struct ToolReport {
  std::string name;
  ImportedMesh import;         ///< counts of the reading (its mesh is left empty)
  MeshStatistics mesh;         ///< of a mesh tool, as placed
  int flipped_repaired = 0;    ///< facets turned so that neighbours agree
  double crease_angle = 40.0;  ///< [deg]: the limit for creases
  bool has_mesh = false;
  SheetSample sheet;  ///< as given, without its points
  SheetPlace place;
  std::vector<std::string> errors;    ///< reasons not to run: bad input
  std::vector<std::string> warnings;  ///< what may spoil the result
};

/// Report on a mesh file alone, for `hydroscope tool FILE`. Throws InputError when it cannot be read.
ToolReport inspect_tool_file(const std::string& file, double unit_scale, double crease_angle = 40.0);

/// Report on one [tool.NAME] as placed, of any shape, against the sheet.
ToolReport inspect_tool(const ToolScene& scene, const std::string& name, const std::string& scene_directory,
                        const SheetSample& sheet);

/// How the sheet begins against a tool that has been made already: its size, side and depth inside. Errors
/// name the tool's key.
ToolReport inspect_start(const ToolSurface& tool, const ToolScene& scene, const std::string& name,
                         const SheetSample& sheet);

/// The report as lines of text for a terminal, errors and warnings last.
std::string format_tool_report(const ToolReport& report);

}  // namespace hydroscope
