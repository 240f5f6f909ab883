// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

#include "render/image/png_file.h"
#include "render/sidecar.h"
#include "render/stage.h"
#include "render/views.h"

namespace hydroscope {

/// A drawn frame and what is written beside it.
struct Frame {
  Image image;
  PngTexts texts;
  std::string sidecar;  ///< JSON
};

/// Draws frames: stage, views and overlay in one. Belongs to one thread.
class FramePainter {
 public:
  explicit FramePainter(const FrameOptions& options);

  const RendererInfo& info() const { return stage_.info(); }

  /// The first snapshot fixes the camera's box, the arrows' nodes and the tools.
  Frame paint(const std::string& view, const Snapshot& snapshot, FrameNumber number,
              const std::map<std::string, Range>& ranges);
  /// The sidecar alone, without drawing (and so without the lettering's boxes).
  std::string describe(const std::string& view, const Snapshot& snapshot, FrameNumber number,
                       const std::map<std::string, Range>& ranges);

 private:
  /// Makes what the first snapshot fixes, and the camera of this frame.
  CameraPose prepare(const Snapshot& snapshot, FrameNumber number);
  /// Process time of the view's frame before this one [s]; NaN: there was none.
  double find_since(const std::string& view, const Snapshot& snapshot, FrameNumber number);

  FrameOptions options_;
  Stage stage_;
  std::unique_ptr<Views> views_;
  struct Shown {
    int index;
    double time, since;  ///< [s]
  };
  std::map<std::string, Shown> shown_;  ///< last frame of each view
};

}  // namespace hydroscope
