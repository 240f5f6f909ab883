// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/image/colour_map.h"
#include "render/shape/surface.h"

namespace hydroscope {

/// Least and greatest value that a map or an arrow scale covers.
struct Range {
  double low = 0.0;
  double high = 0.0;
  bool operator==(const Range&) const = default;
};

/// A view as plain values: what stands where in which colour. The views make
/// it, the stage (VTK) and the overlay (text and legends) draw it. A shape that is the
/// same object as in the frame before is not sent to the renderer again.
struct SurfaceItem {
  std::shared_ptr<const Surface> surface;
  Rgb colour{255, 255, 255};           ///< where the surface has neither values nor colours
  const ColourTable* table = nullptr;  ///< for the surface's values
  Range range{};                       ///< of the values
  double opacity = 1.0;
  enum class Faces { kAll, kFront, kBack } faces = Faces::kAll;
  bool is_cut = false;     ///< by the draw list's cut
  bool is_clipped = true;  ///< by the draw list's clip plane
};

struct LineItem {
  std::shared_ptr<const LineSet> lines;
  Rgb colour{0, 0, 0};
  double width = 1.0;  ///< [px] of the finished picture of 720 rows
  double opacity = 1.0;
  bool is_cut = false;
  bool is_clipped = true;
};

struct Legend {
  std::string heading;  ///< what the view shows
  struct Swatch {
    Rgb colour;
    std::string label;
  };
  std::vector<Swatch> swatches;
  struct Bar {
    std::string title;  ///< quantity with its unit
    const ColourTable* table;
    Range range;
  };
  std::vector<Bar> bars;
  std::vector<std::string> notes;  ///< scale of arrows and the like
};

/// Parallel projection.
struct CameraPose {
  Vec3 position = Vec3::UnitZ();
  Vec3 focal = Vec3::Zero();
  Vec3 up = Vec3::UnitY();
  double scale = 1.0;  ///< half the height of the picture [mm]
};

struct DrawList {
  std::vector<SurfaceItem> surfaces;  ///< drawn in order: translucent ones last
  std::vector<LineItem> lines;
  std::optional<Plane> cut;   ///< cut items are drawn behind it, where its normal points away from
  std::optional<Plane> clip;  ///< nothing is drawn on the side of its normal
  Legend legend;
};

}  // namespace hydroscope
