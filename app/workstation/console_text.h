// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/workstation/workstation.h"

namespace hydroscope {

/// What a terminal shows of an analysis; lines, each ended.
std::string describe_status(const WorkstationStatus& status);
std::string describe_kept(const std::vector<KeptState>& states);
std::string describe_warnings(const std::vector<Warning>& warnings);
/// The last `number` events.
std::string describe_events(const std::vector<ContactEvent>& events, const Snapshot& snapshot,
                            std::size_t number);
std::string describe_quantities(const Snapshot& snapshot);
/// Place, wall and contact of a node, with its margin to letting go. Throws InputError when there is none.
std::string describe_node(const Snapshot& snapshot, int node);

}  // namespace hydroscope
