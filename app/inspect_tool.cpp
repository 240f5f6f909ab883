// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdio>

#include "app/commands.h"
#include "app/frame_options.h"
#include "render/tool_picture.h"
#include "solver/geometry/mesh_surface.h"
#include "solver/import/tool_mesh.h"

namespace hydroscope {
namespace {

template <class... Values>
std::string print(const char* format, Values... values) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::vector<std::string> describe(const ImportedMesh& imported, const MeshSurface& surface) {
  const TriangleMesh& mesh = imported.mesh;
  Vec3 low = mesh.points.front(), high = low;
  for (const Vec3& x : mesh.points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const MeshTopology& topology = surface.topology();
  const Vec3 size = high - low;
  return {
      print("%zu points, %zu triangles", mesh.points.size(), mesh.triangles.size()),
      print("size %.6g x %.6g x %.6g mm", size.x(), size.y(), size.z()),
      print("%d points welded, %d quadrilaterals split", imported.points_welded, imported.quads_split),
      print("%d degenerate and %d repeated triangles dropped", imported.degenerate_dropped,
            imported.duplicates_dropped),
      print("%d open edges, %d shared by more than two facets", topology.open_edges,
            topology.non_manifold_edges),
      print("%d edges between facets that face opposite ways", topology.flipped_edges),
      print("%d edges sharper than the crease angle", surface.crease_edges()),
  };
}

}  // namespace

ExitCode inspect_tool(const Arguments& arguments) {
  const std::string& file = arguments.operands.front();
  const double scale = parse_number("--unit-scale", arguments.get("--unit-scale", "1"), 1e-6, 1e6);
  MeshSurfaceOptions options;
  options.crease_angle = parse_number("--crease-angle", arguments.get("--crease-angle", "40"), 1.0, 180.0);
  const ImportedMesh imported = read_tool_mesh(file, scale);
  const MeshSurface surface(imported.mesh, options);
  const std::vector<std::string> lines = describe(imported, surface);
  std::printf("%s\n", file.c_str());
  for (const std::string& line : lines) std::printf("  %s\n", line.c_str());
  if (arguments.has("--output")) {
    ToolPictureOptions picture;
    if (arguments.has("--size")) picture.size = parse_size("--size", arguments.get("--size"));
    picture.theme = arguments.get("--theme", picture.theme);
    picture.notes = lines;
    render_tool_picture(surface.display_mesh(), surface.display_normals(), {}, file,
                        arguments.get("--output"), picture);
    std::printf("picture: %s\n", arguments.get("--output").c_str());
  }
  return ExitCode::kDone;
}

}  // namespace hydroscope
