// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// Where a tool is, as the scene moves it.
struct ToolMotion {
  std::string name;
  std::vector<std::array<double, 4>> rows;  ///< process time [s], displacement along x, y and z [mm]

  /// Displacement [mm]: linear between the rows, constant outside them.
  Vec3 at(double time) const;
};

}  // namespace hydroscope
