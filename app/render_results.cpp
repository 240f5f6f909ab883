// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <sstream>
#include <thread>

#include "app/commands.h"
#include "app/frame_options.h"
#include "app/frame_sink.h"
#include "app/interrupt.h"
#include "app/results/state_file.h"
#include "solver/base/error.h"
#include "solver/scene/scene_reader.h"

namespace hydroscope {
namespace {

/// The run's own overrides first, so that those of today have the last word.
std::vector<SceneOverride> gather_overrides(const ResultFolder& folder, const Arguments& arguments) {
  std::vector<SceneOverride> overrides;
  std::istringstream lines(read_whole_file(folder.overrides()));
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) overrides.push_back(make_override(line));
  }
  for (SceneOverride& item : make_overrides(arguments)) {
    if (!item.key.starts_with("frames.")) {
      throw InputError(item.shown + ": the run is over; only keys of [frames] can be changed here");
    }
    overrides.push_back(std::move(item));
  }
  return overrides;
}

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
  const ResultFolder folder{arguments.operands.front()};
  std::vector<std::filesystem::path> states = find_states(folder);
  const std::vector<SceneOverride> overrides = gather_overrides(folder, arguments);
  const Scene scene = parse_scene(read_whole_file(folder.scene()), folder.scene().string(), overrides);
  if (scene.frames.views.empty()) throw InputError("no views to draw; name some with --views");
  if (arguments.has("--frames")) states = pick_states(states, scene.frames.number);
  const auto model = read_model(folder.path, states.front());
  check_renderer();

  const Interrupt interrupt;
  remove_frames(folder, scene.frames.views);
  Progress progress(stderr);
  const int threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
  const FrameSink frames =
      make_frame_sink({scene.frames, folder, static_cast<int>(states.size()), threads}, progress);
  int drawn = 0;
  for (const std::filesystem::path& state : states) {
    if (Interrupt::flag()) break;
    frames.submit(read_state(state, model));
    progress.update_drawing(++drawn, static_cast<int>(states.size()));
  }
  frames.finish();
  progress.finish();
  for (const std::string& view : scene.frames.views) {
    std::printf("%d frames:  %s\n", drawn, (folder.frames() / view / "00001.png ...").c_str());
  }
  return Interrupt::flag() ? ExitCode::kInterrupted : ExitCode::kDone;
}

}  // namespace hydroscope
