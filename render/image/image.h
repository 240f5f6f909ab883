// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hydroscope {

/// Colour, 0..255 a channel, red first.
using Rgb = std::array<std::uint8_t, 3>;

/// Picture of 8-bit RGBA pixels; row 0 is the top one.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< width * height * 4

  std::uint8_t* pixel(int x, int y) { return rgba.data() + offset(x, y); }
  const std::uint8_t* pixel(int x, int y) const { return rgba.data() + offset(x, y); }

  bool operator==(const Image&) const = default;

 private:
  std::size_t offset(int x, int y) const {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
};

Image make_image(int width, int height, Rgb colour);

/// Turns a picture that was drawn `factor` times too large in each direction
/// and read from below (as OpenGL does) into one of width x height: the mean
/// of factor x factor pixels makes its edges smooth.
Image reduced(const std::uint8_t* rows_from_below, int width, int height, int factor);

/// Lays a picture whose colours are weighted by its alpha (drawn on black,
/// alpha 0) on a ground that runs from one colour to the other. Alpha becomes 255.
void lay_on_ground(Image& image, Rgb top, Rgb bottom);

}  // namespace hydroscope
