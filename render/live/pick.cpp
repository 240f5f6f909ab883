// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/live/pick.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/live/live_camera.h"
#include "render/live/wall_rays.h"

namespace hydroscope {

std::optional<Pick> pick_point(const LiveView& view, const Snapshot& first, const Snapshot& snapshot,
                               double x, double y) {
  check_live_view(view);
  return WallRays(view, first, snapshot).find_hit(x, y);
}

std::vector<int> pick_rectangle(const LiveView& view, const Snapshot& first, const Snapshot& snapshot,
                                double x0, double y0, double x1, double y1) {
  check_live_view(view);
  return WallRays(view, first, snapshot)
      .find_seen(std::min(x0, x1), std::min(y0, y1), std::max(x0, x1), std::max(y0, y1));
}

}  // namespace hydroscope
