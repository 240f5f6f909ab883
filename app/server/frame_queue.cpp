// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/frame_queue.h"

#include <algorithm>
#include <tuple>

namespace hydroscope {

FrameQueue::Added FrameQueue::add(FrameOrder order, Time now) {
  Added added;
  const auto same = std::find_if(orders_.begin(), orders_.end(), [&](const auto& entry) {
    return entry.second.order.viewer == order.viewer && entry.second.order.slot == order.slot;
  });
  if (same != orders_.end()) {
    added.replaced = same->first;
    orders_.erase(same);
  }
  if (orders_.size() >= kMost) return added;
  added.ticket = ++last_ticket_;
  orders_.emplace(added.ticket, Waiting{std::move(order), now});
  return added;
}

void FrameQueue::remove(Ticket ticket) { orders_.erase(ticket); }

bool FrameQueue::is_possible(const FrameOrder& order, const std::optional<StateKey>& live) {
  if (order.snapshot != nullptr) return true;
  if (!live || !order.after) return live.has_value();
  const bool is_same_branch = order.after->branch == kAnyBranch || order.after->branch == live->branch;
  return !(is_same_branch && order.after->increment == live->increment);
}

bool FrameQueue::is_due(const Waiting& item, Time now, const std::optional<StateKey>& live,
                        bool is_solving) const {
  if (!is_possible(item.order, live)) return false;
  return item.order.kind != FrameOrder::Kind::kWatch || now >= watch_time(is_solving);
}

std::optional<std::pair<FrameQueue::Ticket, FrameQueue::Waiting>> FrameQueue::take(
    Time now, const std::optional<StateKey>& live, bool is_solving) {
  const auto rank = [&](const std::pair<const Ticket, Waiting>& entry) {
    const Waiting& item = entry.second;
    const bool is_late = now - item.since > kPatience;
    const auto turn = turns_.find(item.order.viewer);
    return std::tuple(is_late ? 0 : static_cast<int>(item.order.kind),
                      turn == turns_.end() ? 0 : turn->second, entry.first);
  };
  auto best = orders_.end();
  for (auto at = orders_.begin(); at != orders_.end(); ++at) {
    if (is_due(at->second, now, live, is_solving) && (best == orders_.end() || rank(*at) < rank(*best)))
      best = at;
  }
  if (best == orders_.end()) return std::nullopt;
  std::pair<Ticket, Waiting> taken = std::move(*best);
  orders_.erase(best);
  if (turns_.size() > kMost) turns_.clear();
  turns_[taken.second.order.viewer] = ++turn_;
  return taken;
}

std::optional<FrameQueue::Time> FrameQueue::next_look(const std::optional<StateKey>& live,
                                                      bool is_solving) const {
  for (const auto& [ticket, item] : orders_)
    if (item.order.kind == FrameOrder::Kind::kWatch && is_possible(item.order, live))
      return watch_time(is_solving);
  return std::nullopt;
}

void FrameQueue::note_drawn(FrameOrder::Kind kind, Time begun, double cpu_s) {
  if (kind != FrameOrder::Kind::kWatch) return;
  const double pause = std::max(1.0 / kWatchRate, cpu_s / kWatchShare);
  next_watch_ = begun + std::chrono::duration_cast<Time::duration>(std::chrono::duration<double>(pause));
}

}  // namespace hydroscope
