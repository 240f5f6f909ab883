// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/view_query.h"

#include <cmath>

#include "render/view_range.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr double kFar = 1e9;  ///< no length of a part is larger [mm]
constexpr int kMostNodes = 100'000'000;

int read_clip_axis(const Query& query) {
  const std::string axis = query.choice("clip", {"", "none", "x", "y", "z"}, "none");
  return axis.size() == 1 ? axis.front() - 'x' : -1;
}

std::optional<Vec3> read_focus(const Query& query) {
  Vec3 focus = Vec3::Zero();
  int given = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name = {'f', static_cast<char>('x' + axis)};
    const std::optional<double> value = query.number(name, -kFar, kFar);
    focus[axis] = value.value_or(0.0);
    given += value.has_value() ? 1 : 0;
  }
  if (given == 0) return std::nullopt;
  if (given < 3) throw InputError("parameters 'fx', 'fy' and 'fz' come together");
  return focus;
}

std::optional<Range> read_range(const Query& query) {
  const std::optional<double> low = query.number("lo", -1e30, 1e30);
  const std::optional<double> high = query.number("hi", -1e30, 1e30);
  if (!low && !high) return std::nullopt;
  if (!low || !high) throw InputError("parameters 'lo' and 'hi' come together");
  if (!(*low < *high)) throw InputError("parameter 'lo' must be below 'hi'");
  Range range;
  range.low = *low;
  range.high = *high;
  return range;
}

/// One picture must not take all memory, nor hold the others up for long.
void check_cost(const LiveView& view) {
  constexpr double kMost = 40e6;  // 3840 x 2160 with smoothing 2 is 33 million
  const double pixels = static_cast<double>(view.width) * view.height * view.smoothing * view.smoothing;
  if (pixels > kMost)
    throw InputError("parameters 'w', 'h', 'smooth': w * h * smooth^2 = " +
                     std::to_string(static_cast<long>(pixels)) + " is too much; at most 40000000");
}

}  // namespace

std::optional<StateKey> read_state_key(const Query& query, const std::string& name) {
  const std::string text = query.text(name, "live");
  if (text == "live") return std::nullopt;
  const std::size_t dot = text.find('.');
  if (dot == std::string::npos)
    throw InputError("parameter '" + name + "': expected live or BRANCH.INCREMENT, as in 0.12");
  return StateKey{parse_whole(name, text.substr(0, dot), 0, kMostNodes),
                  parse_whole(name, text.substr(dot + 1), 0, kMostNodes)};
}

const std::vector<std::string>& live_view_parameters() {
  static const std::vector<std::string> names = {
      "view",     "w",       "h",     "smooth", "az",    "el",    "zoom",    "px",     "py",
      "fx",       "fy",      "fz",    "clip",   "share", "flip",  "opacity", "mirror", "edges",
      "features", "density", "scale", "lo",     "hi",    "theme", "text",    "marked"};
  return names;
}

LiveView make_live_view(const Query& query) {
  LiveView view;
  view.view = query.choice("view", view_names(), view.view);
  view.width = query.whole("w", 16, 8192, view.width);
  view.height = query.whole("h", 16, 8192, view.height);
  view.smoothing = query.whole("smooth", 1, 4, view.smoothing);
  view.azimuth = query.number("az", -1e6, 1e6, view.azimuth);
  view.elevation = query.number("el", -90.0, 90.0, view.elevation);
  view.zoom = query.number("zoom", 1e-3, 1e4, view.zoom);
  view.pan_x = query.number("px", -1e6, 1e6, view.pan_x);
  view.pan_y = query.number("py", -1e6, 1e6, view.pan_y);
  view.focus = read_focus(query);
  view.clip_axis = read_clip_axis(query);
  view.clip_share = query.number("share", 0.0, 1.0, view.clip_share);
  view.clip_flip = query.flag("flip", view.clip_flip);
  view.tool_opacity = query.number("opacity", 0.0, 1.0, view.tool_opacity);
  view.is_mirrored = query.flag("mirror", view.is_mirrored);
  view.element_edges = query.flag("edges", view.element_edges);
  view.feature_edges = query.flag("features", view.feature_edges);
  view.glyph_density = query.number("density", 0.0, 4.0, view.glyph_density);
  view.glyph_scale = query.number("scale", 0.0, 1e3, view.glyph_scale);
  view.range = read_range(query);
  view.theme = query.choice("theme", {"light", "dark"}, view.theme);
  view.has_text = query.flag("text", view.has_text);
  view.marked = query.whole_list("marked", 1000, 0, kMostNodes);
  check_live_view(view);
  check_cost(view);
  return view;
}

}  // namespace hydroscope
