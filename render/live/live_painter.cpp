// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/live/live_painter.h"

#include <cmath>
#include <map>
#include <utility>

#include "render/live/draw_cache.h"
#include "render/live/live_camera.h"
#include "render/overlay.h"
#include "render/stage.h"
#include "render/view_text.h"
#include "render/views.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr int kKept = 6;  // draw lists, each with its snapshot and some 10 MB
constexpr double kUsualArrows = 2000.0;

constexpr double kCoarse = 3.2;  // [px] of an element below which rough pictures show four as one

FrameOptions make_options(const LiveView& view, const Bounds& bounds, bool is_coarse) {
  FrameOptions options;
  options.size = {view.width, view.height};
  options.theme = view.theme;
  options.is_mirrored = view.is_mirrored;
  options.element_edges = view.element_edges;
  options.feature_edges = view.feature_edges;
  options.tool_opacity = view.tool_opacity;
  options.is_tool_cut = view.is_tool_cut;
  options.most_arrows = static_cast<int>(std::lround(kUsualArrows * view.glyph_density));
  options.arrow_scale = view.glyph_scale;
  options.bounds = bounds;
  options.is_coarse = is_coarse;
  return options;
}

std::map<std::string, Range> find_ranges(const LiveView& view, const Snapshot& snapshot) {
  std::map<std::string, Range> ranges;
  for (const std::string& name : range_names(view.view))
    ranges[name] =
        view.range && name == view.view ? *view.range : calc_round_range(calc_range(name, snapshot));
  return ranges;
}

/// Balls that mark nodes have a size in the picture: they are made anew when the zoom has changed by half.
double round_zoom(const std::string& view, double zoom) {
  if (view != "detachment" && view != "release-margin") return 1.0;
  return std::exp2(0.5 * std::round(2.0 * std::log2(zoom)));
}

/// What of a view the draw list depends on.
LiveView calc_look(const LiveView& view) {
  LiveView look;
  look.view = view.view;
  look.zoom = round_zoom(view.view, view.zoom);
  look.tool_opacity = view.tool_opacity;
  look.is_tool_cut = view.is_tool_cut;
  look.is_mirrored = view.is_mirrored;
  look.element_edges = view.element_edges;
  look.feature_edges = view.feature_edges;
  look.glyph_density = view.glyph_density;
  look.glyph_scale = view.glyph_scale;
  look.range = view.range;
  look.theme = view.theme;
  return look;
}

void check_marks(const LiveView& view, const Snapshot& snapshot) {
  const int nodes = static_cast<int>(snapshot.points.size());
  for (const int node : view.marked)
    if (node >= nodes)
      throw InputError("marked = " + std::to_string(node) + ": nodes run from 0 to " +
                       std::to_string(nodes - 1));
}

}  // namespace

struct LivePainter::Impl {
  Impl(std::shared_ptr<const Snapshot> given, int rasteriser_threads)
      : first(std::move(given)),
        stage({.width = 640,
               .height = 360,
               .smoothing = 1,
               .rasteriser_threads = rasteriser_threads,
               .is_turned_often = true}) {}

  /// The shapes of the whole part, or of the modelled one.
  struct Part {
    Bounds bounds;
    double edge_length;  ///< mean of the first snapshot's elements [mm]
    std::unique_ptr<Views> views;
  };
  Part& find_part(bool is_mirrored);
  const DrawCache::Entry& find_entry(const LiveView& view, const CameraPose& camera, bool is_coarse,
                                     const std::shared_ptr<const Snapshot>& snapshot, Part& part);
  Image paint(const LiveView& view, const std::shared_ptr<const Snapshot>& snapshot);

  std::shared_ptr<const Snapshot> first;
  Stage stage;
  std::map<bool, Part> parts;
  DrawCache cache{kKept};
  std::optional<Range> range;
};

LivePainter::Impl::Part& LivePainter::Impl::find_part(bool is_mirrored) {
  const auto [place, is_new] = parts.try_emplace(is_mirrored);
  Part& part = place->second;
  if (is_new) {
    part.bounds = calc_live_bounds(*first, is_mirrored);
    LiveView usual;
    usual.is_mirrored = is_mirrored;
    part.views = std::make_unique<Views>(*first, make_options(usual, part.bounds, false));
    part.edge_length = part.views->calc_edge_length(*first);
  }
  return part;
}

const DrawCache::Entry& LivePainter::Impl::find_entry(const LiveView& view, const CameraPose& camera,
                                                      bool is_coarse,
                                                      const std::shared_ptr<const Snapshot>& snapshot,
                                                      Part& part) {
  const LiveView look = calc_look(view);
  const Plane cut = calc_live_cut(camera, part.bounds);
  if (const DrawCache::Entry* kept = cache.find(look, cut.normal, is_coarse, snapshot)) return *kept;
  DrawCache::Entry made{look, cut.normal, is_coarse, snapshot, {}, std::nullopt};
  const auto ranges = find_ranges(view, *snapshot);
  const auto main = ranges.find(view.view);
  if (main != ranges.end()) made.range = main->second;
  CameraPose usual = camera;
  usual.scale *= view.zoom / look.zoom;
  made.list = part.views->make_draw_list(view.view, *snapshot, usual, ranges, cut);
  return cache.keep(std::move(made));
}

Image LivePainter::Impl::paint(const LiveView& view, const std::shared_ptr<const Snapshot>& snapshot) {
  check_live_view(view);
  check_marks(view, *snapshot);
  Part& part = find_part(view.is_mirrored);
  const CameraPose camera = calc_live_camera(view, part.bounds);
  const double pixel = 2.0 * camera.scale / view.height;
  const bool is_coarse = view.smoothing == 1 && part.edge_length < kCoarse * pixel;
  Views& views = *part.views;
  views.restyle(make_options(view, part.bounds, is_coarse));
  const DrawCache::Entry& entry = find_entry(view, camera, is_coarse, snapshot, part);
  range = entry.range;
  DrawList list = entry.list;
  if (const auto clip = calc_clip_plane(view, part.bounds)) views.add_clip(list, view.view, *snapshot, *clip);
  const Vec3 towards_viewer = (camera.position - camera.focal).normalized();
  views.add_marks(list, view.marked, *snapshot, towards_viewer,
                  2.0 * camera.scale / std::min(720, view.height));
  const Theme& colours = theme(view.theme);
  stage.resize(view.width, view.height, view.smoothing);
  Image image = stage.draw(list, camera, colours, entry.slot);
  if (view.has_text)
    draw_overlay(image, list.legend, snapshot->model->title, make_time_label(*snapshot), camera, colours,
                 view.text_scale);
  return image;
}

LivePainter::LivePainter(std::shared_ptr<const Snapshot> first, int rasteriser_threads)
    : impl_(std::make_unique<Impl>(std::move(first), rasteriser_threads)) {}
LivePainter::~LivePainter() = default;
const RendererInfo& LivePainter::info() const { return impl_->stage.info(); }
Image LivePainter::paint(const LiveView& view, const std::shared_ptr<const Snapshot>& snapshot) {
  return impl_->paint(view, snapshot);
}
Image LivePainter::paint(const LiveView& view, const Snapshot& snapshot) {
  return impl_->paint(view, std::make_shared<const Snapshot>(snapshot));
}
std::optional<Range> LivePainter::last_range() const { return impl_->range; }

}  // namespace hydroscope
