// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "render/live/live_view.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// What lies under a pixel. Needs no renderer: rays against the drawn wall, with its mirror images and what
/// the clip plane leaves of it. Tools are looked through, however opaque they are: who clicks wants the wall.
struct Pick {
  int node = -1;              ///< of the modelled part, nearest to the place
  int element = -1;           ///< of the modelled part
  Vec3 place = Vec3::Zero();  ///< where the ray meets the wall, as drawn (perhaps in a mirror image) [mm]
  int image = 0;              ///< which mirror image; 0: the modelled part itself
};

/// `first`: the snapshot that fixed the camera's box (the run's first). Pixels from the top left corner.
std::optional<Pick> pick_point(const LiveView& view, const Snapshot& first, const Snapshot& snapshot,
                               double x, double y);

/// Nodes of the modelled part (each once) that are seen inside a rectangle of pixels; hidden ones are left
/// out.
std::vector<int> pick_rectangle(const LiveView& view, const Snapshot& first, const Snapshot& snapshot,
                                double x0, double y0, double x1, double y1);

}  // namespace hydroscope
