// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/exit_code.h"
#include "solver/increment/report.h"
#include "solver/scene/scene.h"
#include "solver/scene/scene_source.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// What everybody may know of an analysis at one moment; a plain value.
struct WorkstationStatus {
  std::uint64_t version = 0;  ///< grows with every change
  enum class Phase { kPaused, kRunning, kEnded } phase = Phase::kPaused;
  bool can_steer = true;  ///< false: a finished run's folder is looked at
  std::string title;
  int branch = 0;
  int increment = 0;
  double time = 0.0, end_time = 0.0;  ///< [s]
  double pressure = 0.0;              ///< [MPa]
  double feed = 0.0;                  ///< [mm]
  int n_contact = 0, n_stick = 0, n_slip = 0;
  double residual = 0.0;
  double thickness_min = 0.0;  ///< [mm]
  std::string limited_by;      ///< what governed the last increment
  std::string until;           ///< the halt that is waited for, as text; empty: none
  std::string message;         ///< why it halted or ended, for the user
  std::string outcome;         ///< empty while it goes on
  int n_warnings = 0, n_kept = 0, n_events = 0;
  double solver_s = 0.0;  ///< wall time spent in increments
};

/// A state that can be looked at, and (if `can_restore`) gone back to.
struct KeptState {
  int branch = 0, increment = 0;
  double time = 0.0, pressure = 0.0;                          ///< [s], [MPa]
  int touched = 0, slipped = 0, detached = 0, retouched = 0;  ///< events since the kept state before
  bool can_restore = false;
  std::string why;  ///< "planned", "halt", "letting go", "first", "last"
};

/// What became of a command.
struct CommandReply {
  bool is_done = false;
  std::string text;   ///< what was done, or the error with what was expected
  int increment = 0;  ///< between which increment and the next it took effect
};

struct WorkstationOptions {
  int threads = 2;
  std::vector<SceneOverride> overrides;
  std::filesystem::path output;  ///< result folder of branch 0
  bool force = false;
};

/// An analysis that is steered from outside while a thread of its own advances it. Every function may be
/// called from any thread; none waits for an increment except where it says so. Commands take effect between
/// increments, in the order in which they come, and are written to `journal.jsonl` of the result folder
/// with their increment. No lock is held while computing.
class Workstation {
 public:
  /// Builds the model, makes the result folder and stands paused at the start. Throws InputError and
  /// EnvironmentError before anything is written.
  Workstation(const Scene& scene, const WorkstationOptions& options);
  /// A finished (or broken off) run's folder, to be looked at only.
  explicit Workstation(const std::filesystem::path& results);
  /// Ends the run after the increment at work and writes the summary.
  ~Workstation();
  Workstation(const Workstation&) = delete;
  Workstation& operator=(const Workstation&) = delete;

  /// Parses, checks and applies; waits for the increment at work. Never throws for bad commands.
  CommandReply command(const std::string& text, const std::string& who);

  WorkstationStatus status() const;
  /// Waits until the version differs from `seen`, or for `patience`.
  WorkstationStatus wait_status(std::uint64_t seen, std::chrono::milliseconds patience) const;
  /// Waits until nothing runs any more (for consoles and scripts).
  WorkstationStatus wait_halted() const;

  std::shared_ptr<const Snapshot> newest() const;
  /// A kept state; null when there is none of this increment.
  std::shared_ptr<const Snapshot> kept(int branch, int increment) const;
  std::vector<KeptState> kept_states() const;

  /// Rows of the present branch from increment `from` on (reports without events).
  std::vector<IncrementReport> history(int from = 0) const;
  std::vector<std::string> quantity_names() const;
  /// Contact events of the present branch from number `from` on, and warnings.
  std::vector<ContactEvent> events(std::size_t from = 0) const;
  std::vector<Warning> warnings() const;
  /// Where the present branch lies on disk.
  std::filesystem::path folder() const;
  /// Keys that `set` may change.
  std::vector<std::string> settable() const;

  /// Ends the run as the destructor does, and says how it stands. Commands are refused from then on; all else
  /// goes on answering.
  WorkstationStatus close();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The program's exit code for a run that has ended so.
ExitCode find_exit_code(const WorkstationStatus& status);

}  // namespace hydroscope
