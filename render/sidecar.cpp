// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sidecar.h"

#include <algorithm>
#include <cmath>

#include "render/contact_life.h"
#include "render/force_balance.h"
#include "render/image/canvas.h"
#include "render/json_text.h"
#include "render/shape/tool_shape.h"
#include "render/view_range.h"
#include "render/view_text.h"

namespace hydroscope {
namespace {

std::vector<double> triple(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

JsonText make_counts(const Snapshot& snapshot) {
  const ClassCounts classes = count_classes(snapshot);
  JsonText counts;
  counts.add("free", classes.nodes[0]);
  counts.add("stick", classes.nodes[1]);
  counts.add("slip", classes.nodes[2]);
  counts.add("detached_now", classes.nodes[3]);
  return counts;
}

/// What the views of detachment show, in counts.
JsonText make_contact_life(const Snapshot& snapshot, double since) {
  const ContactLife life = calc_contact_life(snapshot, since);
  const auto count = [&](LifeClass c) { return life.counts[static_cast<std::size_t>(c)]; };
  JsonText json;
  json.add("is_known", life.is_known);
  json.add("let_go_in_frame", count(LifeClass::kLetGoNow));
  json.add("let_go_before", count(LifeClass::kLetGo));
  json.add("touching", count(LifeClass::kTouching));
  json.add("has_not_touched", count(LifeClass::kNeverTouching));
  json.add("near_release", life.near_release);
  const bool has_nearest = !life.nearest.empty();
  const int nearest = has_nearest ? life.nearest.front() : -1;
  json.add("nearest_node", nearest);
  json.add("least_margin", has_nearest ? life.margin[static_cast<std::size_t>(nearest)]
                                       : std::numeric_limits<double>::quiet_NaN());
  json.add("toggles", static_cast<double>(life.toggles));
  json.add("nodes_by_toggles", std::vector<double>(life.toggle_counts.begin(), life.toggle_counts.end()));
  double age = 0.0, margin = 0.0, toggles = 0.0;
  for (std::size_t i = 0; i < snapshot.points.size(); ++i) {
    age += std::isnan(life.age[i]) ? 0.0 : life.age[i];
    margin += std::isnan(life.margin[i]) ? 0.0 : life.margin[i];
    if (life.is_known)
      toggles += static_cast<double>((i + 1) * static_cast<std::size_t>(snapshot.toggles[i]));
  }
  json.add("sum_of_age_s", age);
  json.add("sum_of_margin", margin);
  json.add("weighted_toggles", toggles);
  return json;
}

JsonText make_camera(const CameraPose& camera) {
  JsonText json;
  json.add("position_mm", triple(camera.position));
  json.add("focal_mm", triple(camera.focal));
  json.add("up", triple(camera.up));
  json.add("scale_mm", camera.scale);
  return json;
}

/// Sums over the nodes: any node that changes shows in them.
JsonText make_sums(const Snapshot& s) {
  const auto sum_of = [](const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += std::isfinite(value) ? value : 0.0;
    return sum;
  };
  const auto lengths_of = [](const std::vector<Vec3>& vectors) {
    double sum = 0.0;
    for (const Vec3& v : vectors) sum += v.norm();
    return sum;
  };
  // Each node with a weight of its own, so that two that change places show as well.
  Vec3 position = Vec3::Zero(), slip = Vec3::Zero();
  double state = 0.0;
  for (std::size_t node = 0; node < s.points.size(); ++node) {
    const double weight = 1.0 + static_cast<double>(node) / static_cast<double>(s.points.size());
    position += weight * s.points[node];
    slip += weight * s.slip[node];
    state += static_cast<double>((node + 1) * static_cast<std::size_t>(s.contact_state[node]));
  }
  JsonText sums;
  sums.add("weighted_position_mm", triple(position));
  sums.add("weighted_slip_mm", triple(slip));
  sums.add("weighted_class", state);
  sums.add("thickness_mm", sum_of(s.thickness));
  sums.add("plastic_strain", sum_of(s.plastic_strain));
  sums.add("gap_mm", sum_of(s.gap));
  sums.add("contact_pressure_MPa", sum_of(s.contact_pressure));
  sums.add("slip_mm", lengths_of(s.slip));
  sums.add("slip_increment_mm", lengths_of(s.slip_increment));
  return sums;
}

JsonText make_tool(const SnapshotModel::Tool& tool, const Snapshot& snapshot, std::size_t index) {
  Vec3 normals = Vec3::Zero();
  for (std::size_t i = 0; i < tool.normals.size(); ++i)
    normals += (1.0 + static_cast<double>(i) / static_cast<double>(tool.normals.size())) * tool.normals[i];
  double area = 0.0, largest_angle = 0.0;
  for (const auto& facet : tool.mesh.triangles) {
    const auto x = [&](std::size_t k) -> const Vec3& {
      return tool.mesh.points[static_cast<std::size_t>(facet[k])];
    };
    const Vec3 twice_area = (x(1) - x(0)).cross(x(2) - x(0));
    area += 0.5 * twice_area.norm();
    for (const int point : facet)
      largest_angle =
          std::max(largest_angle, calc_angle(twice_area, tool.normals[static_cast<std::size_t>(point)]));
  }
  const Vec3& translation = snapshot.tool_translation[index];
  JsonText json;
  json.add("present", translation.allFinite());
  json.add("facets", static_cast<int>(tool.mesh.triangles.size()));
  json.add("points", static_cast<int>(tool.mesh.points.size()));
  json.add("area_mm2", area);
  json.add("largest_normal_angle_deg", largest_angle);
  json.add("weighted_normals", triple(normals));
  json.add("translation_mm", triple(translation));
  if (index < snapshot.tool_force.size()) json.add("force_N", triple(snapshot.tool_force[index]));
  return json;
}

JsonText make_balance(const ForceBalance& balance) {
  JsonText json;
  json.add("pressure_N", triple(balance.pressure));
  json.add("contact_N", triple(balance.contact));
  if (balance.is_support_known) json.add("support_N", triple(balance.support));
  json.add("scale_N", balance.scale);
  json.add("rest_N", triple(balance.rest));
  json.add("rest_share", balance.rest_share());
  json.add("contact_error_share", balance.contact_error_share());
  json.add("contradicting_nodes", balance.contradicting_nodes);
  return json;
}

JsonText make_mirrors(const SnapshotModel& model, bool is_mirrored) {
  JsonText mirrors;
  if (!is_mirrored) return mirrors;
  for (std::size_t i = 0; i < model.mirrors.size(); ++i) {
    JsonText plane;
    plane.add("point_mm", triple(model.mirrors[i].point));
    plane.add("normal", triple(model.mirrors[i].normal));
    mirrors.add("plane_" + std::to_string(i + 1), plane);
  }
  return mirrors;
}

std::vector<double> flatten(const std::vector<PixelBox>& boxes) {
  std::vector<double> numbers;
  for (const PixelBox& box : boxes)
    for (int number : {box.left, box.top, box.width, box.height}) numbers.push_back(number);
  return numbers;
}

}  // namespace

std::string make_sidecar(const SidecarContext& context, const Snapshot& snapshot, const FrameOptions& options,
                         const RendererInfo& renderer) {
  JsonText json, ranges, quantities, tools;
  for (const std::string& name : range_names(context.view))
    ranges.add(name, std::vector<double>{context.ranges.at(name).low, context.ranges.at(name).high});
  for (const auto& [name, value] : snapshot.quantities) quantities.add(name, value);
  for (std::size_t i = 0; i < snapshot.model->tools.size(); ++i)
    tools.add(snapshot.model->tools[i].name, make_tool(snapshot.model->tools[i], snapshot, i));
  json.add("view", context.view);
  json.add("title", snapshot.model->title);
  json.add("frame", context.number.index + 1);
  json.add("increment", snapshot.increment);
  json.add("time_s", snapshot.time);
  json.add("pressure_MPa", snapshot.pressure);
  json.add("feed_mm", snapshot.feed);
  json.add("label", make_time_label(snapshot));
  json.add("nodes", static_cast<int>(snapshot.points.size()));
  json.add("quads", static_cast<int>(snapshot.model->quads.size()));
  json.add("counts", make_counts(snapshot));
  if (range_names(context.view).size() == 1)
    json.add("nodes_without_value", count_without_value(context.view, snapshot));
  if (is_view_of_detachment(context.view)) json.add("detachment", make_contact_life(snapshot, context.since));
  json.add("range", ranges);
  json.add("sums", make_sums(snapshot));
  json.add("tools", tools);
  json.add("balance", make_balance(calc_force_balance(snapshot)));
  json.add("quantities", quantities);
  json.add("camera", make_camera(context.camera));
  const bool is_mirrored = options.is_mirrored && !snapshot.model->mirrors.empty();
  json.add("mirrored", is_mirrored);
  json.add("mirrors", make_mirrors(*snapshot.model, is_mirrored));
  json.add("size_px", std::vector<double>{1.0 * options.size[0], 1.0 * options.size[1]});
  json.add("theme", options.theme);
  json.add("lettering_px", flatten(context.lettering));
  json.add("font", lettering_font());
  json.add("renderer", renderer.renderer);
  json.add("opengl", renderer.version);
  json.add("hydroscope", HYDROSCOPE_VERSION);
  return json.text();
}

}  // namespace hydroscope
