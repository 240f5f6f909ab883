// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/image.h"

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

Image reduced(const std::uint8_t* rows_from_below, int width, int height, int factor) {
  require(factor >= 1 && factor <= 8, "reduction factor between 1 and 8");
  Image image = make_image(width, height, {0, 0, 0});
  const auto source_row = 4u * static_cast<std::size_t>(width) * static_cast<std::size_t>(factor);
  const unsigned weight = static_cast<unsigned>(factor * factor);
  std::vector<unsigned> sums(4u * static_cast<std::size_t>(width));
  for (int y = 0; y < height; ++y) {
    sums.assign(sums.size(), weight / 2);
    const auto first = static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(factor);
    for (std::size_t row = first; row < first + static_cast<std::size_t>(factor); ++row) {
      const std::uint8_t* source = rows_from_below + row * source_row;
      for (std::size_t x = 0; x < sums.size(); x += 4)
        for (int k = 0; k < factor; ++k, source += 4)
          for (std::size_t c = 0; c < 3; ++c) sums[x + c] += source[c];
    }
    std::uint8_t* target = image.pixel(0, y);
    for (std::size_t x = 0; x < sums.size(); x += 4)
      for (std::size_t c = 0; c < 3; ++c) target[x + c] = static_cast<std::uint8_t>(sums[x + c] / weight);
  }
  return image;
}

}  // namespace hydroscope
