// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdio>
#include <string>

#include "app/workstation/workstation.h"

namespace hydroscope {

/// Lines from a file descriptor, waited for in pieces so that other things can be looked after meanwhile.
class LineReader {
 public:
  explicit LineReader(int descriptor) : descriptor_(descriptor) {}
  enum class Result { kLine, kNothingYet, kEnd };
  Result read(std::string& line, std::chrono::milliseconds patience);

 private:
  int descriptor_;
  std::string buffer_;
  bool has_ended_ = false;
};

/// A terminal, or a script, that steers a workstation and looks at it.
///
/// A script waits after each `run`, `until` and `step` until the analysis halts, and ends at the first error.
/// A terminal does not wait; it says when the analysis halts.
class Console {
 public:
  struct Settings {
    int input = 0;  ///< file descriptor
    std::FILE* output = stdout;
    bool is_terminal = false;
    std::atomic<bool>* interrupt = nullptr;  ///< Ctrl-C; lowered again when it was seen to
  };
  enum class End { kDone, kInterrupted };

  Console(Workstation& workstation, const Settings& settings)
      : workstation_(workstation), settings_(settings), reader_(settings.input) {}
  /// Until `quit` or the end of the input. Throws InputError "standard input:LINE: ..." for an error in a
  /// script.
  End run();

 private:
  /// False: quit.
  bool obey(const std::string& line);
  bool look(const std::string& word, const std::string& rest);
  void wait_halted();
  bool take_interrupt();
  void say(const std::string& text);
  void prompt();
  void tell_news();

  Workstation& workstation_;
  Settings settings_;
  LineReader reader_;
  bool was_running_ = false, is_interrupted_ = false;
  std::size_t told_warnings_ = 0;
};

}  // namespace hydroscope
