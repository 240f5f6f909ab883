// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// Writes one snapshot as `path` (.vtp). Throws EnvironmentError.
void write_state(const Snapshot& snapshot, const std::filesystem::path& path);

/// Reads it back bit for bit, as a state of `model`. Throws InputError.
std::shared_ptr<const Snapshot> read_state(const std::filesystem::path& path,
                                           const std::shared_ptr<const SnapshotModel>& model);

/// Writes what all states share: `model.json` and `tools/NAME.vtp` in `folder`.
void write_model(const SnapshotModel& model, const std::filesystem::path& folder);

/// Reads it back; the quadrilaterals come from the state file `any_state`. Throws InputError.
std::shared_ptr<const SnapshotModel> read_model(const std::filesystem::path& folder,
                                                const std::filesystem::path& any_state);

}  // namespace hydroscope
