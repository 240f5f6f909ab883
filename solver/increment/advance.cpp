// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/advance.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "solver/increment/accept.h"
#include "solver/increment/attempt.h"
#include "solver/increment/measures.h"

namespace hydroscope {

namespace {

/// The next time at which any path turns [s].
double find_corner(const Model& model, const State& state) {
  const double after = state.time + 1e-12 * model.end_time;
  double corner = model.end_time;
  const auto look = [&](const Path& path) { corner = std::min(corner, find_next_corner(path, after)); };
  look(model.pressure);
  look(model.volume_ratio);
  look(model.feed);
  for (const Path& path : model.motions) look(path);
  for (const EdgeLoad& edge : model.edge_loads) {
    look(edge.force_x);
    look(edge.force_y);
    look(edge.tension);
    look(edge.moment);
  }
  for (const Tool& tool : model.tools) {
    for (const Path& path : tool.motion) look(path);
    if (state.time < tool.leaves_at) corner = std::min(corner, tool.leaves_at);
  }
  return corner;
}

/// End of the next increment: no farther than a corner of any path, or a halt.
Target make_target(const Model& model, const State& state, double dt, double farthest) {
  const double end = std::min(state.time + dt, farthest);
  Target target;
  target.time = end;
  target.is_turning = state.is_at_corner;
  target.use_volume = model.use_volume_control;
  target.pressure = model.pressure(end);
  target.volume = model.volume0 * model.volume_ratio(end);
  return target;
}

/// Growth of increments after one that took so many factorisations: those of the corrector hardly
/// depend on the increment's length.
double calc_growth(int factorisations) {
  if (factorisations <= 5) return 1.5;
  if (factorisations <= 8) return 1.25;
  return factorisations <= 12 ? 1.0 : 0.7;
}

/// The error of the embedded pair is of second order in the increment's length (Abbo & Sloan 1996).
double calc_error_growth(double error) {
  return error > 0.0 ? std::clamp(0.9 / std::sqrt(error), 0.2, 2.0) : 2.0;
}

/// Size of the next increment from what this one needed.
double propose_next(const Model& model, const Trial& trial, double dt, const Attempt& attempt) {
  double factor = calc_growth(attempt.factorisations);
  if (model.controls_error) factor = calc_error_growth(attempt.error);
  if (trial.strain_increment > 0.0 && model.increment.max_strain > 0.0) {
    factor = std::min(factor, 0.9 * model.increment.max_strain / trial.strain_increment);
  }
  return std::min(dt * std::max(factor, 0.2), model.increment.largest * model.end_time);
}

/// Did something happen that the linearisation ignores?
bool is_event(Limiter limiter) {
  return limiter == Limiter::kYield || limiter == Limiter::kTouch || limiter == Limiter::kRelease ||
         limiter == Limiter::kStickToSlip;
}

std::string describe_pressure(double pressure) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4g MPa", pressure);
  return text;
}

/// At its smallest increment under pressure control: step over by volume and see
/// whether the pressure falls (mechanics 3.4).
bool is_pressure_maximum(const Model& model, const State& state, Scratch& scratch) {
  if (model.use_volume_control || state.pressure == 0.0) return false;
  Target target;
  target.time = state.time;
  target.use_volume = true;
  target.volume = state.volume * (1.0 + 1e-3);
  const Attempt attempt = try_increment(model, state, target, scratch);
  return attempt.end == Attempt::End::kConverged && attempt.loads.pressure < state.pressure;
}

constexpr int kShorterFirst = 3;       // tries at an increment before it gets more passes
constexpr double kNearMaximum = 5e-4;  // of the pressure: how close a maximum is approached

bool touches(const std::vector<std::vector<ContactPoint>>& tools) {
  for (const auto& contacts : tools) {
    for (const ContactPoint& c : contacts) {
      if (c.is_active()) return true;
    }
  }
  return false;
}

/// An increment that blows a free wall far up for little pressure may have jumped over a pressure maximum, on
/// to the die for example. Then the pressure falls on the way before the wall touches: volume control goes
/// there, in quarters and then by halves towards the touch.
bool has_jumped(const Model& model, const State& state, const Attempt& attempt, Scratch& scratch) {
  constexpr double kSteep = 0.2;  // relative pressure for relative volume; above 1 far from a maximum
  constexpr double kFall = 1e-5;  // what is left out of balance counts for less
  constexpr int kLooks = 7;
  if (model.use_volume_control || state.pressure <= 0.0 || touches(state.contacts)) return false;
  const double rise = (attempt.loads.pressure - state.pressure) / state.pressure;
  if (rise <= 0.0 || rise > kSteep * (attempt.volume - state.volume) / state.volume) return false;
  Target target;
  target.time = state.time;
  target.use_volume = true;
  target.tightness = 0.001;  // the pressure's changes are small
  const Trial kept = scratch.trial;
  double low = 0.0, high = 1.0, highest = 0.0;
  bool falls = false;
  for (int look = 0; look < kLooks && !falls; ++look) {
    const double share = look < 3 ? 0.25 * (look + 1) : 0.5 * (low + high);
    if (share >= high) continue;
    target.volume = state.volume + share * (attempt.volume - state.volume);
    const Attempt part = try_increment(model, state, target, scratch);
    if (part.end != Attempt::End::kConverged || touches(scratch.trial.contacts)) {
      high = share;
      continue;
    }
    falls = part.loads.pressure < (1.0 - kFall) * highest;
    low = share;
    highest = std::max(highest, part.loads.pressure);
  }
  scratch.trial = kept;
  return falls;
}

void end_run(IncrementReport& report, Outcome outcome, const std::string& message) {
  report.outcome = outcome;
  report.message = message;
}

void end_at_maximum(IncrementReport& report, const State& state) {
  end_run(report, Outcome::kPressureMaximum,
          "pressure maximum at " + describe_pressure(state.pressure) +
              ": beyond it the bulge grows under falling pressure; drive the run with "
              "load.control = \"volume\" to pass it");
}

/// Names the end of a run whose increments have shrunk to nothing.
void report_failure(const Model& model, const State& state, const Attempt& attempt, Scratch& scratch,
                    IncrementReport& report) {
  const std::string at = "at " + describe_pressure(state.pressure);
  if (has_necked(state)) {
    return end_run(
        report, Outcome::kBursting,
        "bursting " + at + ": the wall is past the maximum of its force and its neck holds no longer");
  }
  if (attempt.end == Attempt::End::kUnstable && attempt.compliance >= 0.0) {
    return end_run(report, Outcome::kBuckling,
                   "buckling " + at + ": the stiffness has " + std::to_string(attempt.negative_pivots) +
                       " negative pivot(s) and the mode does not change the enclosed volume");
  }
  if (attempt.end == Attempt::End::kUnstable || is_pressure_maximum(model, state, scratch)) {
    return end_at_maximum(report, state);
  }
  if (attempt.end == Attempt::End::kSingular) {
    return end_run(report, Outcome::kSingular, "the stiffness is singular " + at);
  }
  end_run(report, Outcome::kStepFloor,
          "no equilibrium found with the smallest increment " + at + " (residual " +
              std::to_string(attempt.residual) + ")");
}

}  // namespace

IncrementReport advance(const Model& model, State& state, Scratch& scratch, double halt_time) {
  IncrementReport report;
  const int factorisations_before = scratch.factorisations;
  const double floor = model.increment.smallest * model.end_time;
  double dt = std::max(state.next_dt, floor);
  bool error_limited = false;
  const double corner = find_corner(model, state), farthest = std::min(corner, halt_time);
  for (int tries = 0;; ++tries) {
    Target target = make_target(model, state, dt, farthest);
    // The coupling of friction with the normal force is not in the tangent: where it keeps the corrector from
    // settling, the bounds stay behind by one correction.
    target.renews_friction = tries == 0;
    // Where shorter increments do not help, more passes do.
    target.patience = tries < kShorterFirst ? 1 : 3;
    const double tried = target.time - state.time;
    const Attempt attempt = try_increment(model, state, target, scratch);
    if (attempt.end == Attempt::End::kConverged) {
      const double strain_fraction = calc_strain_fraction(model, scratch.trial);
      const double done = attempt.loads.time - state.time;
      if (strain_fraction < 0.6 && done > 2.0 * floor) {  // r2: too far for the path to be followed
        dt = 0.9 * strain_fraction * done;
        continue;
      }
      if (attempt.error > 1.0 && done > 2.0 * floor) {
        dt = calc_error_growth(attempt.error) * done;
        error_limited = true;
        continue;
      }
      if (has_jumped(model, state, attempt, scratch)) {
        if (attempt.loads.pressure - state.pressure > kNearMaximum * state.pressure && done > 2.0 * floor) {
          dt = 0.35 * done;  // closer to the maximum first
          continue;
        }
        report.factorisations = scratch.factorisations - factorisations_before;
        end_at_maximum(report, state);
        return report;
      }
      const double next = propose_next(model, scratch.trial, done, attempt);
      report.factorisations = scratch.factorisations - factorisations_before;
      accept(model, attempt, state, scratch, report);
      state.is_at_corner = state.time >= corner * (1.0 - 1e-12);
      report.step_fraction = tried > 0.0 ? done / tried : 1.0;
      // A short step to the corner of a path says nothing about the next one.
      state.next_dt = (tried < 0.5 * dt && attempt.limit.fraction >= 1.0) ? dt : next;
      // A forward step shortened by an event is a scaled longer one, which has cost no more.
      if (model.correction != Correction::kNewton && is_event(attempt.limit.limiter)) {
        state.next_dt = std::max(state.next_dt, 0.9 * tried);
      }
      // What follows a corner is unknown: begin gently, as at the start.
      if (state.is_at_corner) state.next_dt = std::min(state.next_dt, 0.005 * model.end_time);
      if (model.increment.max_strain > 0.0 && (strain_fraction < 1.0 || next < 1.4 * done)) {
        if (report.limited_by == Limiter::kTimePath) report.limited_by = Limiter::kStrain;
      }
      if (error_limited) report.limited_by = Limiter::kError;
      return report;
    }
    dt = 0.35 * std::min(dt, attempt.limit.fraction < 1.0 ? attempt.limit.fraction * tried : tried);
    // The predictor's matrix is that of the pressure aimed at: only close by does it speak for the state.
    const bool is_near =
        std::abs(target.pressure - state.pressure) <= kNearMaximum * std::abs(state.pressure);
    const bool is_final =
        (attempt.end == Attempt::End::kUnstable && is_near) || attempt.end == Attempt::End::kSingular;
    if (is_final || dt < floor) {
      report.factorisations = scratch.factorisations - factorisations_before;
      report_failure(model, state, attempt, scratch, report);
      return report;
    }
  }
}

}  // namespace hydroscope
