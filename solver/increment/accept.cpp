// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/accept.h"

#include <algorithm>
#include <cmath>

#include "solver/increment/contact_step.h"
#include "solver/increment/equations.h"
#include "solver/increment/evaluate.h"
#include "solver/increment/measures.h"
#include "solver/increment/release.h"

namespace hydroscope {

namespace {

constexpr int kChatterWindow = 5;  // increments within which a second toggle counts as chatter

ContactEvent make_event(EventKind kind, const State& state, std::size_t tool, std::size_t node,
                        const ContactPoint& before, const ContactPoint& now, const char* cause) {
  ContactEvent event;
  event.kind = kind;
  event.increment = state.increment;
  event.time = state.time;
  event.node = static_cast<int>(node);
  event.position = now.foot.point;
  event.tool = static_cast<int>(tool);
  event.cause = cause;
  event.force_before = before.normal_force;
  event.force_after = now.normal_force;
  event.gap = now.foot.gap;
  if (kind == EventKind::kDetach || kind == EventKind::kTakenBack) {
    event.force_after = now.release.force;
    event.patch_pressure = now.release.pressure;
    event.threshold = now.release.threshold;
  }
  return event;
}

/// Why a node let go, in words. Under falling pressure a wall springs back: that is what tension means then.
const char* name_cause(ReleaseCause cause, bool is_unloading) {
  switch (cause) {
    case ReleaseCause::kEdge:
      return "edge";
    case ReleaseCause::kLost:
      return "left the tool";
    case ReleaseCause::kToolTaken:
      return "tool taken away";
    case ReleaseCause::kSign:
      return "sign rule";
    case ReleaseCause::kPatch:
      return is_unloading ? "unloading" : "patch";
    case ReleaseCause::kTension:
    case ReleaseCause::kNone:
      break;
  }
  return is_unloading ? "unloading" : "tension";
}

/// Change of status of one node against one tool between two accepted states.
void record_change(const State& state, std::size_t t, std::size_t i, const ContactPoint& before,
                   ContactPoint& now, bool is_unloading, IncrementReport& report) {
  const auto add = [&](EventKind kind, const char* cause) {
    report.events.push_back(make_event(kind, state, t, i, before, now, cause));
  };
  if (!before.is_active() && now.is_active()) {
    add(now.toggles > 0 ? EventKind::kRetouch : EventKind::kTouch, "gap closed");
    const bool is_chatter = now.toggles > 1 && state.increment - now.last_toggle <= kChatterWindow;
    if (is_chatter) now.locked = kChatterWindow;
    ++now.toggles;
    now.last_toggle = state.increment;
  } else if (before.is_active() && !now.is_active()) {
    add(EventKind::kDetach, name_cause(now.release.cause, is_unloading));
    ++report.n_detached;
    ++now.toggles;
    now.last_toggle = state.increment;
    now.peak_force = 0.0;
  } else if (!before.is_active() && now.release.cause == ReleaseCause::kSign) {  // came and went at once
    add(now.toggles > 0 ? EventKind::kRetouch : EventKind::kTouch, "gap closed");
    add(EventKind::kDetach, name_cause(now.release.cause, is_unloading));
    ++report.n_detached;
    now.toggles += 2;
    now.last_toggle = state.increment;
  } else if (before.is_active() && now.release.cause != ReleaseCause::kNone) {
    add(EventKind::kTakenBack, name_cause(now.release.cause, is_unloading));
  } else if (before.status != now.status) {
    if (now.status == ContactStatus::kSlip) add(EventKind::kSlip, "friction limit");
    if (now.status == ContactStatus::kStick) add(EventKind::kStick, "sliding stopped");
  }
}

void update_contact_history(const Model& model, State& state,
                            const std::vector<std::vector<ContactPoint>>& old, bool is_unloading,
                            IncrementReport& report) {
  for (std::size_t t = 0; t < state.contacts.size(); ++t) {
    for (std::size_t i = 0; i < state.contacts[t].size(); ++i) {
      const ContactPoint& before = old[t][i];
      ContactPoint& now = state.contacts[t][i];
      now.slip_increment.setZero();
      if (now.is_active()) {
        const Vec3 n = now.foot.normal;
        const Vec3 slide = now.position - now.anchor;
        if (now.status == ContactStatus::kSlip) now.slip_increment = slide - n.dot(slide) * n;
        now.slip += now.slip_increment;
        now.peak_force = std::max(now.peak_force, now.normal_force);
        ++(now.status == ContactStatus::kStick ? report.n_stick : report.n_slip);
      }
      record_change(state, t, i, before, now, is_unloading, report);
      if (now.locked > 0) --now.locked;
      if (now.is_releasing && (!now.has_foot || now.foot.gap > 2.0 * model.touch_tolerance()))
        now.is_releasing = false;
    }
  }
  report.n_contact = report.n_stick + report.n_slip;
}

/// Contact pressure on the outer face for sigma33: not above the fluid's, as the line load at the edge of a
/// contact is none of the wall's depth, and spread over one thickness, as a wall spreads it.
void update_outer_pressure(const Model& model, State& state) {
  std::fill(state.outer_pressure.begin(), state.outer_pressure.end(), 0.0);
  for (std::size_t t = 0; t < state.contacts.size(); ++t) {
    if (model.tools[t].side < 0.0) continue;
    for (std::size_t i = 0; i < state.outer_pressure.size(); ++i) {
      if (!state.contacts[t][i].is_active()) continue;
      state.outer_pressure[i] +=
          std::clamp(calc_smoothed_pressure(model, state.contacts[t], state.area, static_cast<int>(i)), 0.0,
                     std::abs(state.pressure));
    }
  }
  if (model.use_through_wall_stress) smooth_over_wall(model, model.thickness, state.outer_pressure);
}

}  // namespace

void accept(const Model& model, const Attempt& attempt, State& state, Scratch& scratch,
            IncrementReport& report) {
  const PhaseTimer timer(scratch.times.update);
  Trial& trial = scratch.trial;
  state.reaction = calc_reactions(model, attempt.loads, scratch);
  update_thickness(model, trial);
  const auto old_contacts = std::move(state.contacts);
  const double old_time = state.time, old_pressure = state.pressure;
  state.wall = trial.wall;
  state.configuration = trial.configuration;
  state.layers = trial.layers;
  state.gauss = trial.gauss;
  state.contacts = trial.contacts;
  state.sigma33 = trial.sigma33;
  state.area = trial.area;
  state.time = attempt.loads.time;
  state.pressure = attempt.loads.pressure;
  state.volume = attempt.volume;
  state.peak_pressure = std::max(state.peak_pressure, state.pressure);
  state.last_dt = state.time - old_time;
  state.unbalanced = attempt.unbalanced;
  ++state.increment;

  report.increment = state.increment;
  report.time = state.time;
  report.pressure = state.pressure;
  report.feed = model.feed(state.time);
  report.limited_by = attempt.limit.limiter;
  report.limited_at = attempt.limit.at;
  report.residual = attempt.residual;
  report.tangential_rest = calc_tangential_rest(scratch, attempt.loads);
  report.iterations = attempt.iterations;
  report.negative_pivots = attempt.negative_pivots;
  update_contact_history(model, state, old_contacts, state.pressure < old_pressure, report);
  update_outer_pressure(model, state);
  const auto [low, high] = std::minmax_element(state.wall.begin(), state.wall.end());
  report.thickness_min = *low;
  report.thickness_max = *high;
  for (const Quantity& quantity : model.quantities) {
    report.quantities.push_back(evaluate_quantity(model, state, quantity, report.quantities));
  }
  judge(model, scratch, state, report);
}

}  // namespace hydroscope
