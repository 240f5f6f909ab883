// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <sstream>

#include "app/commands.h"
#include "app/frame_options.h"
#include "render/tool_picture.h"
#include "solver/geometry/mesh_surface.h"
#include "solver/import/tool_report.h"

namespace hydroscope {
namespace {

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// As contact would see it: welded, with the default normals.
void draw_tool(const Arguments& arguments, double unit_scale, double crease_angle,
               const std::string& report) {
  const std::string& file = arguments.operands.front();
  const MeshSurface surface(read_tool_mesh(file, unit_scale).mesh, {NormalRule::area, crease_angle});
  ToolPictureOptions picture;
  if (arguments.has("--size")) picture.size = parse_size("--size", arguments.get("--size"));
  picture.theme = arguments.get("--theme", picture.theme);
  picture.notes = split_lines(report);
  render_tool_picture(surface.display_mesh(), surface.display_normals(), {}, file, arguments.get("--output"),
                      picture);
  std::printf("picture: %s\n", arguments.get("--output").c_str());
}

}  // namespace

ExitCode inspect_tool_mesh(const Arguments& arguments) {
  const double unit_scale = parse_number("--unit-scale", arguments.get("--unit-scale", "1"), 1e-6, 1e6);
  const double crease_angle =
      parse_number("--crease-angle", arguments.get("--crease-angle", "40"), 1.0, 180.0);
  const ToolReport report = inspect_tool_file(arguments.operands.front(), unit_scale, crease_angle);
  const std::string text = format_tool_report(report);
  std::fputs(text.c_str(), stdout);
  if (arguments.has("--output")) draw_tool(arguments, unit_scale, crease_angle, text);
  return report.errors.empty() ? ExitCode::kDone : ExitCode::kBadInput;
}

}  // namespace hydroscope
