// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "solver/increment/report.h"
#include "solver/scene/scene.h"
#include "solver/session/error_estimate.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

struct RunOptions {
  int threads = 2;
  const std::atomic<bool>* stop_requested = nullptr;  ///< checked between increments
};

/// What a run tells its owner; called on the solver's thread, in order.
struct RunObserver {
  /// Once, before the first increment: the model as placed, and how large it is.
  std::function<void(const SnapshotModel&, int degrees_of_freedom, double end_time)> on_start;
  /// After each accepted increment.
  std::function<void(const IncrementReport&)> on_increment;
  /// At the initial state, at every planned time (states and frames) and at
  /// the last good state. `for_state` / `for_frame` say what it is meant for.
  std::function<void(std::shared_ptr<const Snapshot>, bool for_state, bool for_frame)> on_snapshot;
};

struct RunSummary {
  Outcome outcome = Outcome::kRunning;
  std::string message;
  int increments = 0;
  int factorisations = 0;
  int degrees_of_freedom = 0;
  double time = 0.0;  ///< process time reached [s]
  PhaseTimes wall;    ///< [s]
  std::vector<std::string> quantity_names;
  std::vector<double> quantities;  ///< at the last good state
  std::vector<Warning> warnings;
  std::optional<ErrorEstimate> estimate;  ///< where the scene asks for an accuracy
};

/// Builds the model of a scene (throws InputError before anything is written)
/// and runs it to its end. A scene that asks for an accuracy is chosen for first, and a cheap companion
/// that runs afterwards estimates the error; it is not part of the observer's story. Deterministic: bit for
/// bit the same for any number of threads.
class Run {
 public:
  Run(const Scene& scene, const RunOptions& options);
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// The scene as it is run: with what `accuracy` has chosen.
  const Scene& scene() const;
  const SnapshotModel& snapshot_model() const;
  const std::vector<std::string>& quantity_names() const;
  RunSummary run(const RunObserver& observer);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hydroscope
