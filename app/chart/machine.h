// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hydroscope {

/// The machine, as the report of a study names it.
struct Machine {
  std::string processor, system, date;
  int cores = 0;  ///< that this process may use
  double memory_gb = 0.0;
};

/// Reads /proc and /etc; what cannot be read is "unknown".
Machine find_machine();

}  // namespace hydroscope
