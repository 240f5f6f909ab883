// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/run.h"

#include "solver/session/companion_run.h"
#include "solver/session/steered_run.h"

namespace hydroscope {

struct Run::Impl {
  Impl(const Scene& scene, const RunOptions& o) : options(o), run(scene, o) {}
  RunOptions options;
  SteeredRun run;
};

Run::Run(const Scene& scene, const RunOptions& options) : impl_(std::make_unique<Impl>(scene, options)) {}
Run::~Run() = default;
const Scene& Run::scene() const { return impl_->run.scene(); }
const SnapshotModel& Run::snapshot_model() const { return *impl_->run.snapshot_model(); }
const std::vector<std::string>& Run::quantity_names() const { return impl_->run.quantity_names(); }

RunSummary Run::run(const RunObserver& observer) {
  SteeredRun& run = impl_->run;
  run.start();
  if (observer.on_start)
    observer.on_start(*run.snapshot_model(), run.summarise().degrees_of_freedom, run.model().end_time);
  const auto show = [&](bool for_state, bool for_frame) {
    if (observer.on_snapshot) observer.on_snapshot(run.snapshot(), for_state, for_frame);
  };
  show(true, true);
  QuantityHistory history;  // for the estimate
  std::vector<Warning> warnings;
  StepResult step;
  while (step.report.outcome == Outcome::kRunning) {
    step = run.step();
    if (step.has_moved) {
      if (observer.on_increment) observer.on_increment(step.report);
      history.times.push_back(run.state().time);
      history.values.push_back(step.report.quantities);
    }
    if (step.for_state || step.for_frame) show(step.for_state, step.for_frame);
    warnings.insert(warnings.end(), step.report.warnings.begin(), step.report.warnings.end());
  }
  RunSummary summary = run.summarise();
  summary.outcome = step.report.outcome;
  summary.message = step.report.message;
  summary.warnings = std::move(warnings);
  if (run.scene().accuracy > 0.0 && summary.outcome != Outcome::kUserStop)
    add_estimate(run.scene(), impl_->options, history, summary);
  return summary;
}

}  // namespace hydroscope
