// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/record_run.h"
#include "render/frame_options.h"
#include "solver/scene/scene.h"

namespace hydroscope {

/// Draws a test picture and names the renderer; throws EnvironmentError when frames cannot be drawn here.
std::string check_renderer(int rasteriser_threads);

FrameOptions make_frame_options(const FramesScene& frames, int rasteriser_threads);

/// Frames of a run, or of its saved states.
struct FrameJob {
  FramesScene frames;
  ResultFolder folder;                  ///< frames go to its `frames/`
  int expected_frames = 0;              ///< of each view, for the turn of an orbit
  int rasteriser_threads = 1;           ///< one while the solver needs the cores
  std::optional<Bounds> later_sheet{};  ///< see FrameOptions
};

/// Draws on a thread of its own. Says on `progress` how the views that wait for the last
/// state are getting on.
FrameSink make_frame_sink(const FrameJob& job, Progress& progress);

/// Frames that a run of this scene will show.
int estimate_frames(const Scene& scene);

}  // namespace hydroscope
