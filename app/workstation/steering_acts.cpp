// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands do.
#include "app/results/json.h"
#include "app/workstation/steering.h"
#include "solver/base/error.h"
#include "solver/scene/number_text.h"

namespace hydroscope {

namespace {

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
  watch_ = {};
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

}  // namespace hydroscope
