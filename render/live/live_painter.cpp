// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/live/live_painter.h"

#include <cmath>
#include <map>

#include "render/live/live_camera.h"
#include "render/overlay.h"
#include "render/stage.h"
#include "render/view_text.h"
#include "render/views.h"
#include "solver/base/error.h"

namespace hydroscope {

struct LivePainter::Impl {
  Impl(std::shared_ptr<const Snapshot> given, int rasteriser_threads)
      : first(std::move(given)),
        stage({.smoothing = 1, .rasteriser_threads = rasteriser_threads, .is_turned_often = true}) {}

  Views& find_views(const LiveView& view, const FrameOptions& options);
  Image paint(const LiveView& view, const Snapshot& snapshot);

  std::shared_ptr<const Snapshot> first;
  Stage stage;
  std::map<bool, std::unique_ptr<Views>> views;  ///< with mirror images, and without
  std::optional<Range> range;
};

namespace {

constexpr double kUsualArrows = 2000.0;

FrameOptions make_options(const LiveView& view, const Bounds& bounds) {
  FrameOptions options;
  options.size = {view.width, view.height};
  options.theme = view.theme;
  options.is_mirrored = view.is_mirrored;
  options.element_edges = view.element_edges;
  options.feature_edges = view.feature_edges;
  options.tool_opacity = view.tool_opacity;
  options.most_arrows = static_cast<int>(std::lround(kUsualArrows * view.glyph_density));
  options.arrow_scale = view.glyph_scale;
  options.bounds = bounds;
  return options;
}

std::map<std::string, Range> find_ranges(const LiveView& view, const Snapshot& snapshot) {
  std::map<std::string, Range> ranges;
  for (const std::string& name : range_names(view.view))
    ranges[name] =
        view.range && name == view.view ? *view.range : calc_round_range(calc_range(name, snapshot));
  return ranges;
}

}  // namespace

Views& LivePainter::Impl::find_views(const LiveView& view, const FrameOptions& options) {
  std::unique_ptr<Views>& found = views[view.is_mirrored];
  if (found == nullptr) found = std::make_unique<Views>(*first, options);
  found->restyle(options);
  return *found;
}

Image LivePainter::Impl::paint(const LiveView& view, const Snapshot& snapshot) {
  check_live_view(view);
  const Bounds bounds = calc_live_bounds(*first, view.is_mirrored);
  const CameraPose camera = calc_live_camera(view, bounds);
  FrameOptions options = make_options(view, bounds);
  options.cut = calc_live_cut(camera, bounds);
  const auto ranges = find_ranges(view, snapshot);
  const auto main = ranges.find(view.view);
  range = main != ranges.end() ? std::optional(main->second) : std::nullopt;
  const DrawList list = find_views(view, options).make_draw_list(view.view, snapshot, camera, ranges);
  const Theme& colours = theme(view.theme);
  stage.resize(view.width, view.height, view.smoothing);
  Image image = stage.draw(list, camera, colours);
  if (view.has_text)
    draw_overlay(image, list.legend, snapshot.model->title, make_time_label(snapshot), camera, colours);
  return image;
}

LivePainter::LivePainter(std::shared_ptr<const Snapshot> first, int rasteriser_threads)
    : impl_(std::make_unique<Impl>(std::move(first), rasteriser_threads)) {}
LivePainter::~LivePainter() = default;
const RendererInfo& LivePainter::info() const { return impl_->stage.info(); }
Image LivePainter::paint(const LiveView& view, const std::shared_ptr<const Snapshot>& snapshot) {
  return impl_->paint(view, *snapshot);
}
Image LivePainter::paint(const LiveView& view, const Snapshot& snapshot) {
  return impl_->paint(view, snapshot);
}
std::optional<Range> LivePainter::last_range() const { return impl_->range; }

}  // namespace hydroscope
