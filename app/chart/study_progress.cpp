// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/study_progress.h"

#include <unistd.h>

#include <algorithm>

#include "app/progress.h"

namespace hydroscope {

std::string make_study_bar(int done, int all, int running, int failed, double elapsed,
                           const std::string& name) {
  constexpr int kWidth = 20;
  const int filled = all > 0 ? std::clamp(kWidth * done / all, 0, kWidth) : kWidth;
  std::string bar = "[" + std::string(static_cast<std::size_t>(filled), '#') +
                    std::string(static_cast<std::size_t>(kWidth - filled), '.') + "]  " +
                    std::to_string(done) + " of " + std::to_string(all) + " runs, " +
                    std::to_string(running) + " under way";
  if (failed > 0) bar += ", " + std::to_string(failed) + " failed";
  if (done > 0 && done < all) bar += ", about " + format_duration(elapsed / done * (all - done)) + " left";
  return bar + (name.empty() ? "" : "  " + name);
}

StudyProgress::StudyProgress(std::FILE* stream, int all)
    : stream_(stream), is_terminal_(isatty(fileno(stream)) == 1), all_(all) {}

void StudyProgress::add_done(bool is_success) {
  ++done_;
  if (!is_success) ++failed_;
}

void StudyProgress::show(int running, const std::string& name) {
  const auto now = Clock::now();
  const double pause = is_terminal_ ? 0.2 : 20.0;
  if (std::chrono::duration<double>(now - last_).count() < pause) return;
  last_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const std::string bar = make_study_bar(done_, all_, running, failed_, elapsed, name);
  std::fprintf(stream_, is_terminal_ ? "\r\033[K%s" : "%s\n",
               is_terminal_ ? bar.substr(0, 110).c_str() : bar.c_str());
  std::fflush(stream_);
}

void StudyProgress::finish() {
  if (is_terminal_) std::fprintf(stream_, "\r\033[K");
  std::fflush(stream_);
}

}  // namespace hydroscope
