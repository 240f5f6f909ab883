// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "render/frame_options.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// Axes at a patch, unit and at right angles: `outward` from the sheet to the tool, `along` the direction in
/// which the sheet bends least (a tube's axis), turned towards the viewer's usual side, `across` the third.
struct PatchAxes {
  Vec3 outward = Vec3::UnitY(), along = Vec3::UnitZ(), across = Vec3::UnitX();
};

/// From the patch while it still touched. Where its normals cancel (a ring), those at `node` count.
PatchAxes find_patch_axes(const Snapshot& before, const std::vector<int>& nodes, int node,
                          const Vec3& towards_viewer);

/// How a patch is shown: from slightly above the tangent plane, looking along the sheet, with the tool above
/// it cut in two at the patch's middle, so that the gap is seen as it opens.
struct CloseUp {
  CameraPose pose;
  Plane cut;
  Bounds bounds;  ///< of the patch [mm]
};

/// Holds all nodes of the patch in a picture of this aspect (width / height); `zoom` > 1 comes
/// closer, and then `node` is in the middle.
CloseUp aim_at_patch(const Snapshot& before, const std::vector<int>& nodes, int node, const PatchAxes& axes,
                     double aspect, double zoom);

/// The same nodes with the elements near the patch alone: no wall stands before it.
std::shared_ptr<const SnapshotModel> crop_to_patch(const Snapshot& before, const std::vector<int>& nodes,
                                                   const PatchAxes& axes, const CloseUp& close_up,
                                                   double aspect);

}  // namespace hydroscope
