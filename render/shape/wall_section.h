// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/shape/surface.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// Where a plane cuts the wall: the cut's area, and its borders on the outer and inner face.
struct WallSection {
  Surface area;
  LineSet borders;
};

/// The wall is the solid between X - (h/2) V and X + (h/2) V; its quads are halved along the first diagonal,
/// as they are drawn.
WallSection calc_wall_section(const Snapshot& snapshot, const std::vector<Reflection>& reflections,
                              const Plane& plane);

}  // namespace hydroscope
