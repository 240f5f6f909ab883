// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/server/query.h"
#include "render/live/live_view.h"

namespace hydroscope {

constexpr int kAnyBranch = -1;

/// Which state a request asks for.
struct StateKey {
  int branch = 0, increment = 0;
  bool operator==(const StateKey&) const = default;
};

/// "live" or absent: none; "B.I": increment I of branch B. Throws InputError.
std::optional<StateKey> read_state_key(const Query& query, const std::string& name);

/// Names of the parameters that make_live_view() reads.
const std::vector<std::string>& live_view_parameters();

/// Absent parameters keep LiveView's own values. Throws InputError naming the parameter, or the field out of
/// its range (check_live_view()).
LiveView make_live_view(const Query& query);

}  // namespace hydroscope
