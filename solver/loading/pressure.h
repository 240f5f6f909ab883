// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "solver/base/types.h"

namespace hydroscope {

/// Load of a unit pressure that pushes along g1 x g2 on a four-node face,
/// f_a = int N_a (g1 x g2) dxi deta [mm^2] (mechanics 3.1).
std::array<Vec3, 4> calc_pressure_load(const std::array<Vec3, 4>& x);

/// Its stiffness d f_a / d x_b, the symmetric element form that is exact after
/// assembly wherever boundary terms vanish (mechanics 3.2): it goes to the
/// left-hand side as K - p K_p.
std::array<std::array<Mat3, 4>, 4> calc_pressure_stiffness(const std::array<Vec3, 4>& x);

/// [a]x, so that [a]x b = a x b.
Mat3 skew(const Vec3& a);

}  // namespace hydroscope
