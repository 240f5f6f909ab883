// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <thread>

#include "app/commands.h"
#include "app/frame_options.h"
#include "app/frame_sink.h"
#include "app/interrupt.h"
#include "app/record_run.h"
#include "app/scene_record.h"
#include "app/solver_threads.h"
#include "solver/base/error.h"
#include "solver/scene/scene_reader.h"
#include "solver/session/accuracy_choices.h"

namespace hydroscope {
namespace {

/// The mesh is known now, so that the node can be checked before anything is written.
void check_look_at_node(const Scene& scene, const SnapshotModel& model) {
  if (scene.frames.camera != "look-at") return;
  int last = 0;
  for (const auto& quad : model.quads) last = std::max(last, *std::max_element(quad.begin(), quad.end()));
  if (scene.frames.look_at_node > last) {
    throw InputError(scene.file +
                     ": key 'frames.look_at_node': " + std::to_string(scene.frames.look_at_node) +
                     " is out of range; allowed: 0 to " + std::to_string(last) + " (the nodes of the sheet)");
  }
}

void describe_results(const ResultFolder& folder, const RecordedRun& run, const Scene& scene,
                      const std::string& renderer) {
  std::printf("%s", describe_run(run, scene.end_time(), scene.accuracy).c_str());
  std::printf("results: %s\n", folder.path.c_str());
  if (!renderer.empty()) {
    std::printf("renderer: %s\n", renderer.c_str());
    for (const std::string& view : scene.frames.views) {
      std::printf("frames:  %s\n", (folder.frames() / view / "00001.png ...").c_str());
    }
  }
  if (!run.is_summary_written) {
    std::printf(
        "summary.json is missing, as not everything could be written; the files that are there are whole\n");
  }
  std::fflush(stdout);
}

}  // namespace

ExitCode run_scene(const Arguments& arguments) {
  const std::vector<SceneOverride> overrides = make_overrides(arguments);
  const int threads = find_threads(arguments);
  const Scene scene = read_scene(arguments.operands.front(), overrides);
  const std::filesystem::path stem = std::filesystem::path(scene.file).stem();
  const std::filesystem::path output = arguments.get("--output", "results/" + stem.string());
  const bool force = arguments.has("--force");
  check_result_folder(output, force);

  const Interrupt interrupt;
  std::atomic<bool>& stop = Interrupt::flag();
  Run run(scene, {threads, &stop});
  const bool has_frames = !arguments.has("--no-frames") && !scene.frames.views.empty();
  if (!run.scene().choices.empty()) {
    std::printf("%s", describe_choices(run.scene()).c_str());
    std::fflush(stdout);
  }
  check_look_at_node(scene, run.snapshot_model());
  const std::string renderer = has_frames ? check_renderer(1) : "";
  RunRecord record = make_scene_record(run.scene(), overrides, threads);
  record.renderer = renderer;

  // All input is accepted: from here on there is a folder.
  const ResultFolder folder = make_result_folder(output, force);
  RunWriter writer(folder, record, run.snapshot_model(), run.quantity_names());
  Progress progress(stderr);
  FrameSink frames;
  if (has_frames) frames = make_frame_sink({scene.frames, folder, estimate_frames(scene), 1}, progress);
  const RecordedRun recorded = record_run([&run](const RunObserver& observer) { return run.run(observer); },
                                          writer, frames, progress, stop);
  describe_results(folder, recorded, scene, renderer);
  return recorded.exit_code;
}

}  // namespace hydroscope
