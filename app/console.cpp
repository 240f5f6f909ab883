// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/console.h"

#include <unistd.h>

#include <cstdio>

#include "app/commands.h"
#include "app/frame_options.h"
#include "app/interrupt.h"
#include "app/solver_threads.h"
#include "solver/scene/scene_reader.h"

namespace hydroscope {

ExitCode open_console(const Arguments& arguments) {
  WorkstationOptions options;
  options.overrides = make_overrides(arguments);
  options.threads = find_threads(arguments);
  options.force = arguments.has("--force");
  const Scene scene = read_scene(arguments.operands.front(), options.overrides);
  const std::string stem = std::filesystem::path(scene.file).stem();
  options.output = arguments.get("--output", "results/" + stem);

  const Interrupt interrupt;
  auto workstation = std::make_unique<Workstation>(scene, options);
  Console console(*workstation, {STDIN_FILENO, stdout, isatty(STDIN_FILENO) == 1, &Interrupt::flag()});
  const Console::End end = console.run();  // an error in a script ends the run, too, and nothing is lost
  const WorkstationStatus status = workstation->close();
  const std::filesystem::path folder = workstation->folder();
  workstation.reset();
  std::printf("%s\nresults: %s\n", status.message.c_str(), folder.c_str());
  std::fflush(stdout);
  if (end == Console::End::kInterrupted) return ExitCode::kInterrupted;
  const ExitCode code = find_exit_code(status);
  return code == ExitCode::kInterrupted ? ExitCode::kDone : code;  // to end it was what was asked for
}

}  // namespace hydroscope
