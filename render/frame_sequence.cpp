// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame_sequence.h"

#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <limits>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "render/animation.h"
#include "render/bounded_queue.h"
#include "render/camera.h"
#include "render/frame_files.h"
#include "render/frame_painter.h"
#include "render/view_text.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

constexpr std::size_t kWaitingImages = 4;  // between drawing and encoding, 4 MB each at 1280 x 720

class Stopwatch {
 public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

/// The solver's threads come first; pictures take what they leave. The threads
/// that the rasteriser starts from this one inherit it.
void step_back_this_thread() { setpriority(PRIO_PROCESS, 0, 10); }

struct WaitingSnapshot {
  std::shared_ptr<const Snapshot> snapshot;
  int expected = 1;
};

struct WaitingFrame {
  std::string name;  ///< without ending
  Frame frame;
};

}  // namespace

struct FrameSequence::Impl {
  Impl(const FrameOptions& given, std::string folder);

  void check_options() const;
  void run_renderer();
  void run_encoder();
  void paint(FramePainter& painter, const std::string& view, const Snapshot& snapshot, FrameNumber number);
  void paint_deferred(FramePainter& painter);
  void make_animations(SequenceReport& report);
  void keep_error();
  void report_progress();
  void end_threads();

  FrameOptions options;
  std::string directory;
  std::vector<std::string> live_views, deferred_views;
  std::map<std::string, Range> ranges;
  BoundedQueue<WaitingSnapshot> snapshots;
  BoundedQueue<WaitingFrame> frames;

  // Written by the render thread, read after it has ended.
  std::vector<std::shared_ptr<const Snapshot>> kept;
  int count = 0;
  double seconds_drawing = 0.0;
  double seconds_encoding = 0.0;  // of the encoder thread
  double seconds_waited = 0.0;    // of the producer
  std::string renderer;

  std::promise<std::string> ready;  ///< the renderer's name, or why there is none
  std::mutex error_mutex;
  std::exception_ptr error;
  std::atomic<bool> is_abandoned = false;
  int done = 0, to_do = 0;
  std::thread render_thread, encoder_thread;
};

FrameSequence::Impl::Impl(const FrameOptions& given, std::string folder)
    : options(given),
      directory(std::move(folder)),
      ranges(given.ranges),
      snapshots(static_cast<std::size_t>(std::max(1, given.queue_capacity))),
      frames(kWaitingImages) {
  check_options();
  for (const std::string& view : options.views) {
    bool is_known = true;
    for (const std::string& name : range_names(view)) is_known = is_known && ranges.count(name) > 0;
    (is_known ? live_views : deferred_views).push_back(view);
    make_view_folder(directory, view, options.replace);
  }
  render_thread = std::thread([this] { run_renderer(); });
  try {
    renderer = ready.get_future().get();
  } catch (...) {
    render_thread.join();
    throw;
  }
  encoder_thread = std::thread([this] { run_encoder(); });
}

void FrameSequence::Impl::check_options() const {
  theme(options.theme);
  for (const std::string& view : options.views)
    if (std::find(view_names().begin(), view_names().end(), view) == view_names().end())
      throw InputError("view '" + view + "' is unknown; there are " + join(view_names()));
  for (const auto& [name, range] : options.ranges)
    if (!(range.low < range.high)) throw InputError("the range of '" + name + "' is empty");
  if (options.smoothing < 1 || options.smoothing > 4) throw InputError("smoothing is a factor of 1 to 4");
  check_camera(options, options.look_at_node + 1);  // the number of nodes is not known yet
  check_animation(options.animation, options.frames_per_second);
}

void FrameSequence::Impl::keep_error() {
  {
    const std::lock_guard lock(error_mutex);
    if (error == nullptr) error = std::current_exception();
  }
  is_abandoned = true;
  snapshots.abandon();
}

void FrameSequence::Impl::paint(FramePainter& painter, const std::string& view, const Snapshot& snapshot,
                                FrameNumber number) {
  const Stopwatch watch;
  Frame frame = painter.paint(view, snapshot, number, ranges);
  seconds_drawing += watch.seconds();
  frames.push({make_frame_name(directory, view, number.index + 1), std::move(frame)});
}

void FrameSequence::Impl::paint_deferred(FramePainter& painter) {
  for (const std::string& view : deferred_views) {
    for (const std::string& name : range_names(view)) {
      if (ranges.count(name) > 0) continue;
      Range all{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
      for (const auto& snapshot : kept) {
        const Range range = calc_range(name, *snapshot);
        all = {std::min(all.low, range.low), std::max(all.high, range.high)};
      }
      ranges[name] = calc_round_range(all);
    }
    for (std::size_t i = 0; i < kept.size() && !is_abandoned; ++i) {
      paint(painter, view, *kept[i], {static_cast<int>(i), static_cast<int>(kept.size())});
      report_progress();
    }
  }
}

void FrameSequence::Impl::report_progress() {
  const std::lock_guard lock(error_mutex);
  ++done;
  if (options.on_progress) options.on_progress(done, to_do);
}

void FrameSequence::Impl::run_renderer() {
  step_back_this_thread();
  std::unique_ptr<FramePainter> painter;
  try {
    painter = std::make_unique<FramePainter>(options);
  } catch (...) {
    ready.set_exception(std::current_exception());
    return;
  }
  ready.set_value(painter->info().renderer);
  try {
    while (std::optional<WaitingSnapshot> next = snapshots.pop()) {
      for (const std::string& view : live_views)
        paint(*painter, view, *next->snapshot, {count, std::max(next->expected, count + 1)});
      if (!deferred_views.empty()) kept.push_back(std::move(next->snapshot));
      ++count;
    }
    if (!is_abandoned) {
      to_do = static_cast<int>(deferred_views.size() * kept.size() +
                               (options.animation == "none" ? 0 : options.views.size()));
      paint_deferred(*painter);
    }
  } catch (...) {
    keep_error();
  }
  frames.close();  // also after an error: what has been drawn is still written
}

void FrameSequence::Impl::run_encoder() {
  step_back_this_thread();
  try {
    while (const std::optional<WaitingFrame> next = frames.pop()) {
      const Stopwatch watch;
      write_png(next->name + ".png", next->frame.image, next->frame.texts);
      write_whole_file(next->name + ".json", next->frame.sidecar);
      seconds_encoding += watch.seconds();
    }
  } catch (...) {
    keep_error();
    frames.abandon();
  }
}

void FrameSequence::Impl::make_animations(SequenceReport& report) {
  if (options.animation == "none" || count == 0) return;
  const Stopwatch watch;
  // Two at a time: the run is over, and so is its need for the processor.
  const auto make_every_second = [this](std::size_t first) {
    std::vector<std::string> files;
    for (std::size_t i = first; i < options.views.size(); i += 2) {
      files.push_back(
          make_animation(directory, options.views[i], count, options.animation, options.frames_per_second));
      report_progress();
    }
    return files;
  };
  std::future<std::vector<std::string>> others = std::async(std::launch::async, make_every_second, 1);
  report.animations = make_every_second(0);
  for (std::string& file : others.get()) report.animations.push_back(std::move(file));
  report.seconds_animation = watch.seconds();
}

void FrameSequence::Impl::end_threads() {
  snapshots.close();
  if (render_thread.joinable()) render_thread.join();
  if (encoder_thread.joinable()) encoder_thread.join();
}

FrameSequence::FrameSequence(const FrameOptions& options, std::string directory)
    : impl_(std::make_unique<Impl>(options, std::move(directory))) {}

FrameSequence::~FrameSequence() {
  impl_->is_abandoned = true;
  impl_->snapshots.abandon();
  impl_->end_threads();
}

void FrameSequence::submit(std::shared_ptr<const Snapshot> snapshot, int n_frames_expected) {
  require(snapshot != nullptr, "a frame needs a snapshot");
  const Stopwatch watch;
  impl_->snapshots.push({std::move(snapshot), n_frames_expected});
  impl_->seconds_waited += watch.seconds();
}

SequenceReport FrameSequence::finish() {
  impl_->end_threads();
  if (impl_->error != nullptr) std::rethrow_exception(impl_->error);
  SequenceReport report{.frames = impl_->count,
                        .seconds_drawing = impl_->seconds_drawing,
                        .seconds_encoding = impl_->seconds_encoding,
                        .seconds_producer_waited = impl_->seconds_waited,
                        .renderer = impl_->renderer,
                        .animations = {}};
  impl_->make_animations(report);
  return report;
}

}  // namespace hydroscope
