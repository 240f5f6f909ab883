// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "render/frame_options.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

struct SequenceReport {
  int frames = 0;                        ///< of each view
  double seconds_drawing = 0.0;          ///< wall time of the render thread at work
  double seconds_encoding = 0.0;         ///< wall time of the encoder thread at work (PNG and sidecar)
  double seconds_animation = 0.0;        ///< wall time of the animations, after the last frame
  double seconds_producer_waited = 0.0;  ///< submit() waiting for room in the queue
  std::string renderer;
  std::vector<std::string> animations;  ///< files written
};

/// Image sequences of one run: DIRECTORY/VIEW/00001.png with 00001.json beside
/// it, and DIRECTORY/VIEW.webp (or .mp4) at the end. Drawn on a thread of its own,
/// which owns the renderer, and encoded on another; no snapshot is lost.
class FrameSequence {
 public:
  /// Starts the renderer. Throws InputError for bad options, EnvironmentError
  /// when the renderer, the folder or ffmpeg cannot be used.
  FrameSequence(const FrameOptions& options, std::string directory);
  /// Without finish(): stops after the frame at work; frames on disk stay.
  ~FrameSequence();
  FrameSequence(const FrameSequence&) = delete;
  FrameSequence& operator=(const FrameSequence&) = delete;

  /// The next frame. Waits while the queue is full. `n_frames_expected` in the
  /// whole sequence (for the orbit). After an error on the threads it returns
  /// at once; finish() then throws that error.
  void submit(std::shared_ptr<const Snapshot> snapshot, int n_frames_expected);

  /// Draws what is waiting, then the views whose range had to be found first,
  /// and the animations. Throws the first error of the threads. Call once.
  SequenceReport finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hydroscope
