// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/restore_points.h"

#include <algorithm>
#include <cmath>

namespace hydroscope {

void RestorePoints::add(int branch, const RunPoint& point) {
  if (find(branch, point.state.increment) != nullptr) return;
  const std::size_t bytes = calc_size(point);
  items_.push_back({branch, bytes, point});
  bytes_ += bytes;
  while (items_.size() > 2 && (items_.size() > most_points_ || bytes_ > most_bytes_)) thin_out();
}

/// Gives up the point whose neighbours are closest to each other.
void RestorePoints::thin_out() {
  std::size_t victim = 1;
  double closest = kNoHalt;
  for (std::size_t i = 1; i + 1 < items_.size(); ++i) {
    const double gap = std::abs(items_[i + 1].point.state.time - items_[i - 1].point.state.time);
    if (gap < closest) {
      closest = gap;
      victim = i;
    }
  }
  const int branch = items_[victim].branch, increment = items_[victim].point.state.increment;
  bytes_ -= items_[victim].bytes;
  items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(victim));
  if (on_drop) on_drop(branch, increment);
}

const RunPoint* RestorePoints::find(int branch, int increment) const {
  for (const Item& item : items_) {
    if (item.branch == branch && item.point.state.increment == increment) return &item.point;
  }
  return nullptr;
}

std::vector<int> RestorePoints::increments(int branch) const {
  std::vector<int> found;
  for (const Item& item : items_) {
    if (item.branch == branch) found.push_back(item.point.state.increment);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace hydroscope
