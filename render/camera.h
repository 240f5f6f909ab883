// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/frame_options.h"

namespace hydroscope {

/// Unit vector towards the viewer; angles in degrees as in FrameOptions.
Vec3 calc_direction(double azimuth, double elevation);

/// The camera of frame `index` of `expected` frames. Looks at the middle of
/// `bounds` from a direction, with a scale that holds the box from every
/// direction of an orbit and leaves room for title and legend. `look_at` = the place of the followed node.
CameraPose calc_camera(const FrameOptions& options, const Bounds& bounds, const std::optional<Vec3>& look_at,
                       int index, int expected);

/// The plane that takes away the viewer's half of the tools: through the middle
/// of `bounds`, upright or level along the nearest coordinate direction, so that the cut
/// falls on the usual planes of symmetry; while orbiting it turns with the camera.
Plane calc_cut(const FrameOptions& options, const CameraPose& camera, const Bounds& bounds);

/// Throws InputError for a value out of range.
void check_camera(const FrameOptions& options, int nodes);

}  // namespace hydroscope
