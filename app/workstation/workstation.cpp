// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/workstation.h"

#include <deque>
#include <future>
#include <thread>

#include "app/workstation/board.h"
#include "app/workstation/finished_folder.h"
#include "app/workstation/steering.h"
#include "solver/base/error.h"

namespace hydroscope {

namespace {

struct Request {
  Command command;
  std::string who;
  std::promise<CommandReply> reply;
};

CommandReply refuse(const std::string& text, int increment) { return {false, text, increment}; }

}  // namespace

struct Workstation::Impl {
  Board board;
  std::unique_ptr<Steering> steering;  ///< null: only looked at; belongs to the thread while it runs
  std::mutex mutex;                    ///< of what follows
  std::condition_variable called;
  std::deque<Request> requests;
  bool is_closing = false;
  std::thread thread;

  void work() {
    while (take_requests()) {
      if (steering->is_running()) steering->advance();
    }
    steering->finish();
  }

  /// Applies what has been asked for; waits for it where nothing runs. False: it is time to end.
  bool take_requests() {
    for (;;) {
      Request request;
      {
        std::unique_lock lock(mutex);
        if (!steering->is_running()) called.wait(lock, [this] { return is_closing || !requests.empty(); });
        if (is_closing) return false;
        if (requests.empty()) return true;
        request = std::move(requests.front());
        requests.pop_front();
      }
      request.reply.set_value(apply(request));
    }
  }

  CommandReply apply(const Request& request) {
    try {
      return steering->apply(request.command, request.who);
    } catch (const std::exception& error) {  // bad input, or surroundings that fail
      return refuse(error.what(), steering->increment());
    }
  }

  void close() {
    {
      const std::lock_guard lock(mutex);
      is_closing = true;
    }
    called.notify_all();
    if (thread.joinable()) thread.join();
    for (Request& request : requests)
      request.reply.set_value(refuse("the program is ending", board.status().increment));
    requests.clear();
  }
};

Workstation::Workstation(const Scene& scene, const WorkstationOptions& options)
    : impl_(std::make_unique<Impl>()) {
  impl_->steering = std::make_unique<Steering>(scene, options, impl_->board);
  impl_->thread = std::thread([impl = impl_.get()] { impl->work(); });
}

Workstation::Workstation(const std::filesystem::path& results) : impl_(std::make_unique<Impl>()) {
  read_finished_folder(results, impl_->board);
}

Workstation::~Workstation() { impl_->close(); }

CommandReply Workstation::command(const std::string& text, const std::string& who) {
  const int increment = impl_->board.status().increment;
  std::future<CommandReply> reply;
  try {
    Request request{parse_command(text), who, {}};
    if (impl_->steering == nullptr)
      return refuse("this is a finished run: it can be looked at, not steered", increment);
    reply = request.reply.get_future();
    const std::lock_guard lock(impl_->mutex);
    if (impl_->is_closing) return refuse("the program is ending", increment);
    impl_->requests.push_back(std::move(request));
  } catch (const InputError& error) {
    return refuse(error.what(), increment);
  }
  impl_->called.notify_all();
  return reply.get();
}

WorkstationStatus Workstation::status() const { return impl_->board.status(); }

WorkstationStatus Workstation::wait_status(std::uint64_t seen, std::chrono::milliseconds patience) const {
  return impl_->board.wait([seen](const WorkstationStatus& s) { return s.version != seen; }, patience);
}

WorkstationStatus Workstation::wait_halted() const {
  for (;;) {
    const auto is_halted = [](const WorkstationStatus& s) {
      return s.phase != WorkstationStatus::Phase::kRunning;
    };
    const WorkstationStatus status = impl_->board.wait(is_halted, std::chrono::hours(1));
    if (is_halted(status)) return status;
  }
}

std::shared_ptr<const Snapshot> Workstation::newest() const { return impl_->board.newest(); }

std::shared_ptr<const Snapshot> Workstation::kept(int branch, int increment) const {
  return impl_->board.kept(branch, increment);
}

std::vector<KeptState> Workstation::kept_states() const { return impl_->board.kept_states(); }
std::vector<IncrementReport> Workstation::history(int from) const { return impl_->board.history(from); }
std::vector<std::string> Workstation::quantity_names() const { return impl_->board.quantity_names(); }
std::vector<ContactEvent> Workstation::events(std::size_t from) const { return impl_->board.events(from); }
std::vector<Warning> Workstation::warnings() const { return impl_->board.warnings(); }
std::filesystem::path Workstation::folder() const { return impl_->board.folder(); }
std::vector<std::string> Workstation::settable() const { return impl_->board.settable(); }

WorkstationStatus Workstation::close() {
  impl_->close();
  return impl_->board.status();
}

ExitCode find_exit_code(const WorkstationStatus& status) {
  for (int i = 0; i <= static_cast<int>(Outcome::kUserStop); ++i) {
    if (status.outcome == to_string(static_cast<Outcome>(i))) return find_exit_code(static_cast<Outcome>(i));
  }
  return ExitCode::kEnvironment;  // what went wrong is in the message
}

}  // namespace hydroscope
