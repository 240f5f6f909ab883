// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame_painter.h"

#include <algorithm>
#include <cmath>

#include "render/camera.h"
#include "render/image/canvas.h"
#include "render/json_text.h"
#include "render/overlay.h"
#include "render/view_text.h"

namespace hydroscope {
namespace {

int find_slot(const std::string& view) {
  const auto& names = view_names();
  return static_cast<int>(std::find(names.begin(), names.end(), view) - names.begin());
}

}  // namespace

FramePainter::FramePainter(const FrameOptions& options)
    : options_(options),
      stage_({.width = options.size[0],
              .height = options.size[1],
              .smoothing = options.is_flat ? 1 : options.smoothing,
              .is_flat = options.is_flat,
              .rasteriser_threads = options.rasteriser_threads}) {}

Frame FramePainter::paint(const std::string& view, const Snapshot& snapshot, FrameNumber number,
                          const std::map<std::string, Range>& ranges) {
  if (views_ == nullptr) {
    check_camera(options_, static_cast<int>(snapshot.points.size()));
    views_ = std::make_unique<Views>(snapshot, options_);
  }
  std::optional<Vec3> look_at;
  if (options_.camera == "look-at")
    look_at = snapshot.points.at(static_cast<std::size_t>(options_.look_at_node));
  const CameraPose camera = calc_camera(options_, views_->bounds(), look_at, number.index, number.expected);
  const DrawList list = views_->make_draw_list(view, snapshot, camera, ranges);
  const Theme& colours = theme(options_.theme);
  Frame frame;
  frame.image = stage_.draw(list, camera, colours, find_slot(view));
  const std::string label = make_time_label(snapshot);
  if (!options_.is_flat)
    draw_overlay(frame.image, list.legend, snapshot.model->title, label, camera, colours);
  frame.texts = {{"Renderer", info().renderer + ", OpenGL " + info().version},
                 {"Software", "Hydroscope " HYDROSCOPE_VERSION},
                 {"Title", snapshot.model->title},
                 {"Comment", label}};
  frame.sidecar = make_sidecar(view, snapshot, number, camera, ranges, options_, info());
  return frame;
}

Vec3 calc_contact_force_sum(const Snapshot& snapshot) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& force : snapshot.contact_force) sum += force;
  return sum;
}

std::string make_sidecar(const std::string& view, const Snapshot& snapshot, FrameNumber number,
                         const CameraPose& camera, const std::map<std::string, Range>& ranges,
                         const FrameOptions& options, const RendererInfo& renderer) {
  const auto triple = [](const Vec3& v) { return std::vector<double>{v.x(), v.y(), v.z()}; };
  JsonText counts, range_text, camera_text, quantities, json;
  const ClassCounts classes = count_classes(snapshot);
  counts.add("free", classes.nodes[0]);
  counts.add("stick", classes.nodes[1]);
  counts.add("slip", classes.nodes[2]);
  counts.add("detached_now", classes.nodes[3]);
  for (const std::string& name : range_names(view))
    range_text.add(name, std::vector<double>{ranges.at(name).low, ranges.at(name).high});
  camera_text.add("position_mm", triple(camera.position));
  camera_text.add("focal_mm", triple(camera.focal));
  camera_text.add("up", triple(camera.up));
  camera_text.add("scale_mm", camera.scale);
  for (const auto& [name, value] : snapshot.quantities) quantities.add(name, value);
  json.add("view", view);
  json.add("frame", number.index + 1);
  json.add("increment", snapshot.increment);
  json.add("time_s", snapshot.time);
  json.add("pressure_MPa", snapshot.pressure);
  json.add("feed_mm", snapshot.feed);
  json.add("label", make_time_label(snapshot));
  json.add("nodes", static_cast<int>(snapshot.points.size()));
  json.add("counts", counts);
  if (view == "gap" || view == "contact-pressure" || view == "plastic-strain" || view == "thickness")
    json.add("nodes_without_value", count_without_value(view, snapshot));
  json.add("range", range_text);
  json.add("contact_force_sum_N", triple(calc_contact_force_sum(snapshot)));
  json.add("quantities", quantities);
  json.add("camera", camera_text);
  json.add("mirrored", options.is_mirrored && !snapshot.model->mirrors.empty());
  json.add("size_px", std::vector<double>{1.0 * options.size[0], 1.0 * options.size[1]});
  json.add("theme", options.theme);
  json.add("font", lettering_font());
  json.add("renderer", renderer.renderer);
  json.add("opengl", renderer.version);
  json.add("hydroscope", HYDROSCOPE_VERSION);
  return json.text();
}

}  // namespace hydroscope
