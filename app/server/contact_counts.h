// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/increment/report.h"

namespace hydroscope {

/// Nodes by what happened to them in one increment.
struct ContactCounts {
  int increment = 0;
  int touched = 0, slipped = 0, detached = 0, retouched = 0;
};

/// One an increment, in order; increments without any of these are left out.
std::vector<ContactCounts> count_contact(const std::vector<ContactEvent>& events);

}  // namespace hydroscope
