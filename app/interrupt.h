// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace hydroscope {

/// While it lives, SIGINT and SIGTERM raise a flag instead of ending the program;
/// a second one ends it at once. Writing past a file size limit becomes an error
/// that the writer sees, and a closed terminal no longer ends the run.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  static std::atomic<bool>& flag();
};

}  // namespace hydroscope
