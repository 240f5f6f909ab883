// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "solver/increment/scratch.h"
#include "solver/scene/scene_source.h"
#include "solver/session/run.h"
#include "solver/session/schedule.h"

namespace hydroscope {

constexpr double kNoHalt = std::numeric_limits<double>::infinity();

/// The scene as it stands and what was built of it; replaced as a whole when something is set.
struct RunSetup {
  Scene scene;                           ///< with what `accuracy` has chosen
  std::vector<SceneOverride> overrides;  ///< from the command line, then from acts of steering
  Model model;
};

/// Everything that a run goes on from; a plain value. The setup is shared.
struct RunPoint {
  std::shared_ptr<const RunSetup> setup;
  State state;
  std::vector<double> times;  ///< ends of increments so far, 0 first [s]
  Schedule states, frames;
  bool may_keep_release = true;    ///< no letting go was kept since the last planned state
  int factorisations = 0;          ///< up to here
  std::vector<double> quantities;  ///< at the last accepted increment
};

/// Memory that a point holds for itself [bytes].
std::size_t calc_size(const RunPoint& point);

/// What one call of SteeredRun::step() did.
struct StepResult {
  IncrementReport report;
  bool has_moved = false;    ///< an increment was accepted
  bool for_state = false;    ///< its state is to be kept
  bool for_frame = false;    ///< and drawn
  const char* why = "last";  ///< what it is kept for: "planned", "letting go", "last"
};

/// An analysis that its owner advances, increment by increment: what Run is made of. It can be halted at a
/// time, go back to any point that was taken, and change what lies ahead. Not for several threads at once.
class SteeredRun {
 public:
  /// Builds the model. Throws InputError.
  SteeredRun(const Scene& scene, const RunOptions& options);
  ~SteeredRun();
  SteeredRun(const SteeredRun&) = delete;
  SteeredRun& operator=(const SteeredRun&) = delete;

  /// Stands at time 0, with the gaps of the start. Before anything of a state is asked for.
  void start();
  /// One increment (advance()) that does not go past `halt_time` [s], and everything that belongs to it.
  StepResult step(double halt_time = kNoHalt);
  std::shared_ptr<const Snapshot> snapshot();

  RunPoint take_point() const { return point_; }
  /// Goes on from a point of this run.
  void restore(const RunPoint& point);

  /// The text that the scene was read from: needed by set().
  void set_source(const std::string& text, const std::vector<SceneOverride>& overrides);
  /// Changes what is ahead. The value is read as strictly as in a scene; a path that begins after the present
  /// time goes on from the present value. Throws InputError; nothing has changed then.
  void set(const std::string& key, const std::string& value);

  const Scene& scene() const { return point_.setup->scene; }
  const Model& model() const { return point_.setup->model; }
  const State& state() const { return point_.state; }
  std::shared_ptr<const SnapshotModel> snapshot_model() const { return shared_; }
  const std::vector<std::string>& quantity_names() const { return names_; }
  /// How far it has come; outcome, message and warnings are the caller's.
  RunSummary summarise() const;

 private:
  void judge_end(IncrementReport& report) const;
  bool has_met_stop(const IncrementReport& report) const;
  void renew_schedules();
  Scratch& scratch();

  RunOptions options_;
  RunPoint point_;
  std::shared_ptr<const SnapshotModel> shared_;
  std::vector<std::string> names_;
  std::string source_;
  std::unique_ptr<Scratch> scratch_;
};

/// The first time after `after` at which the path takes `value`; infinity if it never does.
double find_crossing(const Path& path, double after, double value);

}  // namespace hydroscope
