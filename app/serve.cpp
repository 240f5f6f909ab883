// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <thread>

#include "app/commands.h"
#include "app/frame_options.h"
#include "app/frame_sink.h"
#include "app/interrupt.h"
#include "app/server/server.h"
#include "app/workstation/workstation.h"
#include "solver/base/error.h"
#include "solver/scene/scene_reader.h"
#include "solver/session/scene_change.h"

namespace hydroscope {
namespace {

/// A run that is made, or results that are there.
struct Served {
  std::unique_ptr<Workstation> workstation;
  std::vector<std::string> settable;
};

Served open_results(const Arguments& arguments) {
  for (const char* option : {"--output", "--force", "--set", "--threads", "--run"})
    if (arguments.has(option))
      throw InputError(std::string(option) + ": only with a scene; " + arguments.operands.front() +
                       " is a folder of results, which is looked at");
  return {std::make_unique<Workstation>(std::filesystem::path(arguments.operands.front())), {}};
}

Served start_scene(const Arguments& arguments) {
  WorkstationOptions options;
  options.overrides = make_overrides(arguments);
  options.threads = arguments.has("--threads")
                        ? parse_whole_number("--threads", arguments.get("--threads"), 1, 64)
                        : std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
  const Scene scene = read_scene(arguments.operands.front(), options.overrides);
  const std::filesystem::path stem = std::filesystem::path(scene.file).stem();
  options.output = arguments.get("--output", "results/" + stem.string());
  options.force = arguments.has("--force");
  return {std::make_unique<Workstation>(scene, options), settable_keys(scene)};
}

/// Opens the user's browser, which must not hear this program's Ctrl-C nor write to its terminal.
void open_browser(const std::string& url) {
  const std::string program = "xdg-open";
  std::array<char*, 3> words = {const_cast<char*>(program.c_str()), const_cast<char*>(url.c_str()), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, 2, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t group;
  posix_spawnattr_init(&group);
  posix_spawnattr_setflags(&group, POSIX_SPAWN_SETPGROUP);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, program.c_str(), &files, &group, words.data(), environ);
  posix_spawnattr_destroy(&group);
  posix_spawn_file_actions_destroy(&files);
  if (failure != 0)
    std::fprintf(stderr, "there is no browser to open here (xdg-open: %s): use the address above\n",
                 std::strerror(failure));
}

void warn_of_host(const std::string& host) {
  if (is_loopback(host)) return;
  std::fprintf(
      stderr,
      "warning: --host %s: other machines can reach this server, and nothing that is sent is encrypted.\n"
      "         Whoever sees the address with its token can steer the run and read its folder.\n"
      "         Safer: leave --host away and use ssh -L PORT:127.0.0.1:PORT\n",
      host.c_str());
}

ExitCode find_end_code(const WorkstationStatus& status) {
  if (!status.can_steer) return ExitCode::kDone;
  for (int i = 0; i <= static_cast<int>(Outcome::kUserStop); ++i) {
    const auto outcome = static_cast<Outcome>(i);
    if (outcome != Outcome::kRunning && status.outcome == to_string(outcome)) return find_exit_code(outcome);
  }
  return ExitCode::kEnvironment;  // the disk, or what else kept the run from an end of its own
}

void wait_for_interrupt() {
  while (!Interrupt::flag()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
}

}  // namespace

ExitCode serve(const Arguments& arguments) {
  ServerOptions options;
  options.host = arguments.get("--host", options.host);
  if (arguments.has("--port")) options.port = parse_whole_number("--port", arguments.get("--port"), 0, 65535);
  const bool is_folder = std::filesystem::is_directory(arguments.operands.front());
  warn_of_host(options.host);

  check_address(options.host, options.port);
  check_renderer(1);

  const Interrupt interrupt;
  const Served served = is_folder ? open_results(arguments) : start_scene(arguments);
  Workstation& workstation = *served.workstation;
  options.settable = served.settable;
  {
    const Server server(workstation, options);
    std::printf("Open %s\n", server.url().c_str());
    std::fflush(stdout);
    if (arguments.has("--open")) open_browser(server.url());
    if (arguments.has("--run")) workstation.command("run", "command line");
    wait_for_interrupt();
    std::fprintf(stderr, "ending ...\n");
  }
  if (workstation.status().phase != WorkstationStatus::Phase::kEnded)
    workstation.command("stop", "command line");
  const WorkstationStatus status = workstation.status();
  if (status.can_steer) {
    std::printf("%s%s%s\nresults: %s\n", status.outcome.c_str(), status.message.empty() ? "" : ": ",
                status.message.c_str(), workstation.folder().c_str());
    std::fflush(stdout);
  }
  return find_end_code(status);
}

}  // namespace hydroscope
