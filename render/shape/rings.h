// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "render/shape/surface.h"

namespace hydroscope {

/// Flat rings around places, across `towards_viewer`, between two radii [mm].
Surface make_rings(const std::vector<Vec3>& centres, double inner, double outer, const Vec3& towards_viewer);

}  // namespace hydroscope
