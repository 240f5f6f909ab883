// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "render/live/live_view.h"
#include "render/shape/sheet_shape.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// Box that the camera and the clip plane's slider refer to: the first snapshot's sheet, as drawn, and the
/// tools near it [mm]. It stays as it is during a run, so that the same view is always the same camera.
Bounds calc_live_bounds(const Snapshot& first, bool is_mirrored);

/// Parallel projection. Unlike in sequences the scale does not depend on the direction: the part keeps its
/// size while it is turned, and zoom 1 holds it from the usual directions.
CameraPose calc_live_camera(const LiveView& view, const Bounds& bounds);

/// What lies on the side of its normal is not drawn.
std::optional<Plane> calc_clip_plane(const LiveView& view, const Bounds& bounds);

/// Takes away the tools' half towards the viewer: the coordinate plane through the middle that faces the
/// viewer most, so that it stays where it is while the part is turned a little.
Plane calc_live_cut(const CameraPose& camera, const Bounds& bounds);

/// Where a place is seen: pixels from the top left corner to the right and down, and the distance from the
/// middle plane towards the viewer [mm].
struct Projection {
  Projection(const LiveView& view, const CameraPose& camera);

  Vec3 project(const Vec3& x) const {
    const Vec3 d = x - focal;
    return {0.5 * width + d.dot(right) / pixel, 0.5 * height - d.dot(upright) / pixel, d.dot(direction)};
  }
  Vec3 place(double x, double y, double depth) const {
    return focal + pixel * ((x - 0.5 * width) * right - (y - 0.5 * height) * upright) + depth * direction;
  }

  Vec3 focal, right, upright, direction;  ///< `direction` towards the viewer
  double width, height;                   ///< [px]
  double pixel;                           ///< [mm]
};

}  // namespace hydroscope
