// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "app/commands.h"
#include "app/interrupt.h"
#include "app/record_run.h"
#include "app/solver_threads.h"
#include "app/workstation/replay.h"
#include "solver/base/error.h"
#include "solver/scene/scene_reader.h"

namespace hydroscope {
namespace {

void check_options(const Arguments& arguments) {
  for (const auto& [name, values] : arguments.values) {
    if (name == "--set") throw InputError("--set: a replay takes the settings of its journal");
    if (name != "--replay" && name != "--output" && name != "--force" && name != "--threads" &&
        name != "--no-frames")
      throw InputError(name + ": a replay draws no frames; hydroscope render does it afterwards");
  }
}

}  // namespace

ExitCode replay_journal(const Arguments& arguments) {
  check_options(arguments);
  const JournalContents journal = read_journal(arguments.get("--replay"));
  if (!journal.trouble.empty()) std::fprintf(stderr, "warning: %s\n", journal.trouble.c_str());
  const std::string file = arguments.operands.empty() ? journal.head.scene : arguments.operands.front();
  WorkstationOptions options;
  options.threads = find_threads(arguments);
  options.overrides = make_overrides(journal.head);
  options.force = arguments.has("--force");
  const std::string stem = std::filesystem::path(file).stem();
  options.output = arguments.get("--output", "results/" + stem + "-replay");
  const Scene scene = read_scene(file, options.overrides);
  check_digests(journal.head, make_journal_head(scene, read_whole_file(file)));

  const Interrupt interrupt;
  Board board;
  Steering steering(scene, options, board);
  Progress progress(stderr);
  progress.start(scene.end_time());
  Replay replay(journal, steering);
  replay.on_increment = [&] {
    const std::vector<IncrementReport> rows = board.history(steering.increment());
    if (!rows.empty()) progress.update(rows.front());
  };
  replay.run(Interrupt::flag());
  progress.finish();

  RecordedRun run;
  run.summary = steering.summarise();
  std::printf("%s", describe_run(run, board.status().end_time).c_str());
  std::printf("results: %s\n", board.folder().c_str());
  std::fflush(stdout);
  if (!steering.trouble().empty()) throw EnvironmentError(steering.trouble());
  const ExitCode code = find_exit_code(run.summary.outcome);
  const bool is_whole = !Interrupt::flag() && code == ExitCode::kInterrupted;
  return is_whole ? ExitCode::kDone : code;  // that its user had ended it there is part of the journal
}

}  // namespace hydroscope
