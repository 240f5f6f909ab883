// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/increment/scratch.h"

namespace hydroscope {

/// Value of a declared quantity in an accepted state; `before` holds the values
/// of the quantities declared earlier (sum and ratio refer to them).
double evaluate_quantity(const Model& model, const State& state, const Quantity& quantity,
                         const std::vector<double>& before);

/// Tells physics from failure (method section 8): marks a wall past its force
/// maximum (Considère in plane strain, H = sqrt(3)/2 sigma; for Swift a hoop strain of
/// n - sqrt(3)/2 eps0), localisation, thickness and strain limits, more negative
/// pivots than a pressure maximum explains. A wall that sticks to a tool is not judged.
void judge(const Model& model, const Scratch& scratch, State& state, IncrementReport& report);

/// Has the run been marked as necking?
bool has_necked(const State& state);

}  // namespace hydroscope
