// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr int kCannotStart = 127;

/// What the child does before it becomes the program; only calls that are safe after a fork.
[[noreturn]] void become(char* const* words, const char* output, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(kCannotStart);
  const int file = open(output, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (file < 0) _exit(kCannotStart);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  close(file);
  for (const int signal : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
  execvp(words[0], words);
  _exit(kCannotStart);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, const std::filesystem::path& output) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  const std::string file = output.string();
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ < 0) throw EnvironmentError("cannot start " + command.front() + ": " + std::strerror(errno));
  if (process_ == 0) become(words.data(), file.c_str(), parent);
}

ChildProcess::~ChildProcess() {
  if (has_ended_ || process_ <= 0) return;
  kill(process_, SIGKILL);
  int status = 0;
  waitpid(process_, &status, 0);
}

bool ChildProcess::has_ended() {
  if (has_ended_) return true;
  int status = 0;
  const pid_t ended = waitpid(process_, &status, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
  has_ended_ = true;
  exit_code_ = ended < 0 ? kCannotStart : WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return true;
}

void ChildProcess::stop(bool at_once) {
  if (!has_ended_) kill(process_, at_once ? SIGKILL : SIGTERM);
}

}  // namespace hydroscope
