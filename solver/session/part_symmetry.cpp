// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/part_symmetry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "solver/geometry/pose.h"

namespace hydroscope {
namespace {

constexpr double kSame = 1e-6;  // of directions, and of places against the tube's radius

Vec3 to_vec3(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

Vec3 mirror(const Vec3& v, const Vec3& normal) { return v - 2.0 * normal.dot(v) * normal; }

/// An exact tool as placed: what it is, and where it stands.
struct PlacedTool {
  const ToolScene* scene = nullptr;
  Vec3 at = Vec3::Zero();       ///< a point of it [mm]
  Vec3 axis = Vec3::UnitZ();    ///< of a plane: its normal
  Vec3 across = Vec3::UnitX();  ///< of a box: along its width
  std::vector<Vec3> moves;      ///< rows of its motion [mm]
};

bool is_exact(const ToolScene& tool) { return tool.shape != "mesh" && tool.shape != "points"; }

PlacedTool place(const ToolScene& tool) {
  PlacedTool placed;
  placed.scene = &tool;
  const Pose pose = make_pose(tool.rotation, tool.position);
  const bool is_box = tool.shape == "box";
  placed.at = pose.place_point(is_box ? Vec3::Zero() : to_vec3(tool.point));
  placed.axis = pose.place_direction(is_box ? Vec3::UnitZ() : to_vec3(tool.direction).normalized());
  placed.across = pose.place_direction(Vec3::UnitX());
  for (const auto& row : tool.motion) placed.moves.emplace_back(row[1], row[2], row[3]);
  return placed;
}

PlacedTool mirror(PlacedTool tool, const Vec3& normal) {
  tool.at = mirror(tool.at, normal);
  tool.axis = mirror(tool.axis, normal);
  tool.across = mirror(tool.across, normal);
  for (Vec3& move : tool.moves) move = mirror(move, normal);
  return tool;
}

bool is_parallel(const Vec3& a, const Vec3& b) { return a.cross(b).norm() < kSame; }

/// Same kind, sizes, friction and times of motion.
bool is_same_kind(const ToolScene& a, const ToolScene& b) {
  bool same = a.shape == b.shape && a.side == b.side && a.face == b.face && a.friction == b.friction &&
              a.radius == b.radius && a.minor_radius == b.minor_radius && a.half_width == b.half_width &&
              a.half_height == b.half_height && a.corner_radius == b.corner_radius &&
              a.leaves_at == b.leaves_at && a.flip == b.flip && a.motion.size() == b.motion.size();
  for (std::size_t i = 0; same && i < a.motion.size(); ++i) same = a.motion[i][0] == b.motion[i][0];
  return same;
}

bool stands_alike(const PlacedTool& a, const PlacedTool& b, double length) {
  const Vec3 gap = a.at - b.at;
  const std::string& shape = a.scene->shape;
  if (shape == "plane") return (a.axis - b.axis).norm() < kSame && std::abs(gap.dot(a.axis)) < kSame * length;
  if (!is_parallel(a.axis, b.axis)) return false;
  const double beside = gap.cross(a.axis).norm();
  if (shape == "torus") return gap.norm() < kSame * length;
  if (beside > kSame * length) return false;
  if (shape != "box") return true;
  const bool is_square = a.scene->half_width == a.scene->half_height;
  return is_parallel(a.across, b.across) || (is_square && std::abs(a.across.dot(b.across)) < kSame);
}

bool moves_alike(const PlacedTool& a, const PlacedTool& b, double length) {
  for (std::size_t i = 0; i < a.moves.size(); ++i) {
    if ((a.moves[i] - b.moves[i]).norm() > kSame * length) return false;
  }
  return true;
}

class Judge {
 public:
  Judge(const Scene& scene, const std::map<std::string, MeshFacts>& facts) : scene_(scene), facts_(facts) {}

  Symmetry judge_plane(const Vec3& normal) const {
    Symmetry result;
    for (const auto& [name, tool] : scene_.tools) {
      if (is_exact(tool)) {
        if (!has_image(name, tool, normal)) result.refuse("tool '" + name + "' has no mirror image there");
      } else if (!is_mesh_mirrored(name, tool, normal)) {
        result.refuse("the mesh of tool '" + name + "' has no mirror image there");
      }
    }
    return result;
  }

  Symmetry judge_around() const {
    Symmetry result;
    for (const auto& [name, tool] : scene_.tools) {
      const PlacedTool placed = place(tool);
      const bool is_round = tool.shape == "cylinder" || tool.shape == "torus";
      const bool is_level = tool.shape == "plane" && is_parallel(placed.axis, Vec3::UnitZ());
      const bool is_centred = placed.at.head<2>().norm() < kSame * scene_.tube.radius;
      if (!is_level && !(is_round && is_centred && is_parallel(placed.axis, Vec3::UnitZ())))
        result.refuse("tool '" + name + "' is not round about the axis");
      for (const Vec3& move : placed.moves) {
        if (move.head<2>().norm() > 0.0) result.refuse("tool '" + name + "' moves across the axis");
      }
    }
    return result;
  }

  Symmetry judge_along() const {
    Symmetry result;
    if (scene_.ends.axial != "held") result.refuse("the ends are " + scene_.ends.axial + " along the axis");
    if (scene_.ends.radial != "free") result.refuse("the ends are held across the axis");
    if (scene_.ends.rotation != "free") result.refuse("the ends do not turn");
    for (const auto& [name, tool] : scene_.tools) {
      if (!runs_along(name, tool)) result.refuse("tool '" + name + "' is not the same all along the tube");
      for (const auto& row : tool.motion) {
        if (row[3] != 0.0 && tool.friction > 0.0) result.refuse("tool '" + name + "' rubs along the axis");
      }
    }
    return result;
  }

 private:
  /// A tool whose force is asked for must be its own image.
  bool is_asked_for(const std::string& name) const {
    return std::any_of(scene_.quantities.begin(), scene_.quantities.end(), [&](const auto& item) {
      return item.second.kind == "contact_force" && item.second.tool == name;
    });
  }

  bool has_image(const std::string& name, const ToolScene& tool, const Vec3& normal) const {
    const bool only_itself = is_asked_for(name);
    const PlacedTool image = mirror(place(tool), normal);
    const double length = scene_.tube.radius;
    return std::any_of(scene_.tools.begin(), scene_.tools.end(), [&](const auto& item) {
      if (only_itself && item.first != name) return false;
      if (!is_exact(item.second) || !is_same_kind(tool, item.second)) return false;
      const PlacedTool other = place(item.second);
      return stands_alike(image, other, length) && moves_alike(image, other, length);
    });
  }

  bool is_mesh_mirrored(const std::string& name, const ToolScene& tool, const Vec3& normal) const {
    const auto found = facts_.find(name);
    if (found == facts_.end()) return false;
    for (const auto& row : tool.motion) {
      if (std::abs(Vec3(row[1], row[2], row[3]).dot(normal)) > 0.0) return false;
    }
    return is_mirrored(found->second.mesh, normal);
  }

  bool runs_along(const std::string& name, const ToolScene& tool) const {
    if (!is_exact(tool)) {
      const auto found = facts_.find(name);
      const double half = 0.5 * scene_.tube.length, low = scene_.tube.extent == "half" ? 0.0 : -half;
      return found != facts_.end() && found->second.is_prismatic && found->second.low_z <= low &&
             found->second.high_z >= half;
    }
    const PlacedTool placed = place(tool);
    if (tool.shape == "plane") return std::abs(placed.axis.z()) < kSame;
    return tool.shape != "torus" && is_parallel(placed.axis, Vec3::UnitZ());
  }

  const Scene& scene_;
  const std::map<std::string, MeshFacts>& facts_;
};

bool is_pressed_from_outside(const Scene& scene) {
  const auto& values = scene.load.pressure.values;
  return scene.load.control == "pressure" &&
         std::any_of(values.begin(), values.end(), [](double p) { return p < 0.0; });
}

}  // namespace

PartSymmetry find_symmetry(const Scene& scene, const std::map<std::string, MeshFacts>& facts) {
  const Judge judge(scene, facts);
  const double half = std::numbers::sqrt2 / 2.0;
  PartSymmetry found;
  found.around = judge.judge_around();
  found.plane_0 = judge.judge_plane(Vec3::UnitY());
  found.plane_45 = judge.judge_plane({-half, half, 0.0});
  found.plane_90 = judge.judge_plane(Vec3::UnitX());
  found.middle = judge.judge_plane(Vec3::UnitZ());
  found.along = judge.judge_along();
  if (is_pressed_from_outside(scene)) {  // a tube may buckle into lobes, which are no image of themselves
    for (Symmetry* one : {&found.around, &found.plane_0, &found.plane_45, &found.plane_90, &found.along})
      one->refuse("outer pressure may buckle the tube");
  }
  return found;
}

}  // namespace hydroscope
