// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hydroscope::verification {

/// The shell obstacle course (V2): linear elastic shells of usual renown, each asked for one displacement.
struct Obstacle {
  std::string name;
  double reference;  ///< displacement at the load, or at the free edge
  /// That displacement with `n` elements a side of the symmetric part (`n` across a beam, which gets
  /// elements about as long as wide).
  double (*solve)(int n);
};

/// Scordelis-Lo roof, pinched cylinder, hemisphere (whole, and with a hole of 18 degrees), twisted beam
/// (thick: in and out of plane; thin: the same), Raasch's hook.
const std::vector<Obstacle>& list_obstacles();
const Obstacle& find_obstacle(const std::string& name);

}  // namespace hydroscope::verification
