// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/draw_list.h"

namespace hydroscope {

/// What one viewer wants to see, complete in itself: the same view of the same state is the same picture.
struct LiveView {
  std::string view = "contact-map";  ///< from view_names()
  int width = 960, height = 540;     ///< [px]
  /// As in FrameOptions: 1 while dragging, 2 at rest. At 1, elements of less than 3 pixels are drawn four as
  /// one where they are of one class.
  int smoothing = 1;
  double azimuth = 35.0;    ///< [deg]
  double elevation = 25.0;  ///< [deg]
  double zoom = 1.0;        ///< > 1 = closer
  double pan_x = 0.0,
         pan_y = 0.0;           ///< of the picture's middle, right and up, in heights of the unzoomed picture
  std::optional<Vec3> focus;    ///< looked at instead of the middle of the part [mm] (fly to a place)
  int clip_axis = -1;           ///< 0 x, 1 y, 2 z; -1: none. Cuts sheet, tools and glyphs
  double clip_share = 0.5;      ///< where along calc_live_bounds(), 0..1; what lies beyond is taken away
  bool clip_flip = false;       ///< keep what lies beyond
  double tool_opacity = 0.35;   ///< 0: not drawn; the view tool-normals shows them opaque
  bool is_tool_cut = true;      ///< the tools' half towards the viewer is left out
  bool is_mirrored = true;      ///< show the whole part
  bool element_edges = false;   ///< of the deformed mesh
  bool feature_edges = true;    ///< of tools
  double glyph_density = 1.0;   ///< share of the usual number of arrows, 0..4
  double glyph_scale = 1.0;     ///< of their usual length
  std::optional<Range> range;   ///< locked; absent: the snapshot's own, rounded
  std::string theme = "light";  ///< light | dark
  bool has_text = true;         ///< legend, title and time
  double text_scale = 1.0;      ///< of the letters' usual size, which is readable down to 480 x 270; pictures
                                ///< below 240 x 135 have none
  /// Nodes with a ring around them and around their mirror images, on the face that is turned to the viewer.
  std::vector<int> marked;

  bool operator==(const LiveView&) const = default;
};

/// Throws InputError naming the field out of its range, and what is allowed.
void check_live_view(const LiveView& view);

}  // namespace hydroscope
