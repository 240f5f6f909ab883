// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/inspect/ledger.h"
#include "app/results/json.h"

namespace hydroscope {

// Flat records with the same keys for every episode, patch or line of a life: what
// JSON and CSV show. Keys carry units; what is not known is null or an empty cell.

Json::Object make_episode_record(const Ledger& ledger, const Episode& episode);
Json::Object make_patch_record(const Ledger& ledger, const Patch& patch);

/// One event or saved state of a node.
struct LifeLine {
  int increment = 0;
  std::optional<std::size_t> event;    ///< index into the log; none: a saved state
  std::optional<std::size_t> state;    ///< index into the sheet's states
  std::optional<std::size_t> episode;  ///< for a letting go: whose
};

/// All events of a node and all saved states, in order of increments; a state comes after the events of its
/// own.
std::vector<LifeLine> make_life(const Ledger& ledger, int node);
Json::Object make_life_record(const Ledger& ledger, int node, const LifeLine& line);

/// Head and rows; `keys` is a record of which only the keys count.
std::string make_csv(const Json::Object& keys, const std::vector<Json::Object>& records);

}  // namespace hydroscope
