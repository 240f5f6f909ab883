// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "app/server/frame_queue.h"

namespace hydroscope {

struct PaintedFrame {
  Image image;
  std::optional<Range> range;  ///< of its colours; absent where the view has no scalar
};

/// Who draws; belongs to the render thread.
class PicturePainter {
 public:
  PicturePainter() = default;
  virtual ~PicturePainter() = default;
  PicturePainter(const PicturePainter&) = delete;
  PicturePainter& operator=(const PicturePainter&) = delete;

  virtual std::string renderer() const = 0;
  /// Throws InputError for a view that cannot be drawn, EnvironmentError when the renderer fails.
  virtual PaintedFrame paint(const LiveView& view, const std::shared_ptr<const Snapshot>& snapshot) = 0;
};

/// Called once, on the render thread.
using PicturePainterFactory = std::function<std::unique_ptr<PicturePainter>()>;

/// The painter of the program: LivePainter with VTK. `first`: fixes the camera's box.
PicturePainterFactory make_live_painter(std::shared_ptr<const Snapshot> first);

/// How the render thread does.
struct FrameFigures {
  std::string renderer;
  double draw_ms = 0.0;  ///< median of the last pictures
  double fps = 0.0;      ///< pictures in the last two seconds, over all viewers
};

/// One thread that draws, for everybody (FrameQueue says what comes next). It is nicer than the solver. Any
/// thread may ask; nobody who waits holds anybody else up.
class FrameService {
 public:
  /// Waits for the painter to be made; throws what the factory throws.
  explicit FrameService(PicturePainterFactory factory);
  ~FrameService();
  FrameService(const FrameService&) = delete;
  FrameService& operator=(const FrameService&) = delete;

  /// There is a new newest state.
  void publish(std::shared_ptr<const Snapshot> snapshot, StateKey state, bool is_solving);

  /// Waits for the picture; for kNothingNew at most `patience` from when nothing newer came.
  FrameAnswer draw(FrameOrder order, std::chrono::milliseconds patience);

  FrameFigures figures() const;
  /// Whoever waits is answered kStopped, and nothing is drawn any more.
  void stop();

 private:
  struct Reply;
  struct Job {
    FrameQueue::Ticket ticket = 0;
    FrameOrder order;
  };

  void work(const PicturePainterFactory& factory);
  std::optional<Job> wait_job();
  FrameAnswer paint(PicturePainter& painter, const FrameOrder& order);
  void answer(FrameQueue::Ticket ticket, FrameAnswer answer);
  void note(const FrameOrder& order, FrameQueue::Time begun, double cpu_s, double wall_ms);

  mutable std::mutex mutex_;
  std::condition_variable wake_;  ///< of the render thread
  FrameQueue queue_;
  std::map<FrameQueue::Ticket, std::shared_ptr<Reply>> replies_;
  std::shared_ptr<const Snapshot> newest_;
  std::optional<StateKey> live_;
  bool is_solving_ = false;
  bool is_stopped_ = false;
  bool is_ready_ = false;
  std::exception_ptr failure_;
  std::string renderer_;
  std::vector<double> last_draws_;            ///< [ms], the newest last
  std::vector<FrameQueue::Time> last_times_;  ///< when they ended
  std::thread thread_;
};

}  // namespace hydroscope
