// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/make_tool.h"

#include <algorithm>
#include <filesystem>

#include "solver/base/error.h"
#include "solver/geometry/analytic_surface.h"
#include "solver/geometry/mesh_surface.h"
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

}  // namespace

std::string find_tool_file(const ToolScene& scene, const std::string& name,
                           const std::string& scene_directory) {
  check(!scene.file.empty(), name, "a mesh needs a file (STL, OBJ or PLY)");
  const std::filesystem::path file(scene.file);
  if (file.is_absolute() || scene_directory.empty()) return file.string();
  return (std::filesystem::path(scene_directory) / file).string();
}

TriangleMesh make_tool_mesh(const ToolScene& scene, const std::string& name,
                            const std::string& scene_directory) {
  TriangleMesh mesh = read_tool_mesh(find_tool_file(scene, name, scene_directory), scene.unit_scale).mesh;
  orient_consistently(mesh);
  if (scene.flip) flip_mesh(mesh);
  place_mesh(make_pose(scene.rotation, scene.position), mesh);
  return mesh;
}

std::shared_ptr<const ToolSurface> make_tool_surface(const ToolScene& scene, const std::string& name,
                                                     const std::string& scene_directory,
                                                     double display_extent) {
  if (scene.shape == "mesh") {
    const MeshSurfaceOptions options{parse_normal_rule(scene.normals), scene.crease_angle,
                                     scene.surface == "smooth"};
    return std::make_shared<MeshSurface>(make_tool_mesh(scene, name, scene_directory), options);
  }
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
                   "\": expected mesh, plane, cylinder, box or torus");
}

}  // namespace hydroscope
