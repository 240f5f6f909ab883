// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame_painter.h"

#include <algorithm>

#include "render/camera.h"
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

CameraPose FramePainter::prepare(const Snapshot& snapshot, FrameNumber number) {
  if (views_ == nullptr) {
    check_camera(options_, static_cast<int>(snapshot.points.size()));
    views_ = std::make_unique<Views>(snapshot, options_);
  }
  views_->hold(snapshot);
  std::optional<Vec3> look_at;
  if (options_.camera == "look-at")
    look_at = snapshot.points.at(static_cast<std::size_t>(options_.look_at_node));
  return calc_camera(options_, views_->bounds(), look_at, number.index, number.expected);
}

double FramePainter::find_since(const std::string& view, const Snapshot& snapshot, FrameNumber number) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const auto last = shown_.find(view);
  double since = kNone;
  if (last != shown_.end()) {
    if (last->second.index == number.index) since = last->second.since;  // the same frame again
    if (last->second.index < number.index) since = last->second.time;
  }
  shown_[view] = {number.index, snapshot.time, since};
  return since;
}

std::string FramePainter::describe(const std::string& view, const Snapshot& snapshot, FrameNumber number,
                                   const std::map<std::string, Range>& ranges) {
  check_snapshot(snapshot);
  const CameraPose camera = prepare(snapshot, number);
  return make_sidecar({view, number, camera, ranges, {}, find_since(view, snapshot, number)}, snapshot,
                      options_, info());
}

Frame FramePainter::paint(const std::string& view, const Snapshot& snapshot, FrameNumber number,
                          const std::map<std::string, Range>& ranges) {
  const CameraPose camera = prepare(snapshot, number);
  const double since = find_since(view, snapshot, number);
  const DrawList list = views_->make_draw_list(view, snapshot, camera, ranges, since);
  const Theme& colours = theme(options_.theme);
  Frame frame;
  frame.image = stage_.draw(list, camera, colours, find_slot(view));
  const std::string label = make_time_label(snapshot);
  SidecarContext context{view, number, camera, ranges, {}, since};
  if (!options_.is_flat)
    context.lettering = draw_overlay(frame.image, list.legend, snapshot.model->title, label, camera, colours);
  frame.texts = {{"Renderer", info().renderer + ", OpenGL " + info().version},
                 {"Software", "Hydroscope " HYDROSCOPE_VERSION},
                 {"Title", snapshot.model->title},
                 {"Comment", label}};
  frame.sidecar = make_sidecar(context, snapshot, options_, info());
  return frame;
}

}  // namespace hydroscope
