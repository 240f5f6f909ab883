// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace hydroscope {

/// A rectangle of pixels; (left, top) is its first one. Empty at first.
struct PixelBox {
  int left = 0, top = 0, width = 0, height = 0;

  bool holds(int x, int y) const { return x >= left && x < left + width && y >= top && y < top + height; }
  void include(int x, int y) {
    const int right = width == 0 ? x : std::max(left + width - 1, x);
    const int bottom = width == 0 ? y : std::max(top + height - 1, y);
    left = width == 0 ? x : std::min(left, x);
    top = width == 0 ? y : std::min(top, y);
    width = right - left + 1;
    height = bottom - top + 1;
  }
  bool operator==(const PixelBox&) const = default;
};

}  // namespace hydroscope
