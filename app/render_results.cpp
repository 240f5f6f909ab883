// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <thread>

#include "app/commands.h"
#include "app/follow_results.h"
#include "app/frame_options.h"
#include "app/frame_sink.h"
#include "app/interrupt.h"
#include "app/results/state_file.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

/// Evenly spread over what there is.
std::vector<std::filesystem::path> pick_states(const std::vector<std::filesystem::path>& states, int number) {
  const int available = static_cast<int>(states.size());
  if (number >= available || available < 2) return states;
  std::vector<std::filesystem::path> picked;
  for (int i = 0; i < number; ++i) {
    const int index = number > 1 ? (i * (available - 1) + (number - 1) / 2) / (number - 1) : available - 1;
    picked.push_back(states[static_cast<size_t>(index)]);
  }
  return picked;
}

}  // namespace

ExitCode render_results(const Arguments& arguments) {
  if (arguments.has("--follow")) return follow_results(arguments);
  for (const char* option : {"--patch", "--node"})
    if (arguments.has(option)) throw InputError(std::string(option) + ": only together with --follow");
  const ResultFolder folder{arguments.operands.front()};
  std::vector<std::filesystem::path> states = find_states(folder);
  const FramesScene settings = read_frames_scene(folder, arguments);
  if (settings.views.empty()) throw InputError("no views to draw; name some with --views");
  if (arguments.has("--frames")) states = pick_states(states, settings.number);
  const auto model = read_model(folder.path, states.front());

  const int threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
  const std::string renderer = check_renderer(threads);
  const Interrupt interrupt;
  remove_frames(folder, settings.views);
  Progress progress(stderr);
  // Read twice, so that the camera holds from the first frame on what the last one shows.
  Bounds sheet;
  for (const std::filesystem::path& state : states) {
    const Bounds box = calc_sheet_bounds(*read_state(state, model), settings.mirror);
    sheet.include(box.least);
    sheet.include(box.greatest);
  }
  const FrameSink frames =
      make_frame_sink({settings, folder, static_cast<int>(states.size()), threads, sheet}, progress);
  int drawn = 0;
  for (const std::filesystem::path& state : states) {
    if (Interrupt::flag()) break;
    frames.submit(read_state(state, model));
    progress.update_drawing(++drawn, static_cast<int>(states.size()));
  }
  frames.finish();
  progress.finish();
  std::printf("renderer: %s\n", renderer.c_str());
  for (const std::string& view : settings.views) {
    std::printf("%d frames:  %s\n", drawn, (folder.frames() / view / "00001.png ...").c_str());
  }
  return Interrupt::flag() ? ExitCode::kInterrupted : ExitCode::kDone;
}

}  // namespace hydroscope
