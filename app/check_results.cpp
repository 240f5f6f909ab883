// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <thread>

#include "app/check/check_report.h"
#include "app/check/state_check.h"
#include "app/commands.h"
#include "app/frame_options.h"
#include "app/frame_sink.h"
#include "app/interrupt.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr int kPictures = 6;                           // of a view, unless the user says otherwise
constexpr std::array<int, 2> kBaselineSize{480, 270};  // [px]: small enough for a repository

/// As the run drew its frames, but small; or as the baseline was drawn, with what is said now.
FrameOptions choose_options(const StateSequence& states, const std::filesystem::path& baseline,
                            const Arguments& arguments) {
  const bool says_something = arguments.has("--views") || arguments.has("--size") ||
                              arguments.has("--camera") || arguments.has("--theme") || arguments.has("--set");
  if (has_baseline(baseline) && !says_something) return read_baseline(baseline).options;
  FrameOptions options = make_frame_options(read_frames_scene(states.folder(), arguments), 1);
  if (!arguments.has("--size")) options.size = kBaselineSize;
  return options;
}

ExitCode update(const StateSequence& states, const std::filesystem::path& baseline,
                const Arguments& arguments, int threads) {
  FrameOptions options = choose_options(states, baseline, arguments);
  options.rasteriser_threads = threads;
  if (options.views.empty()) throw InputError("no views to draw; name some with --views");
  const int most =
      parse_whole_number("--pictures", arguments.get("--pictures", std::to_string(kPictures)), 1, 100000);
  if (has_baseline(baseline)) {
    const CheckReport changes = check_states(states, baseline, threads);
    std::printf("changes that become the baseline:\n%s", make_text_report(changes, 1000).c_str());
  }
  const Baseline made = renew_baseline(states, options, most, baseline);
  std::printf("baseline: %s: %zu frames, %zu pictures of each of %zu views\nrenderer: %s, probe %s\n",
              baseline.c_str(), made.states.size(), made.pictures.size(), made.options.views.size(),
              made.fingerprint.renderer.renderer.c_str(), made.fingerprint.probe.c_str());
  return ExitCode::kDone;
}

}  // namespace

ExitCode check_results(const Arguments& arguments) {
  if (!arguments.has("--baseline")) throw InputError("check: --baseline BASE is needed");
  const std::filesystem::path baseline = arguments.get("--baseline");
  const StateSequence states(arguments.operands.front());
  const int threads = arguments.has("--threads")
                          ? parse_whole_number("--threads", arguments.get("--threads"), 1, 64)
                          : std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
  const Interrupt interrupt;
  if (arguments.has("--update")) return update(states, baseline, arguments, threads);
  for (const char* option : {"--views", "--size", "--camera", "--theme", "--set", "--pictures"})
    if (arguments.has(option))
      throw InputError(std::string(option) +
                       ": the baseline says how to draw; it can be changed with --update");
  const CheckReport report = check_states(states, baseline, threads, [] { return Interrupt::flag().load(); });
  if (Interrupt::flag()) return ExitCode::kInterrupted;
  const std::filesystem::path folder = arguments.get("--report", (states.folder().path / "check").string());
  const std::string name = std::filesystem::absolute(states.folder().path).lexically_normal().filename();
  write_check_report(report, read_baseline(baseline), name, folder);
  std::fputs(make_text_report(report).c_str(), stdout);
  if (!report.is_passed()) std::printf("see %s\n", (folder / "index.html").c_str());
  std::fflush(stdout);
  return report.is_passed() ? ExitCode::kDone : ExitCode::kDifferences;
}

}  // namespace hydroscope
