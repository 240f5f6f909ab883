// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/record_run.h"

#include <array>
#include <chrono>

#include "solver/base/error.h"
#include "solver/session/companion_run.h"

namespace hydroscope {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Sends one run to its three receivers and remembers which of them failed.
class Recorder {
 public:
  Recorder(RunWriter& writer, const FrameSink& frames, Progress& progress, std::atomic<bool>& stop)
      : writer_(writer), frames_(frames), progress_(progress), stop_(stop) {}

  RunObserver make_observer() {
    RunObserver observer;
    observer.on_start = [this](const SnapshotModel&, int, double end_time) { progress_.start(end_time); };
    observer.on_increment = [this](const IncrementReport& report) { add_increment(report); };
    observer.on_snapshot = [this](std::shared_ptr<const Snapshot> snapshot, bool for_state, bool for_frame) {
      if (for_state) write([&] { writer_.add_state(*snapshot); });
      if (for_frame) submit(std::move(snapshot));
    };
    return observer;
  }

  RecordedRun finish(RunSummary summary) {
    RecordedRun run;
    if (frames_.finish) draw([&] { run.render_time = frames_.finish(); });
    progress_.finish();
    const ProgramTimes times{seconds_since(start_), run.render_time, write_time_};
    if (disk_works_) write([&] { writer_.finish(summary, times); });
    run.is_summary_written = disk_works_;
    run.exit_code = disk_works_ && renderer_works_ ? find_exit_code(summary.outcome) : ExitCode::kEnvironment;
    run.summary = std::move(summary);
    run.trouble = trouble_;
    return run;
  }

 private:
  void add_increment(const IncrementReport& report) {
    write([&] { writer_.add_increment(report); });
    for (const Warning& warning : report.warnings)
      progress_.note("warning (" + warning.kind + "): " + warning.text);
    progress_.update(report);
  }

  template <class Action>
  void write(const Action& action) {
    if (!disk_works_) return;
    const auto start = Clock::now();
    try {
      action();
    } catch (const EnvironmentError& error) {
      disk_works_ = false;
      report_trouble(error.what());
      stop_ = true;  // results that cannot be kept are not worth computing
    }
    write_time_ += seconds_since(start);
  }

  template <class Action>
  void draw(const Action& action) {
    if (!renderer_works_) return;
    try {
      action();
    } catch (const std::exception& error) {  // whatever breaks there, the solver's work is not lost
      renderer_works_ = false;
      report_trouble(std::string("frames end here: ") + error.what());
    }
  }

  void submit(std::shared_ptr<const Snapshot> snapshot) {
    if (frames_.submit) draw([&] { frames_.submit(std::move(snapshot)); });
  }

  void report_trouble(const std::string& text) {
    trouble_ += (trouble_.empty() ? "" : "; ") + text;
    progress_.note("error: " + text);
  }

  RunWriter& writer_;
  const FrameSink& frames_;
  Progress& progress_;
  std::atomic<bool>& stop_;
  Clock::time_point start_ = Clock::now();
  double write_time_ = 0.0;
  bool disk_works_ = true, renderer_works_ = true;
  std::string trouble_;
};

/// As many digits as a reader wants; the files have all of them.
std::string print_short(double number) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

}  // namespace

RecordedRun record_run(const std::function<RunSummary(const RunObserver&)>& solve, RunWriter& writer,
                       const FrameSink& frames, Progress& progress, std::atomic<bool>& stop) {
  Recorder recorder(writer, frames, progress, stop);
  return recorder.finish(solve(recorder.make_observer()));
}

std::string describe_run(const RecordedRun& run, double end_time, double accuracy) {
  const RunSummary& s = run.summary;
  std::string text = std::string(to_string(s.outcome)) + ": reached " + print_short(s.time) + " s of " +
                     print_short(end_time) + " s in " + std::to_string(s.increments) + " increments, " +
                     std::to_string(s.factorisations) + " factorisations\n";
  if (!s.message.empty()) text += s.message + "\n";
  if (!s.warnings.empty()) text += std::to_string(s.warnings.size()) + " warnings; see summary.json\n";
  for (size_t i = 0; i < s.quantities.size() && i < s.quantity_names.size(); ++i) {
    text += "  " + s.quantity_names[i] + " = " + print_short(s.quantities[i]) + "\n";
  }
  if (s.estimate) text += describe_estimate(*s.estimate, accuracy);
  return text;
}

}  // namespace hydroscope
