// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hydroscope {
namespace {

double find_fraction(double time, double end_time) {
  return end_time > 0.0 ? std::clamp(time / end_time, 0.0, 1.0) : 0.0;
}

/// Says nothing before there is something to go by.
std::string describe_time_left(double fraction, double elapsed) {
  if (fraction < 0.01 || elapsed < 1.0) return {};
  return format_duration(elapsed * (1.0 - fraction) / fraction) + " left";
}

int find_columns(std::FILE* stream) {
  winsize size{};
  const bool known = ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

template <class... Values>
std::string print(const char* format, Values... values) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

}  // namespace

std::string format_duration(double seconds) {
  const long whole = std::lround(std::clamp(seconds, 0.0, 1e7));
  if (whole < 3600) return print("%ld:%02ld", whole / 60, whole % 60);
  return print("%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string make_progress_bar(const IncrementReport& r, double end_time, double elapsed, int columns) {
  const double fraction = find_fraction(r.time, end_time);
  const std::string counts = print(" %3.0f %%  %6.2f MPa  inc %-4d  contact %-5d  %-13s  ", 100.0 * fraction,
                                   r.pressure, r.increment, r.n_contact, to_string(r.limited_by));
  const std::string figures = counts + describe_time_left(fraction, elapsed);
  // Room for the longest time left, so that the bar keeps its length.
  const int time_left = static_cast<int>(std::string("1:00:00 left").size());
  const int width = std::max(static_cast<int>(figures.size()), static_cast<int>(counts.size()) + time_left);
  const int room = std::clamp(columns - 3 - width, 0, 40);
  std::string bar;
  if (room >= 5) {
    const auto done = static_cast<size_t>(std::lround(fraction * room));
    bar = "[" + std::string(done, '#') + std::string(static_cast<size_t>(room) - done, '.') + "]";
  }
  return (bar + figures).substr(0, static_cast<size_t>(std::max(columns - 1, 0)));
}

std::string make_progress_line(const IncrementReport& r, double end_time, double elapsed) {
  const std::string left = describe_time_left(find_fraction(r.time, end_time), elapsed);
  return print("%.4g s of %.4g s, %.2f MPa, increment %d, %d in contact, limited by %s", r.time, end_time,
               r.pressure, r.increment, r.n_contact, to_string(r.limited_by)) +
         (left.empty() ? "" : ", about " + left);
}

Progress::Progress(std::FILE* stream) : stream_(stream), is_terminal_(isatty(fileno(stream)) == 1) {}

void Progress::start(double end_time) {
  end_time_ = end_time;
  start_ = last_shown_ = Clock::now();
}

bool Progress::is_due() {
  const auto now = Clock::now();
  const auto seconds = [now](Clock::time_point since) {
    return std::chrono::duration<double>(now - since).count();
  };
  // A log wants few lines: one every ten seconds, or a minute when the run is long.
  const double pause = is_terminal_ ? 0.1 : (seconds(start_) < 120.0 ? 10.0 : 60.0);
  if (seconds(last_shown_) < pause) return false;
  last_shown_ = now;
  return true;
}

void Progress::show(const std::string& bar, const std::string& line) {
  if (is_terminal_)
    std::fprintf(stream_, "\r\033[K%s", bar.c_str());
  else
    std::fprintf(stream_, "%s\n", line.c_str());
  std::fflush(stream_);
}

void Progress::update(const IncrementReport& report) {
  if (!is_due()) return;
  const double elapsed = std::chrono::duration<double>(last_shown_ - start_).count();
  show(make_progress_bar(report, end_time_, elapsed, find_columns(stream_)),
       make_progress_line(report, end_time_, elapsed));
}

void Progress::update_drawing(int done, int all) {
  if (!is_due()) return;
  const std::string line = print("drawing: %d of %d", done, all);
  show(line, line);
}

void Progress::note(const std::string& line) {
  std::fprintf(stream_, "%s%s\n", is_terminal_ ? "\r\033[K" : "", line.c_str());
  std::fflush(stream_);
}

void Progress::finish() {
  if (is_terminal_) std::fprintf(stream_, "\r\033[K");
  std::fflush(stream_);
}

}  // namespace hydroscope
