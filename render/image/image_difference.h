// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "render/image/image.h"
#include "render/image/pixel_box.h"

namespace hydroscope {

/// What two pictures of one size have in common. Boxes that are left out (lettering in
/// another font) count as equal. All of these throw ContractError for pictures of two sizes.

/// Pixels one by one: for pictures of the same renderer.
struct PixelDifference {
  int compared = 0;        ///< pixels
  int off = 0;             ///< pixels of which a channel differs by more than `levels`
  int largest = 0;         ///< greatest difference of a channel
  bool has_block = false;  ///< four pixels in a square are off
  int x = 0, y = 0;        ///< first pixel of the block; else the one with the greatest difference

  double share() const { return compared > 0 ? static_cast<double>(off) / compared : 0.0; }
};
PixelDifference calc_pixel_difference(const Image& expected, const Image& got, int levels,
                                      const std::vector<PixelBox>& left_out = {});

/// Likeness of structure, for pictures of two renderers: in windows of kWindow x kWindow
/// pixels, a quarter of that apart, the similarity of Wang, Bovik, Sheikh and Simoncelli
/// (2004): 1 = equal, 0 = nothing in common, below = opposite. Mean values, contrasts and
/// pattern of each channel count; the worst window of the worst channel decides, so that
/// a change of a few pixels is not averaged away by a large picture.
struct StructureDifference {
  double worst = 1.0;
  int x = 0, y = 0;  ///< first pixel of the worst window
};
constexpr int kWindow = 8;
StructureDifference calc_structure_difference(const Image& expected, const Image& got,
                                              const std::vector<PixelBox>& left_out = {});

/// Difference of each channel times `factor`, over a faint picture of what was expected.
Image make_difference_picture(const Image& expected, const Image& got, int factor = 8);

/// Whether nothing was drawn: outside of the boxes each row of pixels is of one colour.
bool is_blank(const Image& image, const std::vector<PixelBox>& left_out = {});

}  // namespace hydroscope
