// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "app/chart/study_entry.h"
#include "app/chart/study_grid.h"
#include "app/chart/study_runner.h"
#include "app/commands.h"
#include "app/frame_options.h"
#include "app/interrupt.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

/// Leaves the cases that were asked for.
void choose_cases(Study& study, const std::string& names) {
  std::vector<std::string> known, wanted;
  for (const StudyCase& one : study.cases) known.push_back(one.name);
  std::istringstream stream(names);
  for (std::string name; std::getline(stream, name, ',');) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      fail_unknown("--only " + names, "case", name, known);
    wanted.push_back(name);
  }
  if (wanted.empty()) throw InputError("--only: names of cases expected");
  std::erase_if(study.cases, [&wanted](const StudyCase& one) {
    return std::find(wanted.begin(), wanted.end(), one.name) == wanted.end();
  });
  study.plots.clear();
}

void list_runs(const Study& study) {
  std::string text;
  int all = 0, timed = 0;
  for (const StudyCase& one : study.cases) {
    text += one.name + "  " + one.title + "  (" + one.scene + ")\n";
    for (const StudyRun& run : make_study_runs(one)) {
      text += "  " + run.id + (run.is_finest ? "  [reference]" : "") +
              (run.id == one.standard ? "  [default]" : "");
      for (const SceneOverride& item : run.overrides) text += "  " + item.key + "=" + item.value;
      text += "\n";
      ++all;
      if (one.is_timed && !run.is_finest) timed += study.repeats;
    }
  }
  text += std::to_string(all) + " runs for accuracy, " + std::to_string(timed) + " timed ones\n";
  if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
    throw EnvironmentError("the list cannot be written");
}

void print_summary(const std::vector<CaseResult>& results, const StudyOptions& options) {
  for (const CaseResult& result : results) {
    const auto failed = std::count_if(result.runs.begin(), result.runs.end(),
                                      [](const RunResult& run) { return run.is_failed(); });
    std::printf("%s: %zu runs, %d failed\n", result.one->name.c_str(), result.runs.size(),
                static_cast<int>(failed));
    for (const std::string& sentence : describe_default(result)) std::printf("  %s\n", sentence.c_str());
  }
  std::printf("report: %s\n", (options.output / "report.md").c_str());
  std::fflush(stdout);
}

StudyOptions make_options(const Arguments& arguments, Study& study) {
  if (arguments.has("--only")) choose_cases(study, arguments.get("--only"));
  if (arguments.has("--repeats"))
    study.repeats = parse_whole_number("--repeats", arguments.get("--repeats"), 1, 99);
  if (arguments.has("--no-timing"))
    for (StudyCase& one : study.cases) one.is_timed = false;
  StudyOptions options;
  // The very file that this process was made of, even if another has been built in its place since.
  options.program = "/proc/" + std::to_string(getpid()) + "/exe";
  options.output = arguments.get("--output", "results/" + std::filesystem::path(study.file).stem().string());
  options.jobs = study.jobs > 0 ? study.jobs : find_machine().cores;
  options.takes_any = arguments.has("--draw-only");
  if (arguments.has("--jobs")) options.jobs = parse_whole_number("--jobs", arguments.get("--jobs"), 1, 256);
  if (arguments.has("--size")) options.size = parse_size("--size", arguments.get("--size"));
  options.theme = arguments.get("--theme", options.theme);
  if (options.theme != "light" && options.theme != "dark")
    fail_unknown("--theme", "name", options.theme, {"light", "dark"});
  return options;
}

}  // namespace

ExitCode chart_study(const Arguments& arguments) {
  Study study = read_study(arguments.operands.front());
  const StudyOptions options = make_options(arguments, study);
  if (arguments.has("--list")) {
    list_runs(study);
    return ExitCode::kDone;
  }
  make_folder(options.output);
  const Interrupt interrupt;
  if (!arguments.has("--draw-only") && !run_study(study, options, Interrupt::flag())) {
    std::fprintf(stderr, "interrupted; the same command goes on from here\n");
    return ExitCode::kInterrupted;
  }
  const std::vector<CaseResult> results = read_study_results(study, options);
  write_study(study, results, options);
  print_summary(results, options);
  return ExitCode::kDone;
}

}  // namespace hydroscope
