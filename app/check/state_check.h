// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

#include "app/check/baseline.h"
#include "app/check/finding.h"

namespace hydroscope {

/// Runs while states are checked: true ends it early.
using StopRequest = std::function<bool()>;

/// Draws the states as the baseline was drawn and compares: sequence, values, balance, classes,
/// pixels. Throws InputError for a damaged baseline or state, EnvironmentError when nothing
/// can be drawn.
CheckReport check_states(const StateSequence& states, const std::filesystem::path& baseline_folder,
                         int rasteriser_threads, const StopRequest& is_stopped = {});

/// Makes or renews a baseline from the states, with at most `most_pictures` pictures a view.
/// Returns it as written.
Baseline renew_baseline(const StateSequence& states, const FrameOptions& options, int most_pictures,
                        const std::filesystem::path& baseline_folder);

}  // namespace hydroscope
