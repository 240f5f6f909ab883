// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "solver/scene/scene.h"

namespace hydroscope {

/// Process times at which something is to be shown, passed one after the other; a plain value.
class Schedule {
 public:
  Schedule() = default;
  /// `number` times over `end` [s], or one every `interval` [s] where it is given; `is_every`: always.
  Schedule(int number, double interval, bool is_every, double end) : is_every_(is_every) {
    const double step = interval > 0.0 ? interval : end / std::max(number, 1);
    for (double t = step; t < end * (1.0 - 1e-9); t += step) times_.push_back(t);
  }
  /// Was one of the times passed since this was asked last?
  bool is_due(double time) {
    if (is_every_) return true;
    bool due = false;
    while (next_ < times_.size() && time >= times_[next_] * (1.0 - 1e-12)) {
      ++next_;
      due = true;
    }
    return due;
  }

 private:
  bool is_every_ = false;
  std::vector<double> times_;
  std::size_t next_ = 0;
};

inline Schedule make_state_schedule(const Scene& scene, double end) {
  return {scene.states.number, 0.0, false, end};
}

inline Schedule make_frame_schedule(const FramesScene& frames, double end) {
  return {frames.number, frames.pick == "interval" ? frames.interval : 0.0, frames.pick == "every", end};
}

}  // namespace hydroscope
