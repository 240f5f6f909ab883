// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/work_search.h"

#include <algorithm>
#include <cmath>

namespace hydroscope {

void WorkSearch::shorten(double share) {
  high_ = scale_;
  high_work_ = -work_;
  side_ = 0;
  scale_ *= share;
}

bool WorkSearch::accepts(double rest) {
  constexpr double kSmall = 0.5;    // of the work at the start
  constexpr double kMargin = 0.05;  // of the bracket, kept from its ends
  if (work_ <= 0.0 || std::abs(rest) <= kSmall * work_) return true;
  const int side = rest < 0.0 ? 1 : -1;
  if (side < 0 && high_ == 0.0) return true;
  if (side > 0) {
    if (side_ > 0) low_work_ *= 0.5;
    high_ = scale_;
    high_work_ = rest;
  } else {
    if (side_ < 0) high_work_ *= 0.5;
    low_ = scale_;
    low_work_ = rest;
  }
  side_ = side;
  const double width = high_ - low_;
  const double zero = low_ + width * low_work_ / (low_work_ - high_work_);
  scale_ = std::clamp(zero, low_ + kMargin * width, high_ - kMargin * width);
  return false;
}

}  // namespace hydroscope
