// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solver/session/steered_run.h"

namespace hydroscope {

/// The states that a run can go back to, in memory. There is a bound; beyond it they are thinned out evenly
/// over process time, the first and the last of all stay.
class RestorePoints {
 public:
  explicit RestorePoints(std::size_t most_points = 64, std::size_t most_bytes = 1500UL << 20U)
      : most_points_(most_points), most_bytes_(most_bytes) {}

  /// Called for each point that is given up, with its branch and increment.
  std::function<void(int, int)> on_drop;

  /// Keeps the point; one of the same branch and increment is there already: nothing.
  void add(int branch, const RunPoint& point);
  const RunPoint* find(int branch, int increment) const;
  /// Increments of a branch that can be gone back to, rising.
  std::vector<int> increments(int branch) const;
  std::size_t size() const { return items_.size(); }

 private:
  struct Item {
    int branch;
    std::size_t bytes;
    RunPoint point;
  };
  void thin_out();

  std::size_t most_points_, most_bytes_, bytes_ = 0;
  std::vector<Item> items_;  ///< in the order in which they came
};

}  // namespace hydroscope
