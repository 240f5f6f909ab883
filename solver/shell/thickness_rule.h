// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hydroscope {

/// Points and weights through the thickness on zeta in [-1, 1]; weights add up to 1.
struct ThicknessRule {
  std::vector<double> zeta;
  std::vector<double> weight;
  int size() const { return static_cast<int>(zeta.size()); }
};

/// `kind`: gauss | lobatto | simpson | split_gauss (Gauss on each half of the
/// wall: keeps its accuracy in bending, where the stress has a kink at
/// mid-thickness; mechanics 2.6). Throws InputError for a count the rule does not have.
ThicknessRule make_thickness_rule(const std::string& kind, int points);

}  // namespace hydroscope
