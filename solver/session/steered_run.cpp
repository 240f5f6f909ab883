// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/steered_run.h"

#include <algorithm>
#include <cmath>

#include "solver/base/error.h"
#include "solver/increment/advance.h"
#include "solver/increment/contact_step.h"
#include "solver/increment/equations.h"
#include "solver/session/accuracy_choices.h"
#include "solver/session/build_model.h"
#include "solver/session/make_snapshot.h"
#include "solver/session/scene_change.h"

namespace hydroscope {

namespace {

constexpr int kBlasThreads = 1;

template <class Value>
std::size_t size_of(const std::vector<Value>& values) {
  return values.size() * sizeof(Value);
}

std::shared_ptr<const RunSetup> make_setup(const Scene& scene) {
  auto setup = std::make_shared<RunSetup>();
  setup->scene = choose_for_accuracy(scene);
  setup->model = build_model(setup->scene);
  return setup;
}

}  // namespace

std::size_t calc_size(const RunPoint& point) {
  const State& s = point.state;
  std::size_t size = sizeof(RunPoint) + size_of(s.configuration.x) + size_of(s.configuration.triad) +
                     size_of(s.configuration.thickness) + size_of(s.layers) + size_of(s.gauss) +
                     size_of(s.reaction) + size_of(point.times) + size_of(point.quantities);
  for (const auto& contacts : s.contacts) size += size_of(contacts);
  for (const auto* field : {&s.recent_strain, &s.sigma33, &s.outer_pressure, &s.wall, &s.area})
    size += size_of(*field);
  return size + static_cast<std::size_t>(s.unbalanced.size()) * sizeof(double);
}

SteeredRun::SteeredRun(const Scene& scene, const RunOptions& options) : options_(options) {
  point_.setup = make_setup(scene);
  shared_ = std::make_shared<SnapshotModel>(make_snapshot_model(model()));
  for (const Quantity& q : model().quantities) names_.push_back(q.name);
}

SteeredRun::~SteeredRun() = default;

Scratch& SteeredRun::scratch() {
  require(scratch_ != nullptr, "a run is started before it goes on");
  return *scratch_;
}

void SteeredRun::start() {
  fix_blas_threads(kBlasThreads);
  scratch_ = std::make_unique<Scratch>(model(), std::max(1, options_.threads));
  point_.state = make_initial_state(model());
  point_.times = {point_.state.time};
  start_trial(point_.state, scratch());  // gaps of the start, for the first picture
  search_contacts(model(), {}, scratch());
  point_.state.contacts = scratch().trial.contacts;
  point_.factorisations = 0;
  point_.may_keep_release = true;
  point_.quantities.clear();
  point_.states = make_state_schedule(scene(), model().end_time);
  point_.frames = make_frame_schedule(scene().frames, model().end_time);
}

StepResult SteeredRun::step(double halt_time) {
  fix_blas_threads(kBlasThreads);  // some of it is the calling thread's own
  StepResult result;
  IncrementReport& report = result.report;
  State& state = point_.state;
  const int increment_before = state.increment, factorisations_before = scratch().factorisations;
  report = advance(model(), state, scratch(), halt_time);
  judge_end(report);
  point_.factorisations += scratch().factorisations - factorisations_before;
  const bool is_last = report.outcome != Outcome::kRunning;
  result.has_moved = state.increment > increment_before;
  if (result.has_moved) {
    point_.times.push_back(state.time);
    point_.quantities = report.quantities;
  }
  const bool is_planned = point_.states.is_due(state.time), state_due = is_planned || is_last;
  result.for_frame = point_.frames.is_due(state.time) || is_last;
  // Between two states that are due, the first increment with a letting go.
  const bool release_due = !state_due && point_.may_keep_release && report.n_detached > 0;
  point_.may_keep_release = state_due || (point_.may_keep_release && !release_due);
  result.for_state = state_due || release_due;
  if (!is_last) result.why = is_planned ? "planned" : "letting go";
  return result;
}

std::shared_ptr<const Snapshot> SteeredRun::snapshot() {
  const PhaseTimer timer(scratch().times.snapshot);
  return make_snapshot(model(), state(), shared_, point_.times);
}

void SteeredRun::restore(const RunPoint& point) { point_ = point; }

void SteeredRun::set_source(const std::string& text, const std::vector<SceneOverride>& overrides) {
  source_ = text;
  auto setup = std::make_shared<RunSetup>(*point_.setup);
  setup->overrides = overrides;
  point_.setup = std::move(setup);
}

void SteeredRun::set(const std::string& key, const std::string& value) {
  const SceneChange change = change_ahead({*point_.setup, source_, state()}, key, value);
  State& state = point_.state;
  point_.setup = change.setup;
  const double end = model().end_time;
  state.next_dt = std::min(state.next_dt, model().increment.largest * end);
  if (change.has_turned && state.increment > 0) {  // as at a corner of a path: begin gently
    state.is_at_corner = true;
    state.next_dt = std::min(state.next_dt, 0.005 * end);
  }
  renew_schedules();
}

/// Of what was due up to now nothing is due again.
void SteeredRun::renew_schedules() {
  point_.states = make_state_schedule(scene(), model().end_time);
  point_.frames = make_frame_schedule(scene().frames, model().end_time);
  point_.states.is_due(state().time);
  point_.frames.is_due(state().time);
}

bool SteeredRun::has_met_stop(const IncrementReport& report) const {
  const Model& m = model();
  if (m.stop_quantity < 0 || report.quantities.empty()) return false;
  const double value = report.quantities[static_cast<std::size_t>(m.stop_quantity)];
  return (m.stop.below && value < *m.stop.below) || (m.stop.above && value > *m.stop.above);
}

/// Ends a run that has come to the end of its path, or to what the user asked for.
void SteeredRun::judge_end(IncrementReport& report) const {
  if (report.outcome != Outcome::kRunning) return;
  if (state().time >= model().end_time * (1.0 - 1e-12)) {
    report.outcome = Outcome::kCompleted;
    report.message = "the whole path was followed";
  } else if (has_met_stop(report)) {
    report.outcome = Outcome::kCompleted;
    report.message = "stop.quantity \"" + model().stop.quantity + "\" has passed its limit";
  } else if (options_.stop_requested != nullptr && options_.stop_requested->load()) {
    report.outcome = Outcome::kUserStop;
    report.message = "stopped by the user";
  }
}

RunSummary SteeredRun::summarise() const {
  RunSummary summary;
  summary.increments = state().increment;
  summary.time = state().time;
  summary.factorisations = point_.factorisations;
  summary.quantity_names = names_;
  summary.quantities = point_.quantities;
  if (scratch_ != nullptr) {
    summary.degrees_of_freedom = scratch_->matrix.size();
    summary.wall = scratch_->times;
  }
  return summary;
}

double find_crossing(const Path& path, double after, double value) {
  for (std::size_t i = 1; i < path.times.size(); ++i) {
    const double t1 = path.times[i], v1 = path.values[i];
    if (t1 <= after) continue;
    const double t0 = std::max(path.times[i - 1], after), v0 = path(t0);
    const bool rises_past = v0 < value && v1 >= value, falls_past = v0 > value && v1 <= value;
    if (!rises_past && !falls_past) continue;
    return v1 == value ? t1 : t0 + (t1 - t0) * (value - v0) / (v1 - v0);
  }
  return kNoHalt;
}

}  // namespace hydroscope
