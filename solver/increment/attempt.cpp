// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/attempt.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/increment/contact_step.h"
#include "solver/increment/explicit_step.h"
#include "solver/increment/predictor.h"
#include "solver/increment/release.h"
#include "solver/increment/work_search.h"

namespace hydroscope {

namespace {

constexpr double kReleaseResidual = 0.02;  // reactions are trusted for letting go below this imbalance
constexpr int kReleasePasses = 5;
constexpr double kVolumeTolerance = 1e-8;  // of the enclosed volume
// The tangent knows neither that the wall thins nor that friction follows the normal force; near a
// limit point that alone keeps the corrector from settling. The thickness stands still from the first
// correction on, the bounds of friction after these passes: what they still lack is of the size of the last
// correction. Both are renewed before the increment is accepted, the bounds of friction a few times only.
constexpr int kSettlingPasses = 2;
constexpr double kSettledResidual = 0.1;
constexpr int kThicknessPasses = 6;
constexpr int kFrictionPasses = 3;
constexpr int kLargestCuts = 6;          // of one correction
constexpr double kDivergence = 1e10;     // residual at which an increment is given up
constexpr double kReuseResidual = 0.03;  // below it the last factor is kept as long as it serves
constexpr double kFarResidual = 0.1;     // from above it one correction seldom leads below
constexpr int kSlowPasses = 3;           // with a kept factor before it is renewed
constexpr int kLargestSecant = 10;
constexpr int kLargestSprings = 12;  // that came or went since the last factorisation

/// Iterates the out-of-balance force away.
class Corrector : private Predictor {
 public:
  using Predictor::Predictor;

  Attempt run() {
    for (const Tool& tool : model_.tools) has_friction_ = has_friction_ || tool.friction > 0.0;
    if (!predict()) return attempt_;
    for (int k = 1; k <= target_.patience * model_.increment.max_iterations; ++k) {
      attempt_.iterations = k;
      if (k > 1) search_along();
      if (is_done()) return attempt_;
      if (!std::isfinite(attempt_.residual) || attempt_.residual > kDivergence) {
        attempt_.end = Attempt::End::kDiverged;
        return attempt_;
      }
      if (!correct()) return attempt_;
    }
    attempt_.end = Attempt::End::kTooManyIterations;
    return attempt_;
  }

 private:
  bool has_springs() const { return model_.contact.wall_stiffness > 0.0; }

  /// Element matrices come along where the correction that led here started so far off that a new
  /// factor will be wanted.
  void evaluate_trial() {
    has_stiffness_ = attempt_.iterations > 1 && last_residual_ > kFarResidual;
    evaluate(model_, state_, attempt_.loads,
             {.freeze_thickness = attempt_.iterations > 1, .with_stiffness = has_stiffness_}, s_);
    evaluate_contacts(model_, state_, attempt_.loads, is_settled_, s_);
    attempt_.residual = calc_imbalance(model_, attempt_.loads, s_).residual;
  }

  /// Takes the correction, or as much of it as brings its work down and does not strain by more than two
  /// increments; then lets the factor learn from the step.
  void search_along() {
    const Configuration base = s_.trial.configuration;
    const double base_pressure = attempt_.loads.pressure;
    const double strain_bound = model_.increment.max_strain > 0.0
                                    ? 2.0 * std::max(model_.increment.max_strain, strain_)
                                    : std::numeric_limits<double>::infinity();
    WorkSearch search(correction_.work);
    double scale = 1.0;
    for (int cut = 0;; ++cut) {
      scale = search.scale();
      s_.trial.configuration = base;
      move(s_.trial.configuration, scale * correction_.q);
      attempt_.loads.pressure = base_pressure + scale * correction_.pressure_change;
      evaluate_trial();
      if (cut == kLargestCuts || attempt_.residual <= model_.increment.tolerance) break;
      const double strain = s_.trial.strain_increment;
      if (strain > strain_bound) {
        search.shorten(std::clamp((strain_bound - strain_) / (strain - strain_), 0.1, 0.7));
      } else if (search.accepts(calc_work(attempt_.loads, correction_.q, s_))) {
        break;
      }
    }
    strain_ = s_.trial.strain_increment;
    if (!s_.solver.is_unsymmetric()) learn_step(correction_, scale, attempt_.loads, s_);
  }

  /// A free wall near its pressure maximum stretches far for little pressure: there the rest must be
  /// small against the step in pressure, or the maximum would be run past.
  double calc_tolerance() const {
    const double tolerance = target_.tightness * model_.increment.tolerance;
    if (target_.use_volume || touches_ || state_.pressure == 0.0) return tolerance;
    const double step = std::abs(attempt_.loads.pressure - state_.pressure) / std::abs(state_.pressure);
    return std::clamp(0.01 * step, 0.01 * tolerance, tolerance);
  }

  /// A few contacts that come or go are springs more or less for the factor; many call for a new one.
  void take_changes(const SetChange& change) {
    const bool are_few = has_springs() && !s_.solver.is_unsymmetric() && attempt_.iterations > 1 &&
                         !has_set_changed_ &&
                         s_.secant.n_springs() + static_cast<int>(change.springs.size()) <= kLargestSprings;
    if (!are_few || !learn_springs(change.springs, s_)) has_set_changed_ = true;
  }

  /// Contact set, friction and imbalance of the present trial; true when it is an equilibrium.
  bool is_done() {
    // Later ones wait for the next increment: letting go one after the other never ends.
    const bool may_release = attempt_.residual < kReleaseResidual && attempt_.iterations <= kReleasePasses;
    const SetChange change = update_contact_set(model_, state_, attempt_.loads, may_release, s_);
    if (change.any()) {
      evaluate_contacts(model_, state_, attempt_.loads, is_settled_, s_);
      take_changes(change);
    }
    const double gap_tolerance = 0.1 * model_.touch_tolerance(),
                 gap_error = has_springs() ? 0.0 : calc_gap_error(s_.trial);
    if (attempt_.iterations >= kSettlingPasses && attempt_.residual < kSettledResidual) is_settled_ = true;
    volume_gap_ = calc_volume_gap();
    if (change.any() || gap_error > gap_tolerance || attempt_.residual > calc_tolerance() ||
        std::abs(volume_gap_) > kVolumeTolerance * std::abs(state_.volume)) {
      return false;
    }
    if (thickness_passes_ < kThicknessPasses && !is_thickness_right()) {
      ++thickness_passes_;
      is_thickness_new_ = true;
      evaluate_trial();
      return false;
    }
    if (friction_passes_ < kFrictionPasses && !is_friction_right()) {
      ++friction_passes_;
      return false;
    }
    if (model_.controls_error) attempt_.error = calc_error(predicted_x_);
    finish_contacts();
    attempt_.volume = target_.use_volume ? target_.volume : calc_volume(model_, state_, s_);
    attempt_.end = Attempt::End::kConverged;
    return true;
  }

  /// What the treatments one step behind do at the end of an increment.
  void finish_contacts() {
    if (model_.friction_law == FrictionLaw::kOneStepBehind && has_friction_) {
      renew_friction(model_, s_);
      attempt_.residual = calc_imbalance(model_, attempt_.loads, s_).residual;
    }
    if (model_.release != ReleaseRule::kFull) release_by_sign(model_, attempt_.loads, s_.bases, s_.trial);
  }

  /// Renews the thickness that stood still, and tells whether contact points were right with the old
  /// one. A node that has touched in this increment is judged strictly: a wall pushed too far yields for
  /// good.
  bool is_thickness_right() {
    const std::vector<double> before = s_.trial.configuration.thickness;
    update_thickness(model_, s_.trial);
    for (std::size_t t = 0; t < model_.tools.size(); ++t) {
      for (std::size_t i = 0; i < before.size(); ++i) {
        if (!s_.trial.contacts[t][i].is_active()) continue;
        const double allowed = (state_.contacts[t][i].is_active() ? 0.5 : 0.2) * model_.touch_tolerance();
        if (0.5 * std::abs(s_.trial.configuration.thickness[i] - before[i]) > allowed) return false;
      }
    }
    return true;
  }

  /// Renews the bounds of friction that stood still, and tells whether the trial is in balance with them.
  bool is_friction_right() {
    if (!has_friction_ || !touches_ || !target_.renews_friction) return true;
    evaluate_contacts(model_, state_, attempt_.loads, false, s_);
    attempt_.residual = calc_imbalance(model_, attempt_.loads, s_).residual;
    return attempt_.residual <= model_.increment.tolerance;
  }

  /// Close to equilibrium the last factor, with what the steps since have taught it, still points the
  /// right way; the prediction's, made before the wall moved, does not.
  bool serves_last_factor() {
    if (has_set_changed_ || attempt_.iterations == 1 || s_.solver.is_unsymmetric()) return false;
    if (is_thickness_new_) return true;
    if (attempt_.residual > 0.7 * last_residual_) ++slow_passes_;
    return attempt_.residual < kReuseResidual && slow_passes_ < kSlowPasses &&
           s_.secant.n_steps() < kLargestSecant;
  }

  bool correct() {
    const bool keeps_factor = serves_last_factor();
    last_residual_ = attempt_.residual;
    is_thickness_new_ = false;
    if (!keeps_factor) {
      has_set_changed_ = false;
      slow_passes_ = 0;
      if (!has_stiffness_) evaluate_elements(model_, state_, attempt_.loads, {.with_stiffness = true}, s_);
      has_stiffness_ = false;  // assembling uses the element matrices up
      if (!factorise_or_fail()) return false;
    }
    correction_ = solve(model_, attempt_.loads, target_.use_volume, volume_gap_, s_);
    limit_correction(correction_);
    return true;
  }

  Solution correction_;
  double volume_gap_ = 0.0;
  double last_residual_ = 0.0;  ///< that the last correction started from
  int thickness_passes_ = 0, friction_passes_ = 0, slow_passes_ = 0;
  bool has_friction_ = false;
  bool is_settled_ = false;        ///< friction bounds stand still from here on
  bool has_stiffness_ = false;     ///< element matrices of the present trial
  bool has_set_changed_ = false;   ///< since the last factorisation
  bool is_thickness_new_ = false;  ///< nothing but the thickness has changed since the last equilibrium
};

}  // namespace

Attempt try_increment(const Model& model, const State& state, const Target& target, Scratch& scratch) {
  if (model.correction != Correction::kNewton) return try_explicit_step(model, state, target, scratch);
  return Corrector(model, state, target, scratch).run();
}

}  // namespace hydroscope
