// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/step_limit.h"

namespace hydroscope {

/// What an increment is to reach.
struct Target {
  double time = 0.0;            ///< process time at its end [s]
  bool use_volume = false;      ///< the enclosed volume is prescribed, the pressure follows
  double pressure = 0.0;        ///< [MPa] at the end (pressure control) or first guess
  double volume = 0.0;          ///< [mm^3] at the end (volume control)
  bool renews_friction = true;  ///< bounds of friction are brought up to the normal forces in the end
  int patience = 1;             ///< as many times the passes that are allowed
  double tightness = 1.0;       ///< share of the tolerance that is allowed
  bool is_turning = false;      ///< a path has just had a corner: points need not flow on
};

/// Outcome of one try at an increment; the trial in `scratch` holds its end.
struct Attempt {
  enum class End { kConverged, kDiverged, kTooManyIterations, kSingular, kUnstable };
  End end = End::kDiverged;
  Loads loads;          ///< reached
  double volume = 0.0;  ///< reached [mm^3]
  StepLimit limit;      ///< of the predictor
  double residual = 0.0;
  int iterations = 0;       ///< passes, the prediction among them
  int factorisations = 0;   ///< the prediction's and the corrector's
  int negative_pivots = 0;  ///< of the predictor's matrix: the last state's, under the pressure aimed at
  double compliance = 0.0;  ///< g . K^-1 g of the predictor when it was unstable
  double error = 0.0;       ///< of the embedded pair against the one allowed; with control of the error
  Vector unbalanced;        ///< out-of-balance force left behind [N]; of an explicit step
};

/// Predictor and corrector from `state` to `target` (or to the part of it that r_min allows).
Attempt try_increment(const Model& model, const State& state, const Target& target, Scratch& scratch);

}  // namespace hydroscope
