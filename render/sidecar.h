// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "render/frame_options.h"
#include "render/image/pixel_box.h"
#include "render/offscreen_context.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// Which frame of which sequence.
struct FrameNumber {
  int index = 0;     ///< from 0
  int expected = 1;  ///< frames in the whole sequence
};

/// What a sidecar tells beside the snapshot.
struct SidecarContext {
  std::string view;
  FrameNumber number;
  CameraPose camera;
  std::map<std::string, Range> ranges;
  std::vector<PixelBox> lettering;                          ///< where text and legends stand in the picture
  double since = std::numeric_limits<double>::quiet_NaN();  ///< see calc_contact_life()
};

/// The JSON beside a frame: what was drawn, in numbers that read back exactly;
/// what is no number is null. Keys that end in a unit are quantities, others are
/// counts or words.
std::string make_sidecar(const SidecarContext& context, const Snapshot& snapshot, const FrameOptions& options,
                         const RendererInfo& renderer);

}  // namespace hydroscope
