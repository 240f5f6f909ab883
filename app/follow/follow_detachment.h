// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/follow/patch_story.h"
#include "app/results/result_folder.h"
#include "render/frame_options.h"

namespace hydroscope {

/// How patches of detachment are shown, from a run's saved states.
struct FollowOptions {
  FrameOptions frames;       ///< size of the whole frame, theme, opacity of tools, zoom; one view
  std::vector<int> patches;  ///< from 1; empty: the kMostPatches largest
  std::vector<int> nodes;    ///< in the charts; empty: the most pulled one of each patch
  int around = 3;            ///< states before, and after
  std::function<void(int, int)> on_progress{};  ///< (frames done, of)
  std::function<bool()> is_stopped{};           ///< asked between frames
};

constexpr int kMostPatches = 20;
constexpr int kMostNodes = 7;  ///< colours of the charts without that of the release line

/// What has been drawn of one patch.
struct FollowedPatch {
  int patch = 0;       ///< from 1
  std::string folder;  ///< of its frames
  int frames = 0;
};

/// Which patches are drawn. Throws InputError, that starts with `name` of the run: nothing let go, or there
/// is no such patch or node.
std::vector<int> choose_patches(const Ledger& ledger, const FollowOptions& options, const std::string& name);

/// Draws frames/detachment-PATCH/00001.png ... with their sidecars: a close-up (see aim_at_patch()) beside
/// charts (see make_patch_charts()). Earlier frames of this kind are removed. Throws EnvironmentError.
std::vector<FollowedPatch> follow_detachment(const ResultFolder& folder, const Ledger& ledger,
                                             const FollowOptions& options);

}  // namespace hydroscope
