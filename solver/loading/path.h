// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace hydroscope {

/// Piecewise-linear function of process time [s]; constant before its first
/// and after its last point, zero when empty.
struct Path {
  std::vector<double> times;   ///< [s], strictly increasing
  std::vector<double> values;  ///< unit of the quantity it drives

  bool empty() const { return times.empty(); }
  double end_time() const { return times.empty() ? 0.0 : times.back(); }
  double operator()(double time) const;
};

/// The first corner of the path after `time` [s]; `time` + infinity if none.
double find_next_corner(const Path& path, double time);

}  // namespace hydroscope
