// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/increment/state.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// An immutable picture of an accepted state. `before` tells which nodes were in
/// contact at the last snapshot-worthy increment, to show what has just let go.
std::shared_ptr<const Snapshot> make_snapshot(const Model& model, const State& state,
                                              std::shared_ptr<const SnapshotModel> shared);

}  // namespace hydroscope
