// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/follow_results.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <thread>

#include "app/follow/follow_detachment.h"
#include "app/frame_options.h"
#include "app/frame_sink.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "render/animation.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr double kFastestFilm = 4.0;  // frames a second: there are few

std::vector<int> parse_numbers(const Arguments& arguments, const std::string& option, std::size_t most) {
  std::vector<int> numbers;
  std::istringstream stream(arguments.get(option));
  for (std::string part; std::getline(stream, part, ',');)
    numbers.push_back(parse_whole_number(option, part, 0, 2000000000));
  if (arguments.has(option) && (numbers.empty() || numbers.size() > most))
    throw InputError(option + " " + arguments.get(option) + ": 1 to " + std::to_string(most) +
                     " numbers expected, with commas between");
  return numbers;
}

FollowOptions make_options(const Arguments& arguments, const FramesScene& settings, int threads) {
  FollowOptions options;
  options.frames = make_frame_options(settings, threads);
  options.frames.views = {"detachment"};
  if (arguments.has("--views")) options.frames.views = settings.views;
  if (options.frames.views.size() != 1)
    throw InputError("--views " + arguments.get("--views") + ": --follow draws one view");
  if (arguments.has("--camera"))
    throw InputError("--camera: --follow finds the camera; --set frames.zoom=4 comes closer");
  if (arguments.has("--frames")) options.around = settings.number;
  options.patches = parse_numbers(arguments, "--patch", 1000);
  options.nodes = parse_numbers(arguments, "--node", kMostNodes);
  return options;
}

}  // namespace

ExitCode follow_results(const Arguments& arguments) {
  if (arguments.get("--follow") != "detachment")
    throw InputError("--follow " + arguments.get("--follow") + ": only 'detachment' can be followed");
  const ResultFolder folder{arguments.operands.front()};
  const Ledger ledger = read_ledger(folder);
  const FramesScene settings = read_frames_scene(folder, arguments);
  const int threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
  FollowOptions options = make_options(arguments, settings, threads);
  choose_patches(ledger, options, folder.path.string());  // complains before anything is drawn
  const std::string renderer = check_renderer(threads);
  const Interrupt interrupt;
  Progress progress(stderr);
  options.on_progress = [&progress](int done, int of) { progress.update_drawing(done, of); };
  options.is_stopped = [] { return Interrupt::flag().load(); };
  const std::vector<FollowedPatch> drawn = follow_detachment(folder, ledger, options);
  progress.finish();
  std::printf("renderer: %s\n", renderer.c_str());
  for (const FollowedPatch& patch : drawn) {
    if (arguments.has("--animation") && settings.animation != "none" && patch.frames > 0)
      make_animation(folder.frames().string(), std::filesystem::path(patch.folder).filename().string(),
                     patch.frames, settings.animation, std::min(kFastestFilm, settings.frames_per_second));
    std::printf("%d frames:  %s\n", patch.frames, (patch.folder + "/00001.png ...").c_str());
  }
  if (options.patches.empty() && drawn.size() < ledger.patches.size())
    std::printf("%zu of %zu patches, those with most nodes; --patch N draws others\n", drawn.size(),
                ledger.patches.size());
  return Interrupt::flag() ? ExitCode::kInterrupted : ExitCode::kDone;
}

}  // namespace hydroscope
