// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/increment/state.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// An immutable picture of an accepted state. A tool that has been taken away
/// has no translation (NaN); nodes that let go in the state's increment are told from the free ones.
/// `times`: process time of each increment up to the state's [s], from 0; without it no node has let go.
std::shared_ptr<const Snapshot> make_snapshot(const Model& model, const State& state,
                                              std::shared_ptr<const SnapshotModel> shared,
                                              const std::vector<double>& times = {});

}  // namespace hydroscope
