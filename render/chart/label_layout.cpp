// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/chart/label_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace hydroscope {
namespace {

constexpr int kDirections = 16;
constexpr double kReaches[] = {4.0, 16.0, 34.0, 56.0, 82.0, 112.0};  // [px] between marker and label

int calc_overlap(const PixelBox& a, const PixelBox& b) {
  const int width = std::min(a.left + a.width, b.left + b.width) - std::max(a.left, b.left);
  const int height = std::min(a.top + a.height, b.top + b.height) - std::max(a.top, b.top);
  return width > 0 && height > 0 ? width * height : 0;
}

bool is_inside(const PixelBox& box, const PixelBox& bounds) {
  return box.left >= bounds.left && box.top >= bounds.top &&
         box.left + box.width <= bounds.left + bounds.width &&
         box.top + box.height <= bounds.top + bounds.height;
}

/// The box whose nearest edge is `reach` away from the marker in one of the directions.
PixelBox make_candidate(const LabelWish& wish, int direction, double reach) {
  const double angle = 2.0 * std::numbers::pi * direction / kDirections;
  const double c = std::cos(angle), s = std::sin(angle);
  const double distance = wish.clearance + reach;
  // Beside the point the label ends at it, above and below it is centred.
  const double x = wish.x + distance * c +
                   0.5 * wish.width * (std::abs(c) < 1e-6 ? 0.0 : c / std::max(std::abs(c), std::abs(s)));
  const double y = wish.y - distance * s -
                   0.5 * wish.height * (std::abs(s) < 1e-6 ? 0.0 : s / std::max(std::abs(c), std::abs(s)));
  return {static_cast<int>(std::lround(x - 0.5 * wish.width)),
          static_cast<int>(std::lround(y - 0.5 * wish.height)), wish.width, wish.height};
}

/// Those with many neighbours first, since they have the least choice.
std::vector<std::size_t> find_order(const std::vector<LabelWish>& wishes) {
  std::vector<int> neighbours(wishes.size(), 0);
  for (std::size_t i = 0; i < wishes.size(); ++i)
    for (const LabelWish& other : wishes)
      if (std::abs(other.x - wishes[i].x) < wishes[i].width &&
          std::abs(other.y - wishes[i].y) < 3 * wishes[i].height)
        ++neighbours[i];
  std::vector<std::size_t> order(wishes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return neighbours[a] > neighbours[b]; });
  return order;
}

}  // namespace

std::vector<PlacedLabel> place_labels(const std::vector<LabelWish>& wishes, const PixelBox& bounds,
                                      const std::vector<PixelBox>& obstacles,
                                      const std::vector<std::array<double, 2>>& lines) {
  // Right first, then left, above, below, and the slants between.
  constexpr int kPreference[kDirections] = {0, 8, 4, 12, 2, 14, 6, 10, 1, 15, 7, 9, 3, 13, 5, 11};
  constexpr double kOutside = 1e6, kOnLabel = 1e3, kOnLine = 1.0, kFurther = 3.0;
  std::vector<PlacedLabel> placed(wishes.size());
  std::vector<PixelBox> taken = obstacles;
  for (const std::size_t i : find_order(wishes)) {
    double least = std::numeric_limits<double>::infinity(), further = 0.0;
    for (const double reach : kReaches) {
      for (const int direction : kPreference) {
        const PixelBox box = make_candidate(wishes[i], direction, reach);
        double blocked = is_inside(box, bounds) ? 0.0 : kOutside;
        for (const PixelBox& other : taken) blocked += kOnLabel * calc_overlap(box, other);
        double cost = blocked + further;
        if (cost >= least) continue;
        for (const auto& point : lines)
          if (box.holds(static_cast<int>(point[0]), static_cast<int>(point[1]))) cost += kOnLine;
        if (cost >= least) continue;
        least = cost;
        placed[i] = {box, blocked == 0.0, reach > kReaches[0]};
      }
      if (least <= further) break;
      further += kFurther;
    }
    taken.push_back(placed[i].box);
  }
  return placed;
}

}  // namespace hydroscope
