// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

#include "solver/increment/report.h"

namespace hydroscope {

/// How a run is getting on: a bar that renews itself on a terminal, a line now and
/// then elsewhere.
class Progress {
 public:
  /// Writes to `stream`; asks it whether it is a terminal.
  explicit Progress(std::FILE* stream);

  void start(double end_time);  ///< [s] of process time
  void update(const IncrementReport& report);
  /// Frames that are drawn after the run: `done` of `all`.
  void update_drawing(int done, int all);
  /// One line that stays, such as a warning.
  void note(const std::string& line);
  /// Clears the bar.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  /// Whether enough time has passed to show something again; notes the time if so.
  bool is_due();
  void show(const std::string& bar, const std::string& line);

  std::FILE* stream_;
  bool is_terminal_;
  double end_time_ = 0.0;
  Clock::time_point start_ = Clock::now(), last_shown_ = start_;
};

/// "0:07", "1:02:03".
std::string format_duration(double seconds);

/// "[####......]  41 %  14.32 MPa  inc 57  contact 321  touch  1:05 left", at most `columns` wide.
std::string make_progress_bar(const IncrementReport& report, double end_time, double elapsed, int columns);

/// The same as a sentence for logs.
std::string make_progress_line(const IncrementReport& report, double end_time, double elapsed);

}  // namespace hydroscope
