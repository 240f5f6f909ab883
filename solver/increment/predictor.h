// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/attempt.h"
#include "solver/increment/equations.h"

namespace hydroscope {

/// One try at an increment in progress: its forward step, and what corrections need of it.
class Predictor {
 public:
  Predictor(const Model& model, const State& state, const Target& target, Scratch& scratch);

 protected:
  /// Solves for the whole increment and takes as much of it as the limits allow; false when the
  /// attempt has ended. `behind` [N] is taken off the out-of-balance force that drives it.
  bool predict(const Vector* behind = nullptr);
  /// Forces, contacts and residual of the trial as the prediction has moved it.
  void evaluate_prediction();
  bool factorise_or_fail();
  double calc_volume_gap() const;
  /// Half the difference between the trial and where `x` says the nodes are, against the error that is
  /// allowed: above 1 is too much.
  double calc_error(const std::vector<Vec3>& x) const;

  const Model& model_;
  const State& state_;
  Target target_;
  Scratch& s_;
  Attempt attempt_;
  Step step_;                      ///< that the prediction was solved for
  Solution prediction_;            ///< of the whole increment
  std::vector<Vec3> predicted_x_;  ///< positions that it led to; with control of the error only
  double strain_ = 0.0;            ///< largest strain increment of the trial [-]
  bool touches_ = false;           ///< something touched in the last state

 private:
  Step make_prediction_step() const;
  Solution solve_with_thinning();
  void take_prediction();

  const Vector* behind_ = nullptr;
  static constexpr int kLargestStrainCuts = 3;
  static constexpr double kWholeShare = 0.9;  // points that yield later than this are let through
};

/// The part of the way from the state to the target.
Target interpolate(const State& state, const Target& target, double r);

/// Keeps a correction from turning fibres head over heels.
void limit_correction(Solution& solution);

}  // namespace hydroscope
