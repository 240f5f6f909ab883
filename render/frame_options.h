// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "render/draw_list.h"
#include "render/shape/sheet_shape.h"

namespace hydroscope {

/// How a sequence of frames is drawn. Defaults are those of the scene file's [frames].
struct FrameOptions {
  /// From view_names(); an unknown name is an InputError.
  std::vector<std::string> views{"contact-map", "tool-normals", "slip"};
  std::array<int, 2> size{1280, 720};  ///< [px]
  int smoothing = 2;                   ///< edges: drawn larger by this factor (1..4), then averaged
  std::string theme = "light";         ///< light | dark
  std::string camera = "fixed";        ///< fixed | orbit | look-at
  double azimuth = 35.0;               ///< [deg] around the vertical (y), 0 = from +x, 90 = from +z
  double elevation = 25.0;             ///< [deg] above the horizontal
  double zoom = 1.0;                   ///< > 1 = closer; 1 = everything in the picture
  double orbit = 360.0;                ///< [deg] turned over the expected frames
  int look_at_node = -1;               ///< camera = look-at: this node stays in the middle
  bool is_mirrored = true;             ///< show the whole part
  bool facet_normals = false;          ///< tool-normals: also the facets' own normals
  bool element_edges = false;          ///< edges of all elements
  /// Squares of two by two elements of one class are drawn as one: for elements of a few pixels.
  bool is_coarse = false;
  double tool_opacity = 0.35;
  bool is_tool_cut = true;    ///< take away the half of the tools on the viewer's side
  bool feature_edges = true;  ///< open and sharp edges of the tools
  int most_arrows = 2000;     ///< in one picture, over the whole part
  double arrow_scale = 1.0;   ///< of the arrows' usual length
  /// Fixed ranges by view: "thickness", "plastic-strain", "contact-pressure",
  /// "gap", "slip" (accumulated, from 0) and "slip-increment" [in the field's unit].
  /// A scalar view whose range is given here is drawn while the run goes on; otherwise
  /// its frames are drawn at the end, over the range of all snapshots.
  std::map<std::string, Range> ranges;
  /// What the camera must hold [mm]; absent: the first snapshot, the tools near it, and the sheet
  /// where it leaves these.
  std::optional<Bounds> bounds;
  /// Box of the sheet over the whole sequence [mm], where it is known from the start: so that the camera
  /// holds it from the first frame on.
  std::optional<Bounds> later_sheet;
  /// A camera and a cut of the tools that are set, not found: for close-ups.
  std::optional<CameraPose> pose;
  std::optional<Plane> cut;
  /// Flat class or map colours: no light, text, ground or smooth edges, so that
  /// pixels can be counted by colour.
  bool is_flat = false;
  /// llvmpipe's own threads; the first picture of the process decides.
  int rasteriser_threads = 1;
  std::string animation = "webp";  ///< none | webp | mp4
  double frames_per_second = 20.0;
  int queue_capacity = 4;  ///< snapshots that may wait to be drawn before the producer does
  /// Without it, a view's folder that holds frames already is an InputError;
  /// with it those frames are deleted first.
  bool replace = false;
  /// Called on the finishing thread as deferred frames and animations are done: (done, of).
  std::function<void(int, int)> on_progress;
};

}  // namespace hydroscope
