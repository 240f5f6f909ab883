// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/predictor.h"

#include <algorithm>
#include <cmath>

namespace hydroscope {

namespace {

constexpr int kThinningSolves = 2;  // of the prediction, for the thickness that it leads to

}  // namespace

Target interpolate(const State& state, const Target& target, double r) {
  Target part = target;
  part.time = state.time + r * (target.time - state.time);
  part.pressure = state.pressure + r * (target.pressure - state.pressure);
  part.volume = state.volume + r * (target.volume - state.volume);
  return part;
}

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

Predictor::Predictor(const Model& model, const State& state, const Target& target, Scratch& scratch)
    : model_(model), state_(state), target_(target), s_(scratch) {
  attempt_.loads = {target.time, target.use_volume ? state.pressure : target.pressure};
  start_trial(state_, s_);
  for (const auto& contacts : state_.contacts) {
    for (const ContactPoint& c : contacts) touches_ = touches_ || c.is_active();
  }
}

double Predictor::calc_volume_gap() const {
  return target_.use_volume ? target_.volume - calc_volume(model_, state_, s_) : 0.0;
}

bool Predictor::factorise_or_fail() {
  ++attempt_.factorisations;
  assemble_matrix(model_, s_);
  if (factorise(model_, s_).is_usable) return true;
  attempt_.end = Attempt::End::kSingular;
  return false;
}

Step Predictor::make_prediction_step() const {
  Step step = make_step(attempt_.loads, s_);
  if (behind_ != nullptr && behind_->size() > 0) step.force -= *behind_;
  return step;
}

/// The wall thins within the increment and the slave points with it: the thickness that the
/// prediction leads to goes back into its gaps (mechanics 8.1), by solves with the same factor.
Solution Predictor::solve_with_thinning() {
  const auto solve_step = [&] {
    step_ = make_prediction_step();
    return solve(model_, attempt_.loads, step_, target_.use_volume, calc_volume_gap(), s_);
  };
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

bool Predictor::predict(const Vector* behind) {
  behind_ = behind;
  evaluate(model_, state_, attempt_.loads, {.assume_flow = !target_.is_turning, .with_stiffness = true}, s_);
  evaluate_contacts(model_, state_, attempt_.loads, false, s_);
  if (!factorise_or_fail()) return false;
  attempt_.negative_pivots = s_.last_factorisation.negative_pivots;
  if (attempt_.negative_pivots > 0 && !target_.use_volume) {
    attempt_.compliance =
        solve(model_, attempt_.loads, make_step(attempt_.loads, s_), true, 0.0, s_).compliance;
    attempt_.end = Attempt::End::kUnstable;
    return false;
  }
  prediction_ = solve_with_thinning();
  attempt_.limit = calc_step_limit(model_, prediction_.q, s_.trial);
  limit_by_contact_events(model_, state_, prediction_.q, s_, attempt_.limit);
  take_prediction();
  if (model_.controls_error) predicted_x_ = s_.trial.configuration.x;
  return true;
}

void Predictor::evaluate_prediction() {
  evaluate(model_, state_, attempt_.loads, {}, s_);
  evaluate_contacts(model_, state_, attempt_.loads, false, s_);
  attempt_.residual = calc_imbalance(model_, attempt_.loads, s_).residual;
}

/// Moves by as much of the prediction as the limits allow. The strain it causes (r2) is measured
/// with the stresses integrated, and counts at once: a prediction with elastic stiffness may be far off.
void Predictor::take_prediction() {
  const Target whole = target_;
  const double start_pressure = attempt_.loads.pressure;
  attempt_.iterations = 1;
  for (int cut = 0;; ++cut) {
    const double r = std::min(1.0, attempt_.limit.fraction);
    target_ = interpolate(state_, whole, r);
    attempt_.loads = {target_.time,
                      whole.use_volume ? start_pressure + r * prediction_.pressure_change : target_.pressure};
    s_.trial.configuration = state_.configuration;
    move(s_.trial.configuration, r * prediction_.q);
    evaluate_prediction();
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

double Predictor::calc_error(const std::vector<Vec3>& x) const {
  double error = 0.0, way = model_.thickness;
  for (std::size_t i = 0; i < x.size(); ++i) {
    error = std::max(error, 0.5 * (s_.trial.configuration.x[i] - x[i]).norm());
    way = std::max(way, (s_.trial.configuration.x[i] - model_.x0[i]).norm());
  }
  return error / (way * model_.increment.error_tolerance);
}

}  // namespace hydroscope
