// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/explicit_step.h"

#include <algorithm>
#include <cmath>

#include "solver/increment/contact_step.h"
#include "solver/increment/predictor.h"
#include "solver/increment/release.h"

namespace hydroscope {

namespace {

constexpr double kDivergence = 1e10;  // residual at which an increment is given up
constexpr int kErrorCuts = 4;         // of one increment by the embedded pair

class ExplicitStep : private Predictor {
 public:
  using Predictor::Predictor;

  Attempt run() {
    const Vector behind = (1.0 - calc_carried_share()) * state_.unbalanced;
    if (!predict(&behind)) return attempt_;
    if (model_.controls_error && !take_modified_euler()) return attempt_;
    if (model_.correction == Correction::kAlgoneq) {
      for (int pass = 0; pass < model_.increment.algoneq_passes; ++pass) {
        if (!solve_unbalanced()) return attempt_;
      }
    }
    finish();
    return attempt_;
  }

 private:
  /// Part of the out-of-balance force that goes into this increment.
  double calc_carried_share() const {
    return model_.correction == Correction::kOneStepBehind ? 1.0 / model_.increment.r_safe : 0.0;
  }

  /// The second stage: the same forces with the stiffness of where the first has led; then the mean of both.
  /// Shortens the increment until half their difference is small enough.
  bool take_modified_euler() {
    const Target start = target_;
    const double r0 = std::min(1.0, attempt_.limit.fraction);
    double r = 1.0;  // of what the other limits let through
    for (int cut = 0;; ++cut) {
      evaluate_elements(model_, state_, attempt_.loads, {.with_stiffness = true}, s_);
      if (!factorise_or_fail()) return false;
      const double share = r * r0;
      const Step step{share * step_.force, share * step_.prescribed};
      const double gap = share * (start.volume - state_.volume) / r0;
      const Solution second = solve(model_, attempt_.loads, step, target_.use_volume, gap, s_);
      const std::vector<Vec3> first_x = s_.trial.configuration.x;
      const double first_pressure = attempt_.loads.pressure;
      s_.trial.configuration = state_.configuration;
      move(s_.trial.configuration, 0.5 * (share * prediction_.q + second.q));
      attempt_.error = calc_error(first_x);
      if (attempt_.error <= 1.0 || cut == kErrorCuts) {
        if (target_.use_volume) {
          attempt_.loads.pressure = 0.5 * (first_pressure + state_.pressure + second.pressure_change);
        }
        evaluate_prediction();
        attempt_.error = std::min(attempt_.error, 1.0);
        return true;
      }
      r *= std::clamp(0.9 / std::sqrt(attempt_.error), 0.1, 0.7);
      attempt_.limit.reduce(r * r0, Limiter::kError, -1);
      target_ = interpolate(state_, start, r);
      attempt_.loads = {target_.time, target_.use_volume
                                          ? state_.pressure + r * r0 * prediction_.pressure_change
                                          : target_.pressure};
      s_.trial.configuration = state_.configuration;
      move(s_.trial.configuration, r * r0 * prediction_.q);
      evaluate_prediction();
    }
  }

  /// K q = f_neq with the loads held, by as much as the limits allow (4.27).
  bool solve_unbalanced() {
    evaluate_elements(model_, state_, attempt_.loads, {.with_stiffness = true}, s_);
    if (!factorise_or_fail()) return false;
    Solution solution = solve(model_, attempt_.loads, target_.use_volume, calc_volume_gap(), s_);
    limit_correction(solution);
    const double r = std::min(1.0, calc_step_limit(model_, solution.q, s_.trial).fraction);
    const Configuration before = s_.trial.configuration;
    const double pressure = attempt_.loads.pressure, strain = strain_;
    const double bound = 2.0 * std::max(model_.increment.max_strain, strain);
    for (double share = r;; share *= 0.5) {
      s_.trial.configuration = before;
      move(s_.trial.configuration, share * solution.q);
      attempt_.loads.pressure = pressure + share * solution.pressure_change;
      evaluate_prediction();
      if (s_.trial.strain_increment <= bound || share < 0.1 * r || model_.increment.max_strain <= 0.0) break;
    }
    ++attempt_.iterations;
    return true;
  }

  /// Friction for the next increment, what is left behind, and who touches or lets go.
  void finish() {
    renew_friction(model_, s_);
    attempt_.residual = calc_imbalance(model_, attempt_.loads, s_).residual;
    attempt_.volume = calc_volume(model_, state_, s_);
    if (!std::isfinite(attempt_.residual) || attempt_.residual > kDivergence) {
      attempt_.end = Attempt::End::kDiverged;
      return;
    }
    attempt_.unbalanced = calc_unbalanced(attempt_.loads, s_);
    update_contact_set(model_, state_, attempt_.loads, true, s_);
    if (model_.release != ReleaseRule::kFull) release_by_sign(model_, attempt_.loads, s_.bases, s_.trial);
    attempt_.end = Attempt::End::kConverged;
  }
};

}  // namespace

Attempt try_explicit_step(const Model& model, const State& state, const Target& target, Scratch& scratch) {
  return ExplicitStep(model, state, target, scratch).run();
}

}  // namespace hydroscope
