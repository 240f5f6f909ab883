// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "render/draw_list.h"
#include "render/image/colour_map.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// Names of all views, for help and checks.
const std::vector<std::string>& view_names();

/// Views of how contact ends: detachment, chatter, release-margin.
bool is_view_of_detachment(const std::string& view);

/// Modelled nodes (not their mirror images) by class.
struct ClassCounts {
  std::array<int, kContactClasses> nodes{};
};
ClassCounts count_classes(const Snapshot& snapshot);

/// The ranges a view needs ("slip" needs "slip" and "slip-increment"); none for class views.
std::vector<std::string> range_names(const std::string& view);

/// Smallest and largest value over one snapshot (NaN left out); low > high if there is none.
Range calc_range(const std::string& name, const Snapshot& snapshot);

/// Nodes where a scalar view's field is not a number.
int count_without_value(const std::string& view, const Snapshot& snapshot);

/// Widened to round numbers, never empty; what a legend shows.
Range calc_round_range(const Range& range);

/// The nodal field of a scalar view; age [s] of the view of detachment. Throws InputError when the view has
/// none.
std::vector<double> calc_field(const std::string& view, const Snapshot& snapshot);

}  // namespace hydroscope
