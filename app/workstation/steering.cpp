// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/steering.h"

#include <algorithm>

#include "app/results/json.h"
#include "app/scene_record.h"
#include "solver/base/error.h"
#include "solver/scene/number_text.h"
#include "solver/session/scene_change.h"

namespace hydroscope {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<std::string> list_overrides(const std::vector<SceneOverride>& overrides) {
  std::vector<std::string> texts;
  for (const SceneOverride& item : overrides) texts.push_back(item.key + "=" + item.value);
  return texts;
}

std::string join(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : ", ") + std::to_string(number);
  return text;
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

CommandReply Steering::apply(const Command& command, const std::string& who) {
  check_allowed(command);
  JournalEntry entry = make_entry();
  std::string done;
  bool has_effect = true;
  switch (command.kind) {
    case Command::Kind::kRun:
    case Command::Kind::kStep:
    case Command::Kind::kUntil:
      done = go_on(command);
      break;
    case Command::Kind::kPause:
      has_effect = is_running();
      done = has_effect ? "paused" : "it is paused already";
      if (has_effect) halt("paused by " + who);
      break;
    case Command::Kind::kSet:
      done = change(command);
      break;
    case Command::Kind::kBack:
      done = go_back(command.increment);
      break;
    case Command::Kind::kStop:
      done = "stopped";
      break;
  }
  if (has_effect) {
    entry.who = who;
    entry.command = to_text(command);
    write([&] { journal_->add(entry); });
  }
  if (command.kind == Command::Kind::kStop) finish();
  publish();
  return {true, done, entry.increment};
}

void Steering::check_allowed(const Command& command) const {
  if (command.kind == Command::Kind::kBack) return;
  if (has_ended())
    throw InputError("the run has ended (" + message_ +
                     "); 'back INCREMENT' goes on from a kept state: " + join(points_.increments(branch_)));
  const bool is_at_end = run_.state().time >= run_.model().end_time * (1.0 - 1e-12);
  const bool goes_on = command.kind == Command::Kind::kRun || command.kind == Command::Kind::kStep ||
                       command.kind == Command::Kind::kUntil;
  if (goes_on && is_at_end) throw InputError("all paths end here; lead one of them on first (set KEY VALUE)");
}

std::string Steering::go_on(const Command& command) {
  if (command.kind == Command::Kind::kUntil) {
    halting_.arm(command.halt, run_);
  } else {
    halting_.disarm();
  }
  steps_left_ = command.kind == Command::Kind::kStep ? command.count : -1;
  phase_ = Phase::kRunning;
  message_ = steps_left_ > 0 ? to_text(command) : "running";
  return command.kind == Command::Kind::kUntil ? "running " + halting_.text() : message_;
}

std::string Steering::change(const Command& command) {
  const RunPoint before = run_.take_point();
  run_.set(command.key, command.value);
  const RunPoint after = run_.take_point();
  run_.restore(before);
  keep("set");  // as it was
  run_.restore(after);
  record_.overrides = list_overrides(after.setup->overrides);
  record_.end_time = run_.scene().end_time();
  write([&] { writers_[branch_]->set_overrides(record_.overrides); });
  if (halting_.is_armed()) {
    try {
      halting_.renew(run_);
    } catch (const InputError& error) {
      halt(halting_.text() + ": " + error.what());
    }
  }
  return command.key + " = " + record_.overrides.back().substr(command.key.size() + 1) + " from " +
         format_exact(run_.state().time) + " s on";
}

std::string Steering::go_back(int increment) {
  const RunPoint* point = nullptr;
  std::string known;
  int from = branch_;
  for (; from >= 0; from = parents_[static_cast<std::size_t>(from)]) {
    point = points_.find(from, increment);
    if (point != nullptr) break;
    known += (known.empty() ? "" : "; ") + ("branch " + std::to_string(from) + ": ") +
             join(points_.increments(from));
  }
  if (point == nullptr)
    throw InputError("increment " + std::to_string(increment) +
                     " is not among the states that can be gone back to (" + known +
                     "); memory holds a bounded number of them, spread over the run");
  const RunPoint target = *point;
  start_branch(from, target);
  return "back at increment " + std::to_string(increment) + "; branch " + std::to_string(branch_) +
         " begins, in " + writers_[branch_]->folder().path.string();
}

void Steering::start_branch(int parent, const RunPoint& point) {
  const int number = static_cast<int>(parents_.size()), increment = point.state.increment;
  RunRecord record = record_;
  record.overrides = list_overrides(point.setup->overrides);
  record.end_time = point.setup->scene.end_time();
  const ResultFolder folder = make_result_folder(options_.output / "branches" / std::to_string(number), true);
  auto writer = std::make_unique<RunWriter>(folder, record, *run_.snapshot_model(), run_.quantity_names());
  writer->carry_over(*writers_[parent], increment);
  write_whole_file(
      folder.path / "branch.json",
      Json(Json::Object{{"branch", number}, {"parent", parent}, {"increment", increment}}).write() + "\n");
  leave_branch("left at increment " + std::to_string(this->increment()) + " for branch " +
               std::to_string(number) + ", which begins at increment " + std::to_string(increment));
  writers_[number] = std::move(writer);
  parents_.push_back(parent);
  record_ = std::move(record);
  run_.restore(point);
  branch_ = number;
  board_.add_branch(parent, increment, folder.path);
  board_.set_newest(run_.snapshot());
  halting_.disarm();
  phase_ = Phase::kPaused;
  outcome_ = Outcome::kRunning;
  disk_works_ = true;
  is_summary_written_ = false;
  last_kept_ = increment;
  since_kept_ = {};
  const std::vector<IncrementReport> rows = board_.history(increment);
  last_ = rows.empty() ? IncrementReport{} : rows.front();
  message_ = "back at increment " + std::to_string(increment);
}

/// What is left is complete, too.
void Steering::leave_branch(const std::string& message) {
  if (has_ended()) return;
  keep("left");
  write_summary(Outcome::kUserStop, message);
}

void Steering::advance() {
  const Clock::time_point start = Clock::now();
  try {
    const StepResult step = run_.step(halting_.time());
    record(step, seconds_since(start));
    if (has_ended()) {  // the disk did not take it
    } else if (step.report.outcome != Outcome::kRunning) {
      end(step.report.outcome, step.report.message);
    } else if (const std::string reached = halting_.judge(step, run_); !reached.empty()) {
      halt(reached);
    } else if (steps_left_ > 0 && --steps_left_ == 0) {
      phase_ = Phase::kPaused;
      message_ = "paused after the steps asked for";
    }
  } catch (const std::bad_alloc&) {
    fail("out of memory");
  } catch (const std::exception& error) {  // a fault of the program: what is kept can still be looked at
    fail(std::string("internal error: ") + error.what());
  }
  publish();
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
    board_.set_newest(run_.snapshot());
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

/// Results that cannot be kept are not worth computing: the run ends, what is there is whole.
template <class Action>
void Steering::write(const Action& action) {
  if (!disk_works_) return;
  try {
    action();
  } catch (const EnvironmentError& error) {
    disk_works_ = false;
    fail(error.what());
  }
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
