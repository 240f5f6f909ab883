// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/loading/path.h"

#include <algorithm>
#include <limits>

namespace hydroscope {

double Path::operator()(double time) const {
  if (times.empty()) return 0.0;
  if (time <= times.front()) return values.front();
  if (time >= times.back()) return values.back();
  const auto upper = std::upper_bound(times.begin(), times.end(), time) - times.begin();
  const auto i = static_cast<std::size_t>(upper);
  const double share = (time - times[i - 1]) / (times[i] - times[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

double find_next_corner(const Path& path, double time) {
  const auto upper = std::upper_bound(path.times.begin(), path.times.end(), time);
  return upper == path.times.end() ? std::numeric_limits<double>::infinity() : *upper;
}

}  // namespace hydroscope
