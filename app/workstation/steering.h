// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>

#include "app/results/run_writer.h"
#include "app/workstation/board.h"
#include "app/workstation/command.h"
#include "app/workstation/contact_watch.h"
#include "app/workstation/halting.h"
#include "app/workstation/journal.h"
#include "app/workstation/restore_points.h"
#include "solver/base/error.h"
#include "solver/session/steered_run.h"

namespace hydroscope {

/// The steered analysis itself, for one thread: applies commands between increments, advances, keeps
/// results, branches and the journal on disk, and tells the board. Workstation gives it a thread; a replay
/// drives it by itself.
class Steering {
 public:
  /// Throws InputError and EnvironmentError before anything is written.
  Steering(const Scene& scene, const WorkstationOptions& options, Board& board);

  /// Checks and applies. Throws InputError for what cannot be done now; nothing has changed then.
  CommandReply apply(const Command& command, const std::string& who);
  bool is_running() const { return phase_ == WorkstationStatus::Phase::kRunning; }
  bool has_ended() const { return phase_ == WorkstationStatus::Phase::kEnded; }
  /// One increment, and all that follows from it. Never throws: what goes wrong ends the run with a message.
  void advance();
  /// Ends the run where it stands, unless it has ended.
  void finish();

  int branch() const { return branch_; }
  int increment() const { return run_.state().increment; }
  std::uint64_t state_hash() const { return calc_hash(run_.state()); }
  /// How the present branch stands; what describe_run() wants.
  RunSummary summarise() const;
  /// What disk or journal said; empty when all went well.
  const std::string& trouble() const { return trouble_; }

 private:
  using Phase = WorkstationStatus::Phase;

  void check_allowed(const Command& command) const;
  std::string go_on(const Command& command);
  std::string change(const Command& command);
  std::string go_back(int increment);
  void start_branch(int parent, const RunPoint& point);
  void leave_branch(const std::string& message);

  void judge(const StepResult& step);
  void record(const StepResult& step, double seconds);
  void keep(const char* why);
  void halt(const std::string& message);
  void end(Outcome outcome, const std::string& message);
  void fail(const std::string& message);
  void write_summary(Outcome outcome, const std::string& message);
  JournalEntry make_entry() const;
  void publish();
  /// Results that cannot be kept are not worth computing: the run ends, what is there is whole.
  template <class Action>
  void write(const Action& action) {
    if (!disk_works_) return;
    try {
      action();
    } catch (const EnvironmentError& error) {
      disk_works_ = false;
      fail(error.what());
    }
  }

  WorkstationOptions options_;
  Board& board_;
  SteeredRun run_;
  RunRecord record_;
  std::map<int, std::unique_ptr<RunWriter>> writers_;  ///< of all branches
  std::unique_ptr<Journal> journal_;
  RestorePoints points_;
  Halting halting_;
  ContactWatch watch_;
  int steps_left_ = -1;  ///< -1: any number
  int branch_ = 0, last_kept_ = -1;
  std::vector<int> parents_ = {-1};  ///< of all branches
  Phase phase_ = Phase::kPaused;
  Outcome outcome_ = Outcome::kRunning;
  std::string message_, trouble_;
  bool disk_works_ = true, is_summary_written_ = false;
  double solver_s_ = 0.0;
  IncrementReport last_;  ///< of the last increment, without events
  KeptState since_kept_;  ///< events since the state kept last
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace hydroscope
