// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check/state_painter.h"

#include <algorithm>
#include <limits>

namespace hydroscope {

std::map<std::string, Range> calc_ranges(const StateSequence& states, const FrameOptions& options) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::map<std::string, Range> ranges;
  for (const std::string& view : options.views)
    for (const std::string& name : range_names(view)) ranges[name] = {kInfinity, -kInfinity};
  if (ranges.empty()) return ranges;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const auto state = states.read(i);
    for (auto& [name, range] : ranges) {
      const Range more = calc_range(name, *state);
      range = {std::min(range.low, more.low), std::max(range.high, more.high)};
    }
  }
  for (auto& [name, range] : ranges) {
    const auto given = options.ranges.find(name);
    range = given != options.ranges.end() ? given->second : calc_round_range(range);
  }
  return ranges;
}

Bounds calc_sheet_bounds(const StateSequence& states, bool is_mirrored) {
  Bounds bounds;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const Bounds sheet = calc_sheet_bounds(*states.read(i), is_mirrored);
    bounds.include(sheet.least);
    bounds.include(sheet.greatest);
  }
  return bounds;
}

void paint_states(const StateSequence& states, const StatePainting& painting) {
  const std::map<std::string, Range> ranges = calc_ranges(states, painting.options);
  FrameOptions options = painting.options;
  options.later_sheet = calc_sheet_bounds(states, options.is_mirrored);
  FramePainter painter(options);
  ClassPass classes(painting.options.rasteriser_threads);
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (painting.is_stopped && painting.is_stopped()) return;
    const auto state = states.read(i);
    const int number = states.stamps()[i].number;
    const FrameNumber place{number, std::max(painting.expected_frames, number + 1)};
    for (const std::string& view : painting.options.views) {
      StateFrame made{.view = view, .frame = number + 1, .sidecar = {}, .image = {}, .texts = {}};
      made.has_image = painting.wants_picture(made.frame);
      if (made.has_image) {
        Frame frame = painter.paint(view, *state, place, ranges);
        made.sidecar = std::move(frame.sidecar);
        made.image = std::move(frame.image);
        made.texts = std::move(frame.texts);
      } else {
        made.sidecar = painter.describe(view, *state, place, ranges);
      }
      painting.on_frame(std::move(made));
    }
    if (painting.on_state)
      painting.on_state(number + 1, *state, read_class_pictures(classes.draw(*state), *state));
  }
}

}  // namespace hydroscope
