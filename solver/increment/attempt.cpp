// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/attempt.h"

#include <algorithm>
#include <cmath>

#include "solver/increment/contact_step.h"
#include "solver/increment/equations.h"
#include "solver/increment/evaluate.h"

namespace hydroscope {

namespace {

constexpr double kReleaseResidual = 0.02;  // reactions are trusted for letting go below this imbalance
constexpr int kReleasePasses = 5;
constexpr double kVolumeTolerance = 1e-8;  // of the enclosed volume
// The tangent knows neither that the wall thins nor that friction follows the normal force; near a
// limit point that alone keeps the corrector from settling. After these passes both stand still:
// what they still lack is of the size of the last correction, and is made up in the next increment.
constexpr int kSettlingPasses = 2;
constexpr double kSettledResidual = 0.1;
constexpr int kThicknessPasses = 6;
constexpr int kLargestCuts = 3;      // of one correction
constexpr double kDivergence = 1e4;  // growth of the residual at which an increment is given up

/// The part of the way from the state to the target.
Target interpolate(const State& state, const Target& target, double r) {
  Target part = target;
  part.time = state.time + r * (target.time - state.time);
  part.pressure = state.pressure + r * (target.pressure - state.pressure);
  part.volume = state.volume + r * (target.volume - state.volume);
  return part;
}

/// Corrector passes are kept from turning fibres head over heels.
void limit_correction(Solution& solution) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < solution.q.size(); i += kDofs) {
    largest = std::max(largest, solution.q.segment<2>(i + 3).norm());
  }
  constexpr double kLargestTurn = 0.2;  // [rad]
  if (largest <= kLargestTurn) return;
  solution.q *= kLargestTurn / largest;
  solution.pressure_change *= kLargestTurn / largest;
}

/// One try in progress.
class Corrector {
 public:
  Corrector(const Model& model, const State& state, const Target& target, Scratch& scratch)
      : model_(model), state_(state), target_(target), s_(scratch) {
    attempt_.loads = {target.time, target.use_volume ? state.pressure : target.pressure};
  }

  Attempt run() {
    start_trial(state_, s_);
    for (const auto& contacts : state_.contacts) {
      for (const ContactPoint& c : contacts) touches_ = touches_ || c.is_active();
    }
    if (!predict()) return attempt_;
    for (int k = 1; k <= model_.increment.max_iterations; ++k) {
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
  double calc_volume_gap() const {
    return target_.use_volume ? target_.volume - calc_volume(model_, state_, s_) : 0.0;
  }

  bool factorise_or_fail() {
    assemble_matrix(model_, s_);
    if (factorise(model_, s_).is_usable) return true;
    attempt_.end = Attempt::End::kSingular;
    return false;
  }

  /// The wall as thick as it will be at the target, from the rate of the last increment
  /// (mechanics 8.1). Where it can be foretold it stands still for the whole increment: what the
  /// prediction misses is of second order and is made up in the next one.
  bool can_predict_thickness() const {
    return target_.predicts_thickness && !target_.is_turning && state_.increment > 0 &&
           target_.time > state_.time;
  }
  void predict_thickness() {
    if (!can_predict_thickness()) return;
    const double dt = target_.time - state_.time;
    std::vector<double>& h = s_.trial.configuration.thickness;
    for (std::size_t i = 0; i < h.size(); ++i) {
      h[i] = state_.configuration.thickness[i] + state_.thinning_rate[i] * dt;
    }
  }

  bool predict() {
    evaluate(model_, state_, attempt_.loads, {.assume_flow = !target_.is_turning}, s_);
    predict_thickness();
    search_contacts(model_, attempt_.loads, s_);
    evaluate_contacts(model_, state_, attempt_.loads, false, s_);
    if (!factorise_or_fail()) return false;
    attempt_.negative_pivots = s_.last_factorisation.negative_pivots;
    if (attempt_.negative_pivots > 0 && !target_.use_volume) {
      attempt_.compliance = solve(model_, attempt_.loads, true, 0.0, s_).compliance;
      attempt_.end = Attempt::End::kUnstable;
      return false;
    }
    const Solution solution = solve(model_, attempt_.loads, target_.use_volume, calc_volume_gap(), s_);
    attempt_.limit = calc_step_limit(model_, solution.q, s_.trial);
    take_prediction(solution);
    return true;
  }

  /// Moves by as much of the prediction as the limits allow. The strain it causes (r2) is measured
  /// with the stresses integrated, and counts at once: a prediction with elastic stiffness may be far off.
  void take_prediction(const Solution& solution) {
    const Target whole = target_;
    const double start_pressure = attempt_.loads.pressure;
    attempt_.iterations = 1;
    for (int cut = 0;; ++cut) {
      const double r = std::min(1.0, attempt_.limit.fraction);
      target_ = interpolate(state_, whole, r);
      attempt_.loads = {target_.time,
                        whole.use_volume ? start_pressure + r * solution.pressure_change : target_.pressure};
      s_.trial.configuration = state_.configuration;
      move(s_.trial.configuration, r * solution.q);
      predict_thickness();
      evaluate_trial();
      const double fraction = calc_strain_fraction(model_, s_.trial);
      if (fraction > 0.9 || cut == kLargestCuts) return;
      attempt_.limit.reduce(0.95 * fraction * r, Limiter::kStrain, s_.trial.strain_at);
    }
  }

  bool has_springs() const { return model_.contact.wall_stiffness > 0.0; }
  bool is_settled() const { return is_settled_; }

  void evaluate_trial() {
    evaluate(model_, state_, attempt_.loads,
             {.assume_flow = false, .freeze_thickness = is_settled() || can_predict_thickness()}, s_);
    evaluate_contacts(model_, state_, attempt_.loads, is_settled(), s_);
    attempt_.residual = calc_imbalance(model_, attempt_.loads, s_).residual;
  }

  /// Takes the correction, or as much of it as does not throw the trial farther off. Closing gaps
  /// disturbs the equilibrium at first: then only the strain tells a step that is too long.
  void search_along() {
    const Configuration base = s_.trial.configuration;
    const double base_pressure = attempt_.loads.pressure, before = attempt_.residual;
    const double strain_bound = 2.0 * std::max(model_.increment.max_strain, s_.trial.strain_increment);
    double scale = 1.0;
    for (int k = 0;; ++k, scale *= 0.4) {
      s_.trial.configuration = base;
      move(s_.trial.configuration, scale * correction_.q);
      attempt_.loads.pressure = base_pressure + scale * correction_.pressure_change;
      evaluate_trial();
      const bool is_calm =
          attempt_.residual <= 1.5 * before || (is_closing_ && s_.trial.strain_increment <= strain_bound);
      if (is_calm || k == kLargestCuts) return;
    }
  }

  /// A free wall near its pressure maximum stretches far for little pressure: there the rest must be
  /// small against the step in pressure, or the maximum would be run past.
  double calc_tolerance() const {
    const double tolerance = model_.increment.tolerance;
    if (target_.use_volume || touches_ || state_.pressure == 0.0) return tolerance;
    const double step = std::abs(attempt_.loads.pressure - state_.pressure) / std::abs(state_.pressure);
    return std::clamp(0.01 * step, 0.01 * tolerance, tolerance);
  }

  /// Contact set, friction and imbalance of the present trial; true when it is an equilibrium.
  bool is_done() {
    // Later ones wait for the next increment: letting go one after the other never ends.
    const bool may_release = attempt_.residual < kReleaseResidual && attempt_.iterations <= kReleasePasses;
    const SetChange change = update_contact_set(model_, state_, attempt_.loads, may_release, s_);
    if (change.any()) evaluate_contacts(model_, state_, attempt_.loads, is_settled(), s_);
    const double gap_tolerance = 0.1 * model_.touch_tolerance(),
                 gap_error = has_springs() ? 0.0 : calc_gap_error(s_.trial);
    is_closing_ = change.any() || gap_error > gap_tolerance;
    if (attempt_.iterations >= kSettlingPasses && attempt_.residual < kSettledResidual) is_settled_ = true;
    volume_gap_ = calc_volume_gap();
    if (is_closing_ || attempt_.residual > calc_tolerance() ||
        std::abs(volume_gap_) > kVolumeTolerance * std::abs(state_.volume)) {
      return false;
    }
    if (thickness_passes_ < kThicknessPasses && !is_thickness_right()) {
      ++thickness_passes_;
      evaluate_trial();
      return false;
    }
    attempt_.volume = target_.use_volume ? target_.volume : calc_volume(model_, state_, s_);
    attempt_.end = Attempt::End::kConverged;
    return true;
  }

  /// Renews the thickness that stood still, and tells whether contact points were right with the old
  /// one. A node that has touched in this increment is judged strictly: the rate that foretold it has
  /// ended, and a wall pushed too far yields for good.
  bool is_thickness_right() {
    const std::vector<double> before = s_.trial.configuration.thickness;
    update_thickness(model_, s_.trial);
    for (std::size_t t = 0; t < model_.tools.size(); ++t) {
      for (std::size_t i = 0; i < before.size(); ++i) {
        if (!s_.trial.contacts[t][i].is_active()) continue;
        const double allowed = (state_.contacts[t][i].is_active() ? 0.5 : 0.005) * model_.touch_tolerance();
        if (0.5 * std::abs(s_.trial.configuration.thickness[i] - before[i]) > allowed) return false;
      }
    }
    return true;
  }

  bool correct() {
    if (!factorise_or_fail()) return false;
    correction_ = solve(model_, attempt_.loads, target_.use_volume, volume_gap_, s_);
    limit_correction(correction_);
    return true;
  }

  const Model& model_;
  const State& state_;
  Target target_;
  Scratch& s_;
  Attempt attempt_;
  Solution correction_;
  double volume_gap_ = 0.0;
  bool touches_ = false;  ///< the last state has contacts
  int thickness_passes_ = 0;
  bool is_settled_ = false;  ///< thickness and friction bounds stand still from here on
  bool is_closing_ = false;  ///< the contact set has changed, or gaps are still open
};

}  // namespace

Attempt try_increment(const Model& model, const State& state, const Target& target, Scratch& scratch) {
  return Corrector(model, state, target, scratch).run();
}

}  // namespace hydroscope
