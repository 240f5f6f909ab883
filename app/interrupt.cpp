// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interrupt.h"

#include <csignal>

namespace hydroscope {
namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set inside a signal handler");

void request_stop(int signal) {
  if (stop_requested.exchange(true)) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
}

void install(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;  // reads and writes under way go on
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
  stop_requested = false;
  install(SIGINT, request_stop);
  install(SIGTERM, request_stop);
  install(SIGXFSZ, SIG_IGN);
  install(SIGPIPE, SIG_IGN);
}

Interrupt::~Interrupt() {
  for (const int signal : {SIGINT, SIGTERM, SIGXFSZ, SIGPIPE}) install(signal, SIG_DFL);
}

std::atomic<bool>& Interrupt::flag() { return stop_requested; }

}  // namespace hydroscope
