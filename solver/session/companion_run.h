// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/session/run.h"

namespace hydroscope {

/// Runs the companion of a chosen scene and sets `summary.estimate`; adds a warning where it exceeds what was
/// asked for, and where there is none.
void add_estimate(const Scene& chosen, const RunOptions& options, const QuantityHistory& history,
                  RunSummary& summary);

/// A line a quantity, in words.
std::string describe_estimate(const ErrorEstimate& estimate, double accuracy);

}  // namespace hydroscope
