// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/tool_report.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include "solver/base/error.h"
#include "solver/geometry/height_surface.h"
#include "solver/geometry/mesh_topology.h"
#include "solver/import/make_tool.h"
#include "solver/import/sheet_check.h"

namespace hydroscope {

namespace {

// An averaged normal is wrong by up to half the facet angle at tangent lines (mechanics 6.1).
constexpr double kCoarseAngle = 10.0;  // [deg]

template <class... Numbers>
std::string format(const char* text, Numbers... numbers) {
  char line[512];
  std::snprintf(line, sizeof line, text, numbers...);
  return line;
}

void judge_mesh(ToolReport& report) {
  const MeshStatistics& mesh = report.mesh;
  const char* name = report.name.c_str();
  const auto warn = [&](const std::string& what) {
    report.warnings.push_back("tool." + report.name + ": " + what);
  };
  if (mesh.flipped_edges > 0) {
    report.errors.push_back(
        format("tool.%s: %d edges keep facets that face opposite ways: a one-sided surface "
               "(Moebius strip) has no free side",
               name, mesh.flipped_edges));
  }
  if (report.flipped_repaired > 0)
    warn(format("%d facets turned to face as their neighbours", report.flipped_repaired));
  if (report.import.degenerate_dropped > 0) {
    warn(format("%d facets without area dropped", report.import.degenerate_dropped));
  }
  if (mesh.non_manifold_edges > 0) {
    warn(format("%d edges have three facets or more: nodes do not slide over them smoothly",
                mesh.non_manifold_edges));
  }
  if (mesh.t_joints > 0) {
    warn(format("%d T-joints or unwelded seams: normals jump there", mesh.t_joints));
  }
  if (mesh.slivers > 0) {
    warn(format("%d slivers, the worst %.0f times as long as high: their normals are weak", mesh.slivers,
                mesh.worst_aspect));
  }
  if (mesh.creases > 0) {
    warn(
        format("%d creases sharper than %g deg, the sharpest %.1f deg: normals are not averaged over them; "
               "a fillet forms better",
               mesh.creases, report.crease_angle, mesh.sharpest_crease));
  }
  if (mesh.largest_facet_angle > kCoarseAngle) {
    warn(format("facets turn by up to %.1f deg: fillets want 7 deg or less", mesh.largest_facet_angle));
  }
  int holes = 0;
  for (double length : mesh.rim_lengths) holes += length < 0.2 * mesh.rim_lengths.front() ? 1 : 0;
  if (holes > 0) warn(format("%d holes", holes));
}

void judge_element_size(const SheetSample& sheet, ToolReport& report) {
  const MeshStatistics& mesh = report.mesh;
  if (!(sheet.element_size > 0.0) || !(mesh.smallest_radius > 0.0)) return;
  if (mesh.smallest_radius < sheet.element_size) {
    report.warnings.push_back(
        format("tool.%s: a fillet of radius %.3g mm is smaller than the sheet's elements "
               "(%.3g mm): nodes cannot follow it",
               report.name.c_str(), mesh.smallest_radius, sheet.element_size));
  }
  const double facet = mesh.smallest_radius * mesh.largest_facet_angle * 0.0174533;
  if (facet > 2.0 * sheet.element_size) {
    report.warnings.push_back(
        format("tool.%s: facets on fillets (%.3g mm) are longer than two elements of the "
               "sheet (%.3g mm): it takes on their shape",
               report.name.c_str(), facet, sheet.element_size));
  }
}

/// Reads and repairs; the report keeps the counts.
ImportedMesh inspect_file(const std::string& file, double unit_scale, ToolReport& report) {
  ImportedMesh imported = read_tool_mesh(file, unit_scale);
  report.flipped_repaired = orient_consistently(imported.mesh);
  report.has_mesh = true;
  report.import = imported;
  report.import.mesh = {};
  return imported;
}

void warn_of_sharp_edges(const ToolSurface& tool, ToolReport& report) {
  const auto* heights = dynamic_cast<const HeightSurface*>(&tool);
  if (heights == nullptr || heights->sharp_edges() == 0) return;
  report.warnings.push_back(
      format("tool.%s: %d lines of the point set bend by more than %g deg: it rounds them over one pitch",
             report.name.c_str(), heights->sharp_edges(), report.crease_angle));
}

ToolReport start_report(const ToolScene& scene, const std::string& name, const SheetSample& sheet) {
  ToolReport report;
  report.name = name;
  report.crease_angle = scene.crease_angle;
  report.sheet.element_size = sheet.element_size;
  report.sheet.thickness = sheet.thickness;
  return report;
}

void check_start(const ToolSurface& tool, const ToolScene& scene, const SheetSample& sheet,
                 ToolReport& report) {
  const bool has_unit = scene.shape == "mesh" || scene.shape == "points";
  if (has_unit && !check_units(tool.display_mesh(), sheet, report)) return;
  check_sheet_side(tool, sheet, report);
}

void format_mesh(const ToolReport& report, std::string& text) {
  const MeshStatistics& m = report.mesh;
  const ImportedMesh& i = report.import;
  text += format("  mesh          %d facets, %d points, %d part%s\n", m.facets, m.points, m.parts,
                 m.parts == 1 ? "" : "s");
  text += format(
      "  reading       %d points read, %d welded, %d quads split, %d facets without area and %d doubles "
      "dropped\n",
      i.points_read, i.points_welded, i.quads_split, i.degenerate_dropped, i.duplicates_dropped);
  text += format("  box           x %.3f .. %.3f, y %.3f .. %.3f, z %.3f .. %.3f mm\n", m.low.x(), m.high.x(),
                 m.low.y(), m.high.y(), m.low.z(), m.high.z());
  text += format("  area          %.6g mm2\n", m.area);
  text += format("  edges         %d open (%zu rims), %d of three facets or more, %d T-joints\n",
                 m.open_edges, m.rim_lengths.size(), m.non_manifold_edges, m.t_joints);
  text += format("  orientation   %d facets turned, %d edges left flipped\n", report.flipped_repaired,
                 m.flipped_edges);
  text += format("  facet size    edges %.3g .. %.3g mm, mean %.3g mm; %d slivers, worst aspect %.1f\n",
                 m.smallest_edge, m.largest_edge, m.mean_edge, m.slivers, m.worst_aspect);
  text += format("  facet angle   largest %.2f deg, mean %.2f deg of bent edges; %d creases above %g deg%s\n",
                 m.largest_facet_angle, m.mean_facet_angle, m.creases, report.crease_angle,
                 m.creases > 0 ? format(", sharpest %.1f deg", m.sharpest_crease).c_str() : "");
  if (m.smallest_radius > 0.0) text += format("  radius        smallest about %.3g mm\n", m.smallest_radius);
}

}  // namespace

ToolReport inspect_tool_file(const std::string& file, double unit_scale, double crease_angle) {
  ToolReport report;
  report.name = std::filesystem::path(file).stem().string();
  report.crease_angle = crease_angle;
  report.mesh = measure_mesh(inspect_file(file, unit_scale, report).mesh, crease_angle);
  judge_mesh(report);
  return report;
}

ToolReport inspect_start(const ToolSurface& tool, const ToolScene& scene, const std::string& name,
                         const SheetSample& sheet) {
  ToolReport report = start_report(scene, name, sheet);
  check_start(tool, scene, sheet, report);
  return report;
}

ToolReport inspect_tool(const ToolScene& scene, const std::string& name, const std::string& scene_directory,
                        const SheetSample& sheet) {
  ToolReport report = start_report(scene, name, sheet);
  if (scene.shape != "mesh") {
    const auto tool = make_tool_surface(scene, name, scene_directory, 1.0);
    warn_of_sharp_edges(*tool, report);
    check_start(*tool, scene, sheet, report);
    return report;
  }
  const ImportedMesh imported =
      inspect_file(find_tool_file(scene, name, scene_directory), scene.unit_scale, report);
  TriangleMesh mesh = imported.mesh;
  if (scene.flip) flip_mesh(mesh);
  place_mesh(make_pose(scene.rotation, scene.position), mesh);
  report.mesh = measure_mesh(mesh, scene.crease_angle);
  judge_mesh(report);
  judge_element_size(sheet, report);
  if (!report.errors.empty() || sheet.points.empty()) return report;
  check_start(*make_mesh_surface(imported, scene, name), scene, sheet, report);
  return report;
}

std::string format_tool_report(const ToolReport& report) {
  std::string text = "tool " + report.name + "\n";
  if (report.has_mesh) format_mesh(report, text);
  if (report.place.points > 0) {
    text += format(
        "  sheet         %d points face the tool, %.1f %% on its free side; smallest gap %.4g mm, "
        "largest penetration %.4g mm\n",
        report.place.points, 100.0 * report.place.free_fraction, report.place.smallest_gap,
        report.place.largest_penetration);
  }
  for (const std::string& warning : report.warnings) text += "  warning: " + warning + "\n";
  for (const std::string& error : report.errors) text += "  error: " + error + "\n";
  if (report.errors.empty()) text += report.warnings.empty() ? "  healthy\n" : "  usable\n";
  return text;
}

}  // namespace hydroscope
