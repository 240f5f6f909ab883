// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/run.h"

#include <algorithm>
#include <cmath>

#include "solver/increment/advance.h"
#include "solver/increment/contact_step.h"
#include "solver/increment/equations.h"
#include "solver/session/accuracy_choices.h"
#include "solver/session/build_model.h"
#include "solver/session/companion_run.h"
#include "solver/session/make_snapshot.h"

namespace hydroscope {

namespace {

constexpr int kBlasThreads = 1;

/// Process times at which something is to be shown, passed one after the other.
class Schedule {
 public:
  Schedule(int number, double interval, bool is_every, double end) : is_every_(is_every) {
    const double step = interval > 0.0 ? interval : end / std::max(number, 1);
    for (double t = step; t < end * (1.0 - 1e-9); t += step) times_.push_back(t);
  }
  bool is_due(double time) {
    if (is_every_) return true;
    bool due = false;
    while (next_ < times_.size() && time >= times_[next_] * (1.0 - 1e-12)) {
      ++next_;
      due = true;
    }
    return due;
  }

 private:
  bool is_every_;
  std::vector<double> times_;
  std::size_t next_ = 0;
};

Schedule make_frame_schedule(const FramesScene& frames, double end) {
  return {frames.number, frames.pick == "interval" ? frames.interval : 0.0, frames.pick == "every", end};
}

}  // namespace

struct Run::Impl {
  Impl(const Scene& s, const RunOptions& o)
      : scene(choose_for_accuracy(s)),
        options(o),
        model(build_model(scene)),
        shared(std::make_shared<SnapshotModel>(make_snapshot_model(model))) {
    for (const Quantity& q : model.quantities) names.push_back(q.name);
  }
  Scene scene;
  RunOptions options;
  Model model;
  std::shared_ptr<const SnapshotModel> shared;
  std::vector<std::string> names;

  bool has_met_stop(const IncrementReport& report) const {
    if (model.stop_quantity < 0) return false;
    const double value = report.quantities[static_cast<std::size_t>(model.stop_quantity)];
    return (model.stop.below && value < *model.stop.below) || (model.stop.above && value > *model.stop.above);
  }

  /// Ends a run that has come to the end of its path, or to what the user asked for.
  void judge_end(const State& state, IncrementReport& report) const {
    if (report.outcome != Outcome::kRunning) return;
    if (state.time >= model.end_time * (1.0 - 1e-12)) {
      report.outcome = Outcome::kCompleted;
      report.message = "the whole path was followed";
    } else if (has_met_stop(report)) {
      report.outcome = Outcome::kCompleted;
      report.message = "stop.quantity \"" + model.stop.quantity + "\" has passed its limit";
    } else if (options.stop_requested != nullptr && options.stop_requested->load()) {
      report.outcome = Outcome::kUserStop;
      report.message = "stopped by the user";
    }
  }
};

Run::Run(const Scene& scene, const RunOptions& options) : impl_(std::make_unique<Impl>(scene, options)) {}
Run::~Run() = default;
const Scene& Run::scene() const { return impl_->scene; }
const SnapshotModel& Run::snapshot_model() const { return *impl_->shared; }
const std::vector<std::string>& Run::quantity_names() const { return impl_->names; }

RunSummary Run::run(const RunObserver& observer) {
  const Model& model = impl_->model;
  fix_blas_threads(kBlasThreads);
  Scratch scratch(model, std::max(1, impl_->options.threads));
  State state = make_initial_state(model);
  std::vector<double> times = {state.time};  // of the increments
  start_trial(state, scratch);               // gaps of the start, for the first picture
  search_contacts(model, {}, scratch);
  state.contacts = scratch.trial.contacts;

  RunSummary summary;
  QuantityHistory history;  // for the estimate
  summary.quantity_names = impl_->names;
  summary.degrees_of_freedom = scratch.matrix.size();
  if (observer.on_start) observer.on_start(*impl_->shared, summary.degrees_of_freedom, model.end_time);
  const auto show = [&](bool for_state, bool for_frame) {
    if (!observer.on_snapshot) return;
    std::shared_ptr<const Snapshot> snapshot;
    {
      const PhaseTimer timer(scratch.times.snapshot);
      snapshot = make_snapshot(model, state, impl_->shared, times);
    }
    observer.on_snapshot(snapshot, for_state, for_frame);
  };
  show(true, true);
  Schedule states(impl_->scene.states.number, 0.0, false, model.end_time);
  Schedule frames = make_frame_schedule(impl_->scene.frames, model.end_time);
  bool may_keep_release = true;  // between two states that are due, the first increment with a letting go
  while (summary.outcome == Outcome::kRunning) {
    const int before = state.increment;
    IncrementReport report = advance(model, state, scratch);
    impl_->judge_end(state, report);
    const bool is_last = report.outcome != Outcome::kRunning;
    if (state.increment > before) {
      times.push_back(state.time);
      if (observer.on_increment) observer.on_increment(report);
      summary.quantities = report.quantities;
      history.times.push_back(state.time);
      history.values.push_back(report.quantities);
    }
    const bool state_due = states.is_due(state.time) || is_last,
               frame_due = frames.is_due(state.time) || is_last;
    const bool release_due = !state_due && may_keep_release && report.n_detached > 0;
    may_keep_release = state_due || (may_keep_release && !release_due);
    if (state_due || release_due || frame_due) show(state_due || release_due, frame_due);
    summary.outcome = report.outcome;
    summary.message = report.message;
    for (const Warning& w : report.warnings) summary.warnings.push_back(w);
  }
  summary.increments = state.increment;
  summary.factorisations = scratch.factorisations;
  summary.time = state.time;
  summary.wall = scratch.times;
  if (impl_->scene.accuracy > 0.0 && summary.outcome != Outcome::kUserStop)
    add_estimate(impl_->scene, impl_->options, history, summary);
  return summary;
}

}  // namespace hydroscope
