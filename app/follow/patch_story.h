// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/inspect/ledger.h"
#include "render/chart/line_chart.h"

namespace hydroscope {

/// Which saved states tell of a patch: before, at (from its first letting go to the first state after its
/// last) and after.
enum class Phase { kBefore, kAt, kAfter };
const char* to_string(Phase phase);
struct PatchFrame {
  std::size_t state = 0;  ///< index into the ledger's states
  Phase phase = Phase::kBefore;
};

/// At most `around` states before and `around` after. A run that ended in the increment of its letting go has
/// none after it.
std::vector<PatchFrame> find_patch_frames(const Ledger& ledger, const Patch& patch, int around);

/// The patch's nodes, each once, rising.
std::vector<int> find_patch_nodes(const Ledger& ledger, const Patch& patch);

/// The node that was pulled most: by its force when it let go, where that is known, else by the one before,
/// against its fluid share where there is one; of equal ones the first.
int find_most_pulled(const Ledger& ledger, const Patch& patch);

/// What a node went through, from states and events; both may know a time.
struct NodeStory {
  int node = 0;
  std::vector<double> force_times, forces;       ///< [s], normal force [N]
  std::vector<double> gap_times, gaps;           ///< [s], [mm]; NaN: no tool is near
  std::vector<double> contact_times, pressures;  ///< [s], smoothed contact pressure [MPa]
};
NodeStory make_node_story(const Ledger& ledger, int node);

/// Of the line where a patch lets go; no node has it.
constexpr Rgb kReleaseLine{213, 94, 0};
Rgb find_node_colour(std::size_t index, const std::string& theme);

/// Charts of normal force, gap, contact pressure and fluid pressure over the run's time.
std::vector<LineChart> make_patch_charts(const Ledger& ledger, const std::vector<NodeStory>& stories,
                                         const std::string& theme = "light");

}  // namespace hydroscope
