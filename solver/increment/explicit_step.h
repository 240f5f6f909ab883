// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/attempt.h"

namespace hydroscope {

/// An increment of the source's kind: the forward step alone, with what is out of balance left behind,
/// carried over to the next increment (4.23)-(4.26), or solved for by itself (4.27). Nothing is iterated to a
/// tolerance; contacts come and go at its end. With control of the error the forward Euler step is paired
/// with a modified Euler one (Abbo & Sloan 1996), which is taken.
Attempt try_explicit_step(const Model& model, const State& state, const Target& target, Scratch& scratch);

}  // namespace hydroscope
