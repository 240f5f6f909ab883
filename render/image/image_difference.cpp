// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/image_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

void check_sizes(const Image& a, const Image& b) {
  require(a.width == b.width && a.height == b.height, "only pictures of one size are compared");
}

/// 1 where a pixel counts.
std::vector<char> make_mask(const Image& image, const std::vector<PixelBox>& left_out) {
  std::vector<char> mask(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 1);
  for (const PixelBox& box : left_out)
    for (int y = std::max(0, box.top); y < std::min(image.height, box.top + box.height); ++y)
      for (int x = std::max(0, box.left); x < std::min(image.width, box.left + box.width); ++x)
        mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
             static_cast<std::size_t>(x)] = 0;
  return mask;
}

int calc_largest_difference(const std::uint8_t* a, const std::uint8_t* b) {
  int largest = 0;
  for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[c] - b[c]));
  return largest;
}

/// One channel of two pictures in a window.
struct WindowSums {
  double n = 0.0, a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;

  void add(double p, double q) {
    n += 1.0;
    a += p;
    b += q;
    aa += p * p;
    bb += q * q;
    ab += p * q;
  }

  double calc_likeness() const {
    // Larger than usual, so that a few levels in a dark or even window weigh little.
    constexpr double kC1 = 0.03 * 255 * 0.03 * 255, kC2 = 0.05 * 255 * 0.05 * 255;
    if (n == 0.0) return 1.0;
    const double mean_a = a / n, mean_b = b / n;
    const double var_a = aa / n - mean_a * mean_a, var_b = bb / n - mean_b * mean_b;
    const double cov = ab / n - mean_a * mean_b;
    return (2.0 * mean_a * mean_b + kC1) * (2.0 * cov + kC2) /
           ((mean_a * mean_a + mean_b * mean_b + kC1) * (var_a + var_b + kC2));
  }
};

}  // namespace

PixelDifference calc_pixel_difference(const Image& expected, const Image& got, int levels,
                                      const std::vector<PixelBox>& left_out) {
  check_sizes(expected, got);
  const std::vector<char> mask = make_mask(expected, left_out);
  const auto width = static_cast<std::size_t>(expected.width);
  std::vector<char> is_off(mask.size(), 0);
  PixelDifference result;
  for (int y = 0; y < expected.height; ++y)
    for (int x = 0; x < expected.width; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      if (mask[at] == 0) continue;
      ++result.compared;
      const int difference = calc_largest_difference(expected.pixel(x, y), got.pixel(x, y));
      if (difference > result.largest && !result.has_block) {
        result.x = x;
        result.y = y;
      }
      result.largest = std::max(result.largest, difference);
      if (difference <= levels) continue;
      ++result.off;
      is_off[at] = 1;
      if (x == 0 || y == 0 || result.has_block) continue;
      result.has_block = is_off[at - 1] != 0 && is_off[at - width] != 0 && is_off[at - width - 1] != 0;
      if (!result.has_block) continue;
      result.x = x - 1;
      result.y = y - 1;
    }
  return result;
}

StructureDifference calc_structure_difference(const Image& expected, const Image& got,
                                              const std::vector<PixelBox>& left_out) {
  check_sizes(expected, got);
  const std::vector<char> mask = make_mask(expected, left_out);
  const auto width = static_cast<std::size_t>(expected.width);
  StructureDifference result;
  for (int top = 0; top + kWindow <= expected.height; top += kWindow / 4)
    for (int left = 0; left + kWindow <= expected.width; left += kWindow / 4)
      for (int channel = 0; channel < 3; ++channel) {
        WindowSums sums;
        for (int y = top; y < top + kWindow; ++y)
          for (int x = left; x < left + kWindow; ++x)
            if (mask[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)] != 0)
              sums.add(expected.pixel(x, y)[channel], got.pixel(x, y)[channel]);
        const double likeness = sums.calc_likeness();
        if (likeness < result.worst) result = {likeness, left, top};
      }
  return result;
}

Image make_difference_picture(const Image& expected, const Image& got, int factor) {
  check_sizes(expected, got);
  Image picture = make_image(expected.width, expected.height, {0, 0, 0});
  for (int y = 0; y < expected.height; ++y)
    for (int x = 0; x < expected.width; ++x) {
      const std::uint8_t *a = expected.pixel(x, y), *b = got.pixel(x, y);
      const int grey = (a[0] + a[1] + a[2]) / 12;
      for (int c = 0; c < 3; ++c)
        picture.pixel(x, y)[c] =
            static_cast<std::uint8_t>(std::min(255, grey + factor * std::abs(a[c] - b[c])));
    }
  return picture;
}

bool is_blank(const Image& image, const std::vector<PixelBox>& left_out) {
  const std::vector<char> mask = make_mask(image, left_out);
  for (int y = 0; y < image.height; ++y) {
    const std::uint8_t* first = nullptr;
    for (int x = 0; x < image.width; ++x) {
      if (mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
               static_cast<std::size_t>(x)] == 0)
        continue;
      if (first == nullptr) first = image.pixel(x, y);
      if (calc_largest_difference(first, image.pixel(x, y)) > 0) return false;
    }
  }
  return true;
}

}  // namespace hydroscope
