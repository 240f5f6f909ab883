// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/attempt.h"

#include <algorithm>
#include <cmath>

#include "solver/increment/contact_step.h"
#include "solver/increment/equations.h"
#include "solver/increment/evaluate.h"
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
constexpr int kThinningSolves = 2;       // of the prediction, for the thickness that it leads to
constexpr int kLargestCuts = 6;          // of one correction
constexpr double kDivergence = 1e10;     // residual at which an increment is given up
constexpr double kReuseResidual = 0.03;  // below it the last factor is kept as long as it serves
constexpr double kFarResidual = 0.1;     // from above it one correction seldom leads below
constexpr int kSlowPasses = 3;           // with a kept factor before it is renewed
constexpr int kLargestSecant = 10;
constexpr int kLargestSprings = 12;  // that came or went since the last factorisation

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
  solution.work *= kLargestTurn / largest;
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
    for (const Tool& tool : model_.tools) has_friction_ = has_friction_ || tool.friction > 0.0;
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
    ++attempt_.factorisations;
    assemble_matrix(model_, s_);
    if (factorise(model_, s_).is_usable) return true;
    attempt_.end = Attempt::End::kSingular;
    return false;
  }

  Solution solve_step() { return solve(model_, attempt_.loads, target_.use_volume, calc_volume_gap(), s_); }

  /// The wall thins within the increment and the slave points with it: the thickness that the
  /// prediction leads to goes back into its gaps (mechanics 8.1), by solves with the same factor.
  Solution solve_with_thinning() {
    Solution solution = solve_step();
    for (int pass = 0; touches_ && pass < kThinningSolves; ++pass) {
      Configuration& c = s_.trial.configuration;
      move(c, solution.q);
      s_.trial.area = calc_nodal_areas(model_, c);
      update_thickness(model_, s_.trial);
      c.x = state_.configuration.x;
      c.triad = state_.configuration.triad;
      search_contacts(model_, attempt_.loads, s_);
      evaluate_contacts(model_, state_, attempt_.loads, false, s_);
      solution = solve_step();
    }
    return solution;
  }

  bool predict() {
    evaluate(model_, state_, attempt_.loads, {.assume_flow = !target_.is_turning, .with_stiffness = true},
             s_);
    evaluate_contacts(model_, state_, attempt_.loads, false, s_);
    if (!factorise_or_fail()) return false;
    attempt_.negative_pivots = s_.last_factorisation.negative_pivots;
    if (attempt_.negative_pivots > 0 && !target_.use_volume) {
      attempt_.compliance = solve(model_, attempt_.loads, true, 0.0, s_).compliance;
      attempt_.end = Attempt::End::kUnstable;
      return false;
    }
    const Solution solution = solve_with_thinning();
    attempt_.limit = calc_step_limit(model_, solution.q, s_.trial);
    limit_by_contact_events(model_, state_, solution.q, s_, attempt_.limit);
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
      evaluate_trial();
      if (cut == 0 && stops_at(model_, "yield") && s_.trial.elastic_share < kWholeShare) {  // r1
        attempt_.limit.reduce((1.0 + model_.increment.cluster) * s_.trial.elastic_share * r, Limiter::kYield,
                              s_.trial.yield_at);
        if (attempt_.limit.fraction < r) continue;
      }
      const double fraction = calc_strain_fraction(model_, s_.trial);
      if (fraction > 0.9 || cut == kLargestStrainCuts) break;
      attempt_.limit.reduce(0.95 * fraction * r, Limiter::kStrain, s_.trial.strain_at);
    }
    strain_ = s_.trial.strain_increment;
  }

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
    const double strain_bound = 2.0 * std::max(model_.increment.max_strain, strain_);
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
    learn_step(correction_, scale, attempt_.loads, s_);
  }

  /// A free wall near its pressure maximum stretches far for little pressure: there the rest must be
  /// small against the step in pressure, or the maximum would be run past.
  double calc_tolerance() const {
    const double tolerance = model_.increment.tolerance;
    if (target_.use_volume || touches_ || state_.pressure == 0.0) return tolerance;
    const double step = std::abs(attempt_.loads.pressure - state_.pressure) / std::abs(state_.pressure);
    return std::clamp(0.01 * step, 0.01 * tolerance, tolerance);
  }

  /// A few contacts that come or go are springs more or less for the factor; many call for a new one.
  void take_changes(const SetChange& change) {
    const bool are_few = has_springs() && attempt_.iterations > 1 && !has_set_changed_ &&
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
    attempt_.volume = target_.use_volume ? target_.volume : calc_volume(model_, state_, s_);
    attempt_.end = Attempt::End::kConverged;
    return true;
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
    if (has_set_changed_ || attempt_.iterations == 1) return false;
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

  static constexpr int kLargestStrainCuts = 3;
  static constexpr double kWholeShare = 0.9;  // points that yield later than this are let through
  const Model& model_;
  const State& state_;
  Target target_;
  Scratch& s_;
  Attempt attempt_;
  Solution correction_;
  double volume_gap_ = 0.0;
  double strain_ = 0.0;         ///< largest strain increment of the trial that the correction starts from
  double last_residual_ = 0.0;  ///< that the last correction started from
  int thickness_passes_ = 0, friction_passes_ = 0, slow_passes_ = 0;
  bool has_friction_ = false;
  bool touches_ = false;           ///< something touched in the last state
  bool is_settled_ = false;        ///< friction bounds stand still from here on
  bool has_stiffness_ = false;     ///< element matrices of the present trial
  bool has_set_changed_ = false;   ///< since the last factorisation
  bool is_thickness_new_ = false;  ///< nothing but the thickness has changed since the last equilibrium
};

}  // namespace

Attempt try_increment(const Model& model, const State& state, const Target& target, Scratch& scratch) {
  return Corrector(model, state, target, scratch).run();
}

}  // namespace hydroscope
