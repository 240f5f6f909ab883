// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "render/image/pixel_box.h"

namespace hydroscope {

/// A label that wants to stand near its point.
struct LabelWish {
  double x = 0.0, y = 0.0;    ///< the point [px]
  int width = 0, height = 0;  ///< of the label [px]
  double clearance = 8.0;     ///< half the size of the point's marker [px]
};

struct PlacedLabel {
  PixelBox box;
  bool has_room = false;  ///< free of other labels, points and the edge
  bool is_far = false;    ///< far enough from its point to need a line to it
};

/// Finds a place for each label inside `bounds`: beside, above or below its point, then
/// further out; never over `obstacles` (markers) or another label, and rather not over
/// `lines` (points along them). Labels in crowded places choose first. The same input
/// gives the same places.
std::vector<PlacedLabel> place_labels(const std::vector<LabelWish>& wishes, const PixelBox& bounds,
                                      const std::vector<PixelBox>& obstacles,
                                      const std::vector<std::array<double, 2>>& lines = {});

}  // namespace hydroscope
