// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "render/shape/surface.h"

namespace hydroscope {

/// Balls of one radius [mm] that stand out from the sheet.
Surface make_markers(const std::vector<Vec3>& centres, double radius,
                     const std::vector<Reflection>& reflections);

}  // namespace hydroscope
