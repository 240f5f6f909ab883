// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>

#include "app/check/state_sequence.h"
#include "render/class_pass.h"
#include "render/frame_painter.h"

namespace hydroscope {

/// One frame made from a saved state.
struct StateFrame {
  std::string view;
  int frame = 0;  ///< from 1: the state's number + 1
  std::string sidecar;
  bool has_image = false;
  Image image;
  PngTexts texts;
};

/// What to make of a sequence of states, and who gets it.
struct StatePainting {
  FrameOptions options;
  int expected_frames = 0;                       ///< of the whole sequence
  std::function<bool(int frame)> wants_picture;  ///< drawn, not only described
  std::function<void(StateFrame)> on_frame;      ///< state by state, views in order
  std::function<void(int frame, const Snapshot&, const ClassAgreement&)> on_state;  ///< empty: no class pass
  std::function<bool()> is_stopped;                                                 ///< asked between states
};

/// Ranges of the views over all states, as a finished run shows them.
std::map<std::string, Range> calc_ranges(const StateSequence& states, const FrameOptions& options);

/// Box of the sheet over all states, as drawn [mm].
Bounds calc_sheet_bounds(const StateSequence& states, bool is_mirrored);

/// Draws on the calling thread. Throws EnvironmentError when nothing can be drawn.
void paint_states(const StateSequence& states, const StatePainting& painting);

}  // namespace hydroscope
