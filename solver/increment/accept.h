// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/attempt.h"

namespace hydroscope {

/// Turns the converged trial into the state: positions, stresses, contact
/// status with its events, smoothed contact pressure, and fills the report.
void accept(const Model& model, const Attempt& attempt, State& state, Scratch& scratch,
            IncrementReport& report);

}  // namespace hydroscope
