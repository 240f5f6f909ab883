// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/live/live_view.h"

#include <algorithm>
#include <cmath>

#include "render/view_range.h"
#include "render/view_text.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

void check(const char* field, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw InputError(std::string(field) + " = " + format_number(value) + ": must lie between " +
                   format_number(least) + " and " + format_number(most));
}

void check_word(const char* field, const std::string& value, const std::vector<std::string>& allowed) {
  if (std::find(allowed.begin(), allowed.end(), value) == allowed.end())
    throw InputError(std::string(field) + " = '" + value + "': must be one of " + join(allowed));
}

}  // namespace

void check_live_view(const LiveView& view) {
  constexpr double kFar = 1e6;
  check_word("view", view.view, view_names());
  check_word("theme", view.theme, {"light", "dark"});
  check("width", view.width, 64, 8192);
  check("height", view.height, 64, 8192);
  check("smoothing", view.smoothing, 1, 4);
  check("width * smoothing", view.width * view.smoothing, 64, 16384);
  check("height * smoothing", view.height * view.smoothing, 64, 16384);
  check("azimuth", view.azimuth, -kFar, kFar);
  check("elevation", view.elevation, -90, 90);
  check("zoom", view.zoom, 0.01, 10000);
  check("pan_x", view.pan_x, -100, 100);
  check("pan_y", view.pan_y, -100, 100);
  if (view.focus)
    for (const double coordinate : {view.focus->x(), view.focus->y(), view.focus->z()})
      check("focus", coordinate, -kFar, kFar);
  check("clip_axis", view.clip_axis, -1, 2);
  check("clip_share", view.clip_share, 0, 1);
  check("tool_opacity", view.tool_opacity, 0, 1);
  check("glyph_density", view.glyph_density, 0, 4);
  check("glyph_scale", view.glyph_scale, 0.01, 100);
  if (view.range && !(std::isfinite(view.range->low) && std::isfinite(view.range->high) &&
                      view.range->low < view.range->high))
    throw InputError("range = " + format_number(view.range->low) + ", " + format_number(view.range->high) +
                     ": must be two numbers, the lower one first");
  check("text_scale", view.text_scale, 0.25, 4);
  check("number of marked nodes", static_cast<double>(view.marked.size()), 0, 10000);
  for (const int node : view.marked) check("marked", node, 0, 1e9);
}

}  // namespace hydroscope
