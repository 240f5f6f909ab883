// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "render/image/image.h"
#include "render/live/live_view.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// A flat strip in z = 0, nodes at whole numbers: `columns` x `rows` quads of 1 mm, outer face towards +z.
struct FlatStrip {
  int columns = 4, rows = 2;
  double thickness = 0.2;  ///< [mm]
  std::vector<Plane> mirrors{};

  int node(int column, int row) const { return row * (columns + 1) + column; }
  std::shared_ptr<Snapshot> make() const;
};

/// Snapshot arrays of the right lengths for its points, directors and thickness.
void fill_fields(Snapshot& snapshot);

/// Looked at along -z, without text: x to the right, y up.
LiveView make_front_view(int width = 320, int height = 180);

/// Pixels of about this colour.
int count_colour(const Image& image, Rgb colour, int tolerance = 12);

/// Pixels that differ by more than `tolerance` in a channel.
int count_changed(const Image& a, const Image& b, int tolerance = 12);

}  // namespace hydroscope
