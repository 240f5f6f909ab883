// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/results/result_folder.h"
#include "solver/base/whole_file.h"
#include "solver/session/run.h"

namespace hydroscope {

/// What a run was started with, kept beside its results.
struct RunRecord {
  std::string scene_file;                           ///< as named by the user
  std::string scene_text;                           ///< its content
  std::vector<std::string> overrides;               ///< "key=value", in order
  std::map<std::string, std::string> tool_reports;  ///< health of each tool's mesh: tools/NAME.txt
  int threads = 1;
  double end_time = 0.0;          ///< process time of the whole scene [s]
  std::string renderer{};         ///< who draws the frames; empty: nobody
  double accuracy = 0.0;          ///< relative error that was asked for; 0: none
  std::vector<Choice> choices{};  ///< what was chosen for it
};

/// Seconds that the program itself spent, for the summary.
struct ProgramTimes {
  double total = 0.0, render = 0.0, write = 0.0;
};

/// Puts a run on disk while it goes on. history.csv and events.csv grow line by
/// line, everything else appears whole; summary.json comes last, so that a folder
/// without it holds an unfinished run. Every function throws EnvironmentError.
class RunWriter {
 public:
  /// Writes scene, model and tools, and the heads of the two tables.
  RunWriter(ResultFolder folder, const RunRecord& record, const SnapshotModel& model,
            const std::vector<std::string>& quantity_names);

  void add_increment(const IncrementReport& report);
  /// A state of an increment that is already there is not written twice.
  void add_state(const Snapshot& snapshot);
  void finish(const RunSummary& summary, const ProgramTimes& times);
  /// Takes over what another run of the same model has written up to `increment`; before anything else is
  /// added.
  void carry_over(const RunWriter& from, int increment);
  /// What replaces keys of the scene from now on.
  void set_overrides(const std::vector<std::string>& overrides);

  const ResultFolder& folder() const { return folder_; }
  int states() const { return static_cast<int>(state_times_.size()); }
  /// Where the state that was added last lies.
  std::filesystem::path last_state() const { return folder_.path / ResultFolder::state_name(states() - 1); }

 private:
  std::string tool_name(int tool) const;
  void write_state_index();

  ResultFolder folder_;
  RunRecord record_;
  std::vector<std::string> tool_names_;
  LineFile history_;
  LineFile events_;
  std::vector<double> state_times_;
  std::vector<int> state_increments_;
};

/// Most memory that the process ever held [MB].
double find_peak_memory();

}  // namespace hydroscope
