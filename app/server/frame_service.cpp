// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/frame_service.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kRemembered = 15;  ///< pictures for the median
constexpr int kNiceness = 5;

/// Threads that this one makes (the rasteriser's) take after it.
void be_nice() { setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), kNiceness); }

/// Of this thread [s].
double cpu_time() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

}  // namespace

struct FrameService::Reply {
  std::condition_variable arrived;
  std::optional<FrameAnswer> answer;
};

FrameService::FrameService(PicturePainterFactory factory)
    : thread_([this, make = std::move(factory)] { work(make); }) {
  std::unique_lock lock(mutex_);
  wake_.wait(lock, [this] { return is_ready_; });
  if (!failure_) return;
  lock.unlock();
  thread_.join();
  std::rethrow_exception(failure_);
}

FrameService::~FrameService() {
  stop();
  if (thread_.joinable()) thread_.join();
}

void FrameService::stop() {
  const std::lock_guard lock(mutex_);
  is_stopped_ = true;
  for (auto& [ticket, reply] : replies_) {
    FrameAnswer stopped;
    stopped.kind = FrameAnswer::Kind::kStopped;
    if (!reply->answer) reply->answer = stopped;
    reply->arrived.notify_all();
  }
  wake_.notify_all();
}

void FrameService::publish(std::shared_ptr<const Snapshot> snapshot, StateKey state, bool is_solving) {
  const std::lock_guard lock(mutex_);
  newest_ = std::move(snapshot);
  live_ = newest_ != nullptr ? std::optional(state) : std::nullopt;
  is_solving_ = is_solving;
  wake_.notify_all();
}

FrameAnswer FrameService::draw(FrameOrder order, std::chrono::milliseconds patience) {
  FrameAnswer answer;
  std::unique_lock lock(mutex_);
  if (is_stopped_) {
    answer.kind = FrameAnswer::Kind::kStopped;
    return answer;
  }
  const FrameQueue::Added added = queue_.add(std::move(order), Clock::now());
  if (added.replaced) {
    const auto older = replies_.find(*added.replaced);
    FrameAnswer replaced;
    replaced.kind = FrameAnswer::Kind::kReplaced;
    if (older != replies_.end()) {
      older->second->answer = replaced;
      older->second->arrived.notify_all();
    }
  }
  if (added.ticket == 0) {
    answer.kind = FrameAnswer::Kind::kBusy;
    return answer;
  }
  const auto reply = std::make_shared<Reply>();
  replies_.emplace(added.ticket, reply);
  wake_.notify_all();
  const bool is_in_time = reply->arrived.wait_for(lock, patience, [&] { return reply->answer.has_value(); });
  queue_.remove(added.ticket);
  replies_.erase(added.ticket);
  if (is_in_time) answer = *reply->answer;
  return answer;
}

void FrameService::answer(FrameQueue::Ticket ticket, FrameAnswer answer) {
  const auto reply = replies_.find(ticket);
  if (reply == replies_.end()) return;
  if (!reply->second->answer) reply->second->answer = std::move(answer);
  reply->second->arrived.notify_all();
}

std::optional<FrameService::Job> FrameService::wait_job() {
  std::unique_lock lock(mutex_);
  while (!is_stopped_) {
    if (auto taken = queue_.take(Clock::now(), live_, is_solving_)) {
      Job job{taken->first, std::move(taken->second.order)};
      if (job.order.snapshot == nullptr) {
        job.order.snapshot = newest_;
        job.order.state = *live_;
      }
      return job;
    }
    const std::optional<FrameQueue::Time> look = queue_.next_look(live_, is_solving_);
    if (look)
      wake_.wait_until(lock, *look);
    else
      wake_.wait(lock);
  }
  return std::nullopt;
}

FrameAnswer FrameService::paint(PicturePainter& painter, const FrameOrder& order) {
  FrameAnswer answer;
  answer.snapshot = order.snapshot;
  answer.state = order.state;
  answer.kind = FrameAnswer::Kind::kFailed;
  const Clock::time_point begin = Clock::now();
  try {
    PaintedFrame painted = painter.paint(order.view, order.snapshot);
    answer.image = std::make_shared<const Image>(std::move(painted.image));
    answer.range = painted.range;
    answer.kind = FrameAnswer::Kind::kDrawn;
  } catch (const InputError& error) {
    answer.error = error.what();
    answer.is_view_at_fault = true;
  } catch (const std::exception& error) {
    answer.error = error.what();
  }
  answer.draw_ms = milliseconds_since(begin);
  return answer;
}

void FrameService::note(const FrameOrder& order, FrameQueue::Time begun, double cpu_s, double wall_ms) {
  queue_.note_drawn(order.kind, begun, cpu_s);
  if (last_draws_.size() == kRemembered) last_draws_.erase(last_draws_.begin());
  last_draws_.push_back(wall_ms);
  last_times_.push_back(Clock::now());
  const FrameQueue::Time oldest = last_times_.back() - std::chrono::seconds(2);
  last_times_.erase(last_times_.begin(), std::lower_bound(last_times_.begin(), last_times_.end(), oldest));
}

void FrameService::work(const PicturePainterFactory& factory) {
  be_nice();
  std::unique_ptr<PicturePainter> painter;
  std::exception_ptr failure;
  try {
    painter = factory();
  } catch (...) {
    failure = std::current_exception();
  }
  {
    const std::lock_guard lock(mutex_);
    if (painter != nullptr) renderer_ = painter->renderer();
    failure_ = failure;
    is_ready_ = true;
    wake_.notify_all();
  }
  if (failure) return;
  while (const std::optional<Job> job = wait_job()) {
    const FrameQueue::Time begun = Clock::now();
    const double cpu_before = cpu_time();
    FrameAnswer painted = paint(*painter, job->order);
    const double cpu_s = cpu_time() - cpu_before;
    const std::lock_guard lock(mutex_);
    note(job->order, begun, cpu_s, painted.draw_ms);
    answer(job->ticket, std::move(painted));
  }
}

FrameFigures FrameService::figures() const {
  const std::lock_guard lock(mutex_);
  FrameFigures figures;
  figures.renderer = renderer_;
  std::vector<double> draws = last_draws_;
  if (!draws.empty()) {
    const auto middle = draws.begin() + static_cast<std::ptrdiff_t>(draws.size() / 2);
    std::nth_element(draws.begin(), middle, draws.end());
    figures.draw_ms = *middle;
  }
  const Clock::time_point recent = Clock::now() - std::chrono::seconds(2);
  figures.fps =
      0.5 * static_cast<double>(std::count_if(last_times_.begin(), last_times_.end(),
                                              [&](FrameQueue::Time time) { return time > recent; }));
  return figures;
}

}  // namespace hydroscope
