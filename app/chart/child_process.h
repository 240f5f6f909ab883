// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace hydroscope {

/// A program under way, its output in a file. Ends with the program that started it, and does not
/// hear the terminal's Ctrl-C: whoever started it passes that on.
class ChildProcess {
 public:
  /// Throws EnvironmentError when it cannot be started.
  ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& output);
  /// Kills it when it is still there.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Whether it has ended; takes note of how.
  bool has_ended();
  /// Asks it to stop, or kills it.
  void stop(bool at_once);
  /// Exit code, or minus the signal that ended it.
  int exit_code() const { return exit_code_; }

 private:
  pid_t process_ = -1;
  bool has_ended_ = false;
  int exit_code_ = 0;
};

}  // namespace hydroscope
