// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "solver/increment/scratch.h"

namespace hydroscope {

/// One increment: predictor with the tangent of the last state, cut to what the
/// linearisation bears (r_min), then the corrector (extended ALGONEQ with the
/// tangent renewed, iterated to the tolerance), contact status, measures. `state`
/// is replaced only by an equilibrium that was reached; otherwise it stays and the
/// report says why the run ends. It does not go past `halt_time` [s].
IncrementReport advance(const Model& model, State& state, Scratch& scratch,
                        double halt_time = std::numeric_limits<double>::infinity());

}  // namespace hydroscope
