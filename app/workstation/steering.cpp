// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/steering.h"

#include <algorithm>

#include "app/scene_record.h"
#include "solver/base/error.h"
#include "solver/session/scene_change.h"

namespace hydroscope {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

Steering::Steering(const Scene& scene, const WorkstationOptions& options, Board& board)
    : options_(options), board_(board), run_(scene, {options.threads, nullptr}) {
  check_result_folder(options.output, options.force);
  record_ = make_scene_record(run_.scene(), options.overrides, options.threads);
  JournalHead head = make_journal_head(scene, record_.scene_text);
  head.overrides = record_.overrides;
  head.threads = options.threads;
  run_.set_source(record_.scene_text, options.overrides);
  run_.start();

  const ResultFolder folder = make_result_folder(options.output, options.force);
  writers_[0] = std::make_unique<RunWriter>(folder, record_, *run_.snapshot_model(), run_.quantity_names());
  journal_ = std::make_unique<Journal>(folder.path / "journal.jsonl", head);
  points_.on_drop = [this](int branch, int increment) { board_.set_restorable(branch, increment, false); };
  board_.set_settable(settable_keys(run_.scene()));
  board_.set_model(run_.snapshot_model(), run_.quantity_names());
  board_.add_branch(-1, 0, folder.path);
  board_.set_newest(run_.snapshot());
  message_ = "ready";
  keep("first");
  publish();
}

void Steering::advance() {
  const Clock::time_point start = Clock::now();
  try {
    const StepResult step = run_.step(halting_.time());
    record(step, seconds_since(start));
    if (!has_ended()) judge(step);  // else the disk did not take it
  } catch (const std::bad_alloc&) {
    fail("out of memory");
  } catch (const std::exception& error) {  // a fault of the program: what is kept can still be looked at
    fail(std::string("internal error: ") + error.what());
  }
  publish();
}

void Steering::judge(const StepResult& step) {
  if (step.report.outcome != Outcome::kRunning) {
    end(step.report.outcome, step.report.message);
  } else if (const std::string reached = halting_.judge(step, run_); !reached.empty()) {
    halt(reached);
  } else if (steps_left_ > 0 && --steps_left_ == 0) {
    phase_ = Phase::kPaused;
    message_ = "paused after the steps asked for";
  }
}

void Steering::record(const StepResult& step, double seconds) {
  const IncrementReport& report = step.report;
  solver_s_ += seconds;
  if (step.has_moved) {
    write([&] { writers_[branch_]->add_increment(report); });
    board_.add_increment(report);
    board_.add_events(report.events);
    last_ = report;
    last_.events.clear();
    for (const ContactEvent& event : report.events) {
      since_kept_.touched += event.kind == EventKind::kTouch ? 1 : 0;
      since_kept_.retouched += event.kind == EventKind::kRetouch ? 1 : 0;
      since_kept_.slipped += event.kind == EventKind::kSlip ? 1 : 0;
      since_kept_.detached += event.kind == EventKind::kDetach ? 1 : 0;
    }
    const auto snapshot = run_.snapshot();
    board_.add_warnings(watch_.look(report, *snapshot));
    board_.set_newest(snapshot);
  }
  board_.add_warnings(report.warnings);
  if (step.for_state) keep(step.why);
}

void Steering::keep(const char* why) {
  if (last_kept_ == increment() || !disk_works_) return;
  write([&] { writers_[branch_]->add_state(*run_.snapshot()); });
  if (!disk_works_) return;
  KeptState kept = since_kept_;
  kept.branch = branch_;
  kept.increment = increment();
  kept.time = run_.state().time;
  kept.pressure = run_.state().pressure;
  kept.can_restore = true;
  kept.why = why;
  board_.add_kept(kept, writers_[branch_]->last_state());
  points_.add(branch_, run_.take_point());
  last_kept_ = increment();
  since_kept_ = {};
}

void Steering::halt(const std::string& message) {
  phase_ = Phase::kPaused;
  message_ = message;
  halting_.disarm();
  steps_left_ = -1;
  keep("halt");
}

void Steering::end(Outcome outcome, const std::string& message) {
  keep("last");
  if (has_ended()) return;  // the disk did not take it
  phase_ = Phase::kEnded;
  outcome_ = outcome;
  message_ = message;
  halting_.disarm();
  write_summary(outcome, message);
  JournalEntry entry = make_entry();
  entry.outcome = to_string(outcome);
  entry.message = message;
  write([&] { journal_->add(entry); });
}

void Steering::fail(const std::string& message) {
  phase_ = Phase::kEnded;
  outcome_ = Outcome::kRunning;  // none of those that a run comes to by itself
  message_ = message;
  trouble_ = message;
  halting_.disarm();
}

void Steering::finish() {
  if (!has_ended()) end(Outcome::kUserStop, "stopped by the user");
  publish();
}

RunSummary Steering::summarise() const {
  RunSummary summary = run_.summarise();
  summary.outcome = outcome_;
  summary.message = message_;
  summary.warnings = board_.warnings();
  return summary;
}

void Steering::write_summary(Outcome outcome, const std::string& message) {
  if (is_summary_written_) return;
  RunSummary summary = summarise();
  summary.outcome = outcome;
  summary.message = message;
  write([&] {
    writers_[branch_]->finish(summary, {seconds_since(start_), 0.0, 0.0});
    is_summary_written_ = true;
  });
}

JournalEntry Steering::make_entry() const {
  JournalEntry entry;
  entry.branch = branch_;
  entry.increment = increment();
  entry.time = run_.state().time;
  entry.state = state_hash();
  return entry;
}

void Steering::publish() {
  const State& state = run_.state();
  board_.update([&](WorkstationStatus& s) {
    s.phase = phase_;
    s.title = run_.model().title;
    s.increment = state.increment;
    s.time = state.time;
    s.end_time = run_.model().end_time;
    s.pressure = state.pressure;
    s.feed = run_.model().feed(state.time);
    s.n_contact = last_.n_contact;
    s.n_stick = last_.n_stick;
    s.n_slip = last_.n_slip;
    s.residual = last_.residual;
    s.thickness_min = *std::min_element(state.wall.begin(), state.wall.end());
    s.limited_by = state.increment > 0 ? to_string(last_.limited_by) : "";
    s.until = halting_.text();
    s.message = message_;
    s.outcome = !has_ended() ? "" : outcome_ == Outcome::kRunning ? "error" : to_string(outcome_);
    s.solver_s = solver_s_;
  });
}

}  // namespace hydroscope
