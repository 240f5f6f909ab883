// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/make_tool.h"

#include <algorithm>
#include <filesystem>

#include "solver/base/error.h"
#include "solver/geometry/analytic_surface.h"
#include "solver/geometry/height_surface.h"
#include "solver/geometry/mesh_surface.h"
#include "solver/geometry/nagata_surface.h"
#include "solver/import/grid_file.h"
#include "solver/import/tool_mesh.h"

namespace hydroscope {

namespace {

Vec3 to_vec3(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

void check(bool holds, const std::string& name, const std::string& what) {
  if (!holds) throw InputError("tool." + name + ": " + what);
}

/// Where a plane, cylinder or torus stands: its own point and direction, then the tool's pose.
Pose make_axis_pose(const ToolScene& scene, const std::string& name) {
  const Vec3 direction = to_vec3(scene.direction);
  check(direction.allFinite() && direction.norm() > 0.0, name,
        "direction must not be zero, for example [0, 0, 1]");
  const Pose pose = make_pose(scene.rotation, scene.position);
  Pose placed;
  placed.rotation = pose.rotation * make_frame(direction);
  placed.position = pose.place_point(to_vec3(scene.point));
  return placed;
}

Side read_side(const ToolScene& scene, const std::string& name) {
  check(scene.side == "inside" || scene.side == "outside", name,
        "side = \"" + scene.side + "\": expected inside or outside");
  return (scene.side == "outside") != scene.flip ? Side::outside : Side::inside;
}

Pose make_plane_pose(const ToolScene& scene, const std::string& name) {
  ToolScene turned = scene;
  if (scene.flip) {
    for (double& component : turned.direction) component = -component;
  }
  return make_axis_pose(turned, name);
}

std::shared_ptr<const ToolSurface> make_box(const ToolScene& scene, const std::string& name, double extent) {
  check(scene.half_width > 0.0 && scene.half_height > 0.0, name,
        "a box needs half_width_mm > 0 and half_height_mm > 0");
  check(scene.corner_radius >= 0.0 && scene.corner_radius <= std::min(scene.half_width, scene.half_height),
        name, "corner_radius_mm must lie between 0 and the smaller of half_width_mm and half_height_mm");
  const RoundedBoxSurface::Section section{scene.half_width, scene.half_height, scene.corner_radius};
  return std::make_shared<RoundedBoxSurface>(make_pose(scene.rotation, scene.position), section,
                                             read_side(scene, name), extent);
}

/// Heights of a placed mesh's own frame along the scene's axis, from the tool to free space.
std::shared_ptr<const ToolSurface> sample_points(TriangleMesh mesh, const ToolScene& scene,
                                                 const std::string& name) {
  const Vec3 axis = to_vec3(scene.height_axis);
  check(axis.allFinite() && axis.norm() > 0.0, name, "height_axis must not be zero, for example [0, 0, 1]");
  check(scene.pitch > 0.0, name, "surface = \"points\" needs pitch_mm > 0");
  const Mat3 frame = make_frame(axis);
  for (Vec3& point : mesh.points) point = frame.transpose() * point;
  Pose pose = make_pose(scene.rotation, scene.position);
  pose.rotation = pose.rotation * frame;
  return std::make_shared<HeightSurface>(sample_heights(mesh, scene.pitch, "tool." + name), pose,
                                         parse_normal_rule(scene.normals), scene.crease_angle);
}

/// The same surface with free space below: turned about x by half a turn.
void flip_heights(HeightField& field, Pose& pose) {
  std::reverse(field.heights.begin(), field.heights.end());  // rows and columns; then each row back
  for (int j = 0; j < field.rows; ++j) {
    const auto row = field.heights.begin() + static_cast<std::ptrdiff_t>(j) * field.columns;
    std::reverse(row, row + field.columns);
  }
  for (double& height : field.heights) height = -height;
  field.origin.y() = -(field.origin.y() + (field.rows - 1) * field.pitch.y());
  pose.rotation = pose.rotation * make_pose({180, 0, 0}, {0, 0, 0}).rotation;
}

std::shared_ptr<const ToolSurface> read_points(const ToolScene& scene, const std::string& name,
                                               const std::string& scene_directory) {
  HeightField field = read_grid_file(find_tool_file(scene, name, scene_directory), scene.unit_scale);
  Pose pose = make_pose(scene.rotation, scene.position);
  if (scene.flip) flip_heights(field, pose);
  return std::make_shared<HeightSurface>(std::move(field), pose, parse_normal_rule(scene.normals),
                                         scene.crease_angle);
}

}  // namespace

std::string find_tool_file(const ToolScene& scene, const std::string& name,
                           const std::string& scene_directory) {
  check(!scene.file.empty(), name, "a mesh needs a file (STL, OBJ or PLY), and so does a point set");
  const std::filesystem::path file(scene.file);
  if (file.is_absolute() || scene_directory.empty()) return file.string();
  return (std::filesystem::path(scene_directory) / file).string();
}

std::shared_ptr<const ToolSurface> make_mesh_surface(const ImportedMesh& imported, const ToolScene& scene,
                                                     const std::string& name) {
  TriangleMesh mesh = imported.mesh;
  if (scene.flip) flip_mesh(mesh);
  if (scene.surface == "points") return sample_points(mesh, scene, name);
  place_mesh(make_pose(scene.rotation, scene.position), mesh);
  const NormalRule normals = parse_normal_rule(scene.normals);
  const SearchRule search = parse_search_rule(scene.search);
  if (scene.surface == "nagata") {
    check(normals != NormalRule::facet, name, "surface = \"nagata\" needs averaged normals");
    return std::make_shared<NagataSurface>(mesh, NagataSurfaceOptions{normals, scene.crease_angle, search});
  }
  MeshSurfaceOptions options;
  options.normals = normals;
  options.crease_angle = scene.crease_angle;
  options.search = search;
  options.is_smooth = scene.surface == "smooth";
  options.projection = parse_projection(scene.projection);
  if (scene.surface == "quads") {
    check(!imported.quads.empty(), name,
          "surface = \"quads\": the file has no quadrilaterals (STL has none; OBJ and PLY may)");
    options.quads = imported.quads;
  }
  return std::make_shared<MeshSurface>(mesh, options);
}

std::shared_ptr<const ToolSurface> make_tool_surface(const ToolScene& scene, const std::string& name,
                                                     const std::string& scene_directory,
                                                     double display_extent) {
  if (scene.shape == "mesh") {
    ImportedMesh imported = read_tool_mesh(find_tool_file(scene, name, scene_directory), scene.unit_scale);
    orient_consistently(imported.mesh);
    return make_mesh_surface(imported, scene, name);
  }
  if (scene.shape == "points") return read_points(scene, name, scene_directory);
  if (scene.shape == "plane") {
    return std::make_shared<PlaneSurface>(make_plane_pose(scene, name), display_extent);
  }
  if (scene.shape == "cylinder") {
    check(scene.radius > 0.0, name, "a cylinder needs radius_mm > 0");
    return std::make_shared<CylinderSurface>(make_axis_pose(scene, name), scene.radius,
                                             read_side(scene, name), display_extent);
  }
  if (scene.shape == "box") return make_box(scene, name, display_extent);
  if (scene.shape == "torus") {
    check(scene.minor_radius > 0.0 && scene.radius > scene.minor_radius, name,
          "a torus needs 0 < minor_radius_mm < radius_mm");
    return std::make_shared<TorusSurface>(make_axis_pose(scene, name), scene.radius, scene.minor_radius,
                                          read_side(scene, name));
  }
  throw InputError("tool." + name + ": shape = \"" + scene.shape +
                   "\": expected mesh, points, plane, cylinder, box or torus");
}

}  // namespace hydroscope
