// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame_sink.h"

#include <cmath>

#include "render/frame_sequence.h"
#include "render/offscreen_context.h"

namespace hydroscope {

FrameOptions make_frame_options(const FramesScene& frames, int rasteriser_threads) {
  FrameOptions options;
  options.views = frames.views;
  options.size = frames.size;
  options.theme = frames.theme;
  options.camera = frames.camera;
  options.azimuth = frames.azimuth;
  options.elevation = frames.elevation;
  options.zoom = frames.zoom;
  options.orbit = frames.orbit;
  options.look_at_node = frames.look_at_node;
  options.is_mirrored = frames.mirror;
  options.facet_normals = frames.facet_normals;
  options.tool_opacity = frames.tool_opacity;
  options.animation = frames.animation;
  options.frames_per_second = frames.frames_per_second;
  options.rasteriser_threads = rasteriser_threads;
  return options;
}

std::string check_renderer(int rasteriser_threads) { return describe_renderer(rasteriser_threads); }

FrameSink make_frame_sink(const FrameJob& job, Progress& progress) {
  FrameOptions options = make_frame_options(job.frames, job.rasteriser_threads);
  options.later_sheet = job.later_sheet;
  options.on_progress = [&progress](int done, int of) { progress.update_drawing(done, of); };
  const auto sequence = std::make_shared<FrameSequence>(options, job.folder.frames().string());
  FrameSink sink;
  sink.submit = [sequence, expected = job.expected_frames](std::shared_ptr<const Snapshot> snapshot) {
    sequence->submit(std::move(snapshot), expected);
  };
  sink.finish = [sequence] {
    const SequenceReport report = sequence->finish();
    return report.seconds_drawing + report.seconds_encoding + report.seconds_animation;
  };
  return sink;
}

int estimate_frames(const Scene& scene) {
  const FramesScene& frames = scene.frames;
  if (frames.pick == "interval") return 1 + static_cast<int>(std::ceil(scene.end_time() / frames.interval));
  // With every increment the number is known only at the end; they are at most this large.
  if (frames.pick == "every") return 1 + static_cast<int>(std::ceil(1.0 / scene.increment.largest));
  return 1 + frames.number;
}

}  // namespace hydroscope
