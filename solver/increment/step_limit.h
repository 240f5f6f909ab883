// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/scratch.h"

namespace hydroscope {

/// The largest fraction of a predicted increment for which the linearisation
/// holds, and what governs it (r_min, method section 8, mechanics 5).
struct StepLimit {
  double fraction = 1.0;
  Limiter limiter = Limiter::kTimePath;
  int at = -1;  ///< node or element

  void reduce(double r, Limiter by, int where) {
    if (r < fraction) {
      fraction = r;
      limiter = by;
      at = where;
    }
  }
};

/// Limits from the displacements alone: rotation of fibres (r3), free nodes that
/// would go through a tool by more than allowed (r4, events clustered by the
/// allowance), sliding past facets (r4b).
StepLimit calc_step_limit(const Model& model, const Vector& q, const Trial& trial);

/// Does the scene end increments at this event?
bool stops_at(const Model& model, const char* event);

/// Limits by contacts that would be pulled (r5) and sticking ones that would leave the slip circle (r6), from
/// the forces that the prediction `q` leads to; each may be overrun by the scene's `cluster`.
void limit_by_contact_events(const Model& model, const State& state, const Vector& q, const Scratch& scratch,
                             StepLimit& limit);

/// Reduction by the strain increment measured after the move (r2); 1 when within the limit.
double calc_strain_fraction(const Model& model, const Trial& trial);

}  // namespace hydroscope
