// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/image.h"

#include <algorithm>
#include <cstring>

#include "solver/base/error.h"

namespace hydroscope {

Image make_image(int width, int height, Rgb colour) {
  require(width > 0 && height > 0, "an image has at least one pixel");
  Image image{width, height, {}};
  image.rgba.resize(4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c) image.rgba[i + c] = colour[c];
  return image;
}

namespace {

/// Adds one row, `factor` pixels into one. The usual factors are constants to the compiler.
template <int kFactor>
void add_row(const std::uint8_t* source, std::vector<std::uint16_t>& sums, int factor) {
  const int count = kFactor > 0 ? kFactor : factor;
  for (std::size_t x = 0; x < sums.size(); x += 4)
    for (int k = 0; k < count; ++k, source += 4)
      for (std::size_t c = 0; c < 4; ++c) sums[x + c] = static_cast<std::uint16_t>(sums[x + c] + source[c]);
}

}  // namespace

Image reduced(const std::uint8_t* rows_from_below, int width, int height, int factor) {
  require(factor >= 1 && factor <= 8, "reduction factor between 1 and 8");
  Image image{width, height, {}};
  image.rgba.resize(4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const std::size_t row_bytes = 4u * static_cast<std::size_t>(width);
  if (factor == 1) {
    for (int y = 0; y < height; ++y)
      std::memcpy(image.pixel(0, y), rows_from_below + static_cast<std::size_t>(height - 1 - y) * row_bytes,
                  row_bytes);
    return image;
  }
  const auto source_row = 4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(factor);
  const auto weight = static_cast<std::uint16_t>(factor * factor);
  std::vector<std::uint16_t> sums(4u * static_cast<std::size_t>(width));
  const auto add = factor == 2 ? add_row<2> : add_row<0>;
  for (int y = 0; y < height; ++y) {
    sums.assign(sums.size(), weight / 2);
    const auto first = static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(factor);
    for (std::size_t row = first; row < first + static_cast<std::size_t>(factor); ++row)
      add(rows_from_below + row * source_row, sums, factor);
    std::uint8_t* target = image.pixel(0, y);
    if (factor == 2)
      for (std::size_t i = 0; i < sums.size(); ++i) target[i] = static_cast<std::uint8_t>(sums[i] / 4);
    else
      for (std::size_t i = 0; i < sums.size(); ++i) target[i] = static_cast<std::uint8_t>(sums[i] / weight);
  }
  return image;
}

void lay_on_ground(Image& image, Rgb top, Rgb bottom) {
  for (int y = 0; y < image.height; ++y) {
    const int below = 2 * y + 1, above = 2 * image.height - below;
    std::array<unsigned, 3> ground;
    for (std::size_t c = 0; c < 3; ++c)
      ground[c] =
          static_cast<unsigned>((above * top[c] + below * bottom[c] + image.height) / (2 * image.height));
    std::uint8_t* pixel = image.pixel(0, y);
    for (int x = 0; x < image.width; ++x, pixel += 4) {
      if (pixel[3] == 255) continue;
      const unsigned uncovered = 255u - pixel[3];
      for (std::size_t c = 0; c < 3; ++c)
        pixel[c] =
            static_cast<std::uint8_t>(std::min(255u, pixel[c] + (uncovered * ground[c] + 127u) / 255u));
      pixel[3] = 255;
    }
  }
}

}  // namespace hydroscope
