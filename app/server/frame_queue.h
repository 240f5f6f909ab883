// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "app/server/frame_order.h"

namespace hydroscope {

/// Which picture is drawn next. A plain value with the time as argument: no threads, no clock.
///
/// Of each viewer and slot only the newest order waits. Pictures in somebody's hand come at once, one viewer
/// after the other. Watching is paced while the solver works: it takes at most kWatchShare of a core's time,
/// and draws at most kWatchRate pictures a second over all viewers. Films fill the time that is left. Whoever
/// waits for longer than kPatience takes part in the round whatever its kind.
class FrameQueue {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Ticket = std::uint64_t;
  static constexpr double kWatchShare = 0.10;
  static constexpr double kWatchRate = 4.0;  ///< [1/s]
  static constexpr std::chrono::milliseconds kPatience{1500};
  static constexpr std::size_t kMost = 256;  ///< orders that may wait

  struct Added {
    Ticket ticket = 0;               ///< 0: too many wait
    std::optional<Ticket> replaced;  ///< whose place it took
  };
  Added add(FrameOrder order, Time now);
  /// Nobody waits for it any more.
  void remove(Ticket ticket);

  struct Waiting {
    FrameOrder order;
    Time since;
  };
  /// Takes out what is to be drawn now. `live`: the newest state, none before there is one.
  std::optional<std::pair<Ticket, Waiting>> take(Time now, const std::optional<StateKey>& live,
                                                 bool is_solving);
  /// When to look again although nothing was added: the end of a pause between watched pictures.
  std::optional<Time> next_look(const std::optional<StateKey>& live, bool is_solving) const;

  /// A picture was drawn, and cost `cpu_s` of processor time.
  void note_drawn(FrameOrder::Kind kind, Time begun, double cpu_s);

  std::size_t size() const { return orders_.size(); }

 private:
  bool is_due(const Waiting& item, Time now, const std::optional<StateKey>& live, bool is_solving) const;
  static bool is_possible(const FrameOrder& order, const std::optional<StateKey>& live);
  Time watch_time(bool is_solving) const { return is_solving ? next_watch_ : Time::min(); }

  std::map<Ticket, Waiting> orders_;
  Ticket last_ticket_ = 0;
  std::map<std::string, std::uint64_t> turns_;  ///< by viewer: when it was last served
  std::uint64_t turn_ = 0;
  Time next_watch_ = Time::min();
};

}  // namespace hydroscope
