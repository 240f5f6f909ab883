// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <thread>

#include "app/command_line.h"

namespace hydroscope {

/// --threads, or as many as there are cores (at most 8).
inline int find_threads(const Arguments& arguments) {
  constexpr int kMost = 64;
  if (arguments.has("--threads"))
    return parse_whole_number("--threads", arguments.get("--threads"), 1, kMost);
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
}

}  // namespace hydroscope
