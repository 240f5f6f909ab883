// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdio>
#include <string>

namespace hydroscope {

/// How a study is getting on: a bar that renews itself on a terminal, a line now and then elsewhere.
class StudyProgress {
 public:
  StudyProgress(std::FILE* stream, int all);

  void add_done(bool is_success);
  /// `running` processes; `name` of one of them.
  void show(int running, const std::string& name);
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  std::FILE* stream_;
  bool is_terminal_;
  int all_, done_ = 0, failed_ = 0;
  Clock::time_point start_ = Clock::now(), last_ = start_ - std::chrono::hours(1);
};

/// "[####......]  12 of 60 runs, 2 under way, 1 failed, about 3:20 left  slice/none+newton".
std::string make_study_bar(int done, int all, int running, int failed, double elapsed,
                           const std::string& name);

}  // namespace hydroscope
