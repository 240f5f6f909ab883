// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "render/shape/surface.h"

namespace hydroscope {

struct Arrow {
  Vec3 start;          ///< [mm]
  Vec3 span;           ///< from start to tip, already scaled [mm]
  double value = 0.0;  ///< for its colour
};

/// Arrows as solids of a shaft and a head. `width` [mm] is the head's diameter of
/// an arrow that is long enough; shorter ones shrink with their length.
Surface make_arrows(const std::vector<Arrow>& arrows, double width,
                    const std::vector<Reflection>& reflections);

/// At most `count` points, no two closer than some distance, in order; the same
/// points give the same choice, so that arrows do not flicker over a sequence.
std::vector<int> find_spread_points(const std::vector<Vec3>& points, int count);

}  // namespace hydroscope
