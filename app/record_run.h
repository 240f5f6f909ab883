// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "app/exit_code.h"
#include "app/progress.h"
#include "app/results/run_writer.h"

namespace hydroscope {

/// Where frames go; both may throw EnvironmentError. Empty functions: no frames.
struct FrameSink {
  std::function<void(std::shared_ptr<const Snapshot>)> submit;
  /// Waits for the last frame; returns the seconds spent drawing.
  std::function<double()> finish;
};

struct RecordedRun {
  RunSummary summary;
  ExitCode exit_code = ExitCode::kDone;
  double render_time = 0.0;  ///< [s]
  std::string trouble;       ///< what disk or renderer said; empty when all went well
  bool is_summary_written = false;
};

/// Runs `solve` (a Run, or a stand-in) and sends what it reports to disk, frames and
/// terminal. When the disk fails the solver is stopped between increments by
/// `stop`, and no summary is written: what is there is whole. When the renderer
/// fails the run goes on without frames. Errors of the solver itself pass through.
RecordedRun record_run(const std::function<RunSummary(const RunObserver&)>& solve, RunWriter& writer,
                       const FrameSink& frames, Progress& progress, std::atomic<bool>& stop);

/// What the user reads at the end: outcome, how far, quantities, and their errors where an `accuracy` is
/// asked for.
std::string describe_run(const RecordedRun& run, double end_time, double accuracy = 0.0);

}  // namespace hydroscope
