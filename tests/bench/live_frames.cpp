// SPDX-License-Identifier: GPL-3.0-or-later
// How long live pictures take, alone and beside a running solver, and what a viewer costs the solver.
//   hydroscope_bench_live [SCENE] [AROUND] [ALONG] [INCREMENTS]
#include <sys/resource.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <numeric>
#include <thread>

#include "render/image/jpeg_file.h"
#include "render/live/live_painter.h"
#include "render/live/pick.h"
#include "solver/scene/scene_reader.h"
#include "solver/session/steered_run.h"

namespace hydroscope {
namespace {

using Clock = std::chrono::steady_clock;
using SharedSnapshot = std::shared_ptr<const Snapshot>;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double process_cpu() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Of the calling thread and those that it makes.
void set_nice(int nice) { setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), nice); }

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

LiveView make_view(const std::string& name, bool is_drag) {
  LiveView view;
  view.view = name;
  view.width = is_drag ? 640 : 960;
  view.height = is_drag ? 360 : 540;
  view.smoothing = is_drag ? 1 : 2;
  return view;
}

std::size_t draw(LivePainter& painter, const LiveView& view, const SharedSnapshot& snapshot) {
  return make_jpeg(painter.paint(view, snapshot), 80).size();
}

/// Calls `frame(i)` `count` times and prints wall times a call.
void measure(const char* what, int count, const std::function<void(int)>& frame) {
  std::vector<double> times;
  const double cpu = process_cpu();
  for (int i = 0; i < count; ++i) {
    const auto start = Clock::now();
    frame(i);
    times.push_back(1e3 * seconds_since(start));
  }
  std::printf("%-52s median %6.1f ms  p95 %6.1f ms  cpu %6.1f ms\n", what, quantile(times, 0.5),
              quantile(times, 0.95), 1e3 * (process_cpu() - cpu) / count);
  std::fflush(stdout);
}

/// Seconds for the same increments from the same point.
double solve(SteeredRun& run, const RunPoint& from, int increments,
             const std::function<void()>& after_each = {}) {
  run.restore(from);
  const auto start = Clock::now();
  for (int i = 0; i < increments; ++i) {
    run.step();
    if (after_each) after_each();
  }
  return seconds_since(start);
}

void measure_alone(const SharedSnapshot& first, const SharedSnapshot& a, const SharedSnapshot& b) {
  LivePainter painter(first);
  for (const char* name : {"contact-map", "plastic-strain", "slip", "tool-normals"}) {
    for (const bool is_drag : {true, false}) {
      LiveView view = make_view(name, is_drag);
      draw(painter, view, a);
      measure((std::string(name) + (is_drag ? ", camera, 640x360" : ", camera, 960x540 smoothed")).c_str(),
              is_drag ? 60 : 20, [&](int) {
                view.azimuth += 2.0;
                draw(painter, view, a);
              });
    }
  }
  LiveView view = make_view("contact-map", true);
  measure("contact-map, another state each, 640x360", 20, [&](int i) { draw(painter, view, i % 2 ? a : b); });
  view.clip_axis = 2;
  measure("contact-map, clip plane moves, 640x360", 20, [&](int i) {
    view.clip_share = 0.3 + 0.02 * i;
    draw(painter, view, a);
  });
  view.clip_axis = -1;
  view.element_edges = true;
  draw(painter, view, a);
  measure("contact-map with element edges, camera, 640x360", 20, [&](int) {
    view.azimuth += 2.0;
    draw(painter, view, a);
  });
  // New snapshots, as no picture of them is kept.
  measure("contact-map, a new state each, 960x540 smoothed", 10,
          [&](int) { draw(painter, make_view("contact-map", false), std::make_shared<const Snapshot>(*a)); });
  measure("pick of a point", 20, [&](int) { pick_point(make_view("slip", false), *first, *a, 400, 300); });
  measure("pick of the whole picture", 5,
          [&](int) { pick_rectangle(make_view("slip", false), *first, *a, 0, 0, 960, 540); });
}

/// A viewer on a thread of its own.
struct Viewer {
  int nice = 5;
  double pause_s = 0.0;  ///< between the beginnings of frames; 0: as fast as it can
  LiveView view;
};

struct Watched {
  double solver_s = 0.0;
  std::vector<double> frames_ms;
};

Watched solve_watched(SteeredRun& run, const RunPoint& from, int increments, const SharedSnapshot& first,
                      const Viewer& viewer) {
  std::mutex mutex;
  SharedSnapshot newest = run.snapshot();
  std::atomic<bool> is_ready{false}, is_over{false};
  Watched watched;
  std::thread thread([&] {
    set_nice(viewer.nice);
    LivePainter painter(first);
    LiveView view = viewer.view;
    draw(painter, view, first);
    is_ready = true;
    while (!is_over) {
      const auto start = Clock::now();
      SharedSnapshot shown;
      {
        const std::lock_guard lock(mutex);
        shown = newest;
      }
      if (viewer.pause_s == 0.0) view.azimuth += 2.0;
      draw(painter, view, shown);
      watched.frames_ms.push_back(1e3 * seconds_since(start));
      const double left = viewer.pause_s - seconds_since(start);
      if (left > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(left));
    }
  });
  while (!is_ready) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  watched.solver_s = solve(run, from, increments, [&] {
    SharedSnapshot snapshot = run.snapshot();
    const std::lock_guard lock(mutex);
    newest = std::move(snapshot);
  });
  is_over = true;
  thread.join();
  return watched;
}

void measure_beside(SteeredRun& run, const RunPoint& from, int increments, const SharedSnapshot& first) {
  struct Case {
    const char* what;
    Viewer viewer;
  };
  const std::vector<Case> cases{
      {"watching, 4 a second, 960x540 smoothed, nice 5", {5, 0.25, make_view("contact-map", false)}},
      {"watching, 4 a second, 960x540 smoothed, nice 19", {19, 0.25, make_view("contact-map", false)}},
      {"watching, 4 a second, 640x360, nice 5", {5, 0.25, make_view("contact-map", true)}},
      {"dragging without pause, 640x360, nice 5", {5, 0.0, make_view("contact-map", true)}},
      {"dragging without pause, 640x360, nice 0", {0, 0.0, make_view("contact-map", true)}}};
  solve(run, from, increments);
  for (const Case& one : cases) {
    // Alone before and after, as other programs may run on the machine.
    const double before = solve(run, from, increments);
    const Watched watched = solve_watched(run, from, increments, first, one.viewer);
    const double alone = 0.5 * (before + solve(run, from, increments));
    std::printf(
        "%-52s frame median %6.1f ms  p95 %6.1f ms  %4zu frames  solver %5.2f s, alone %5.2f s: %+5.1f %%\n",
        one.what, quantile(watched.frames_ms, 0.5), quantile(watched.frames_ms, 0.95),
        watched.frames_ms.size(), watched.solver_s, alone, 100.0 * (watched.solver_s / alone - 1.0));
    std::fflush(stdout);
  }
}

int run_all(int argc, char** argv) {
  const std::string scene_file = argc > 1 ? argv[1] : "scenes/job-b-3d.toml";
  const std::string around = argc > 2 ? argv[2] : "40", along = argc > 3 ? argv[3] : "100";
  const int increments = argc > 4 ? std::atoi(argv[4]) : 6;
  const Scene scene = read_scene(scene_file, {make_override("tube.elements_around=" + around),
                                              make_override("tube.elements_along=" + along)});
  SteeredRun run(scene, {.threads = 2});
  run.start();
  const SharedSnapshot first = run.snapshot();
  SharedSnapshot before = first;
  for (int i = 0; i < 6; ++i) {
    before = run.snapshot();
    run.step();
  }
  const SharedSnapshot now = run.snapshot();
  std::printf("%zu nodes, %zu elements, %zu mirror planes, increment %d, p = %.2f MPa\n", now->points.size(),
              now->model->quads.size(), now->model->mirrors.size(), now->increment, now->pressure);
  measure_alone(first, before, now);
  measure_beside(run, run.take_point(), increments, first);
  return 0;
}

}  // namespace
}  // namespace hydroscope

int main(int argc, char** argv) {
  try {
    return hydroscope::run_all(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
