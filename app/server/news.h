// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/server/contact_counts.h"
#include "app/workstation/workstation.h"

namespace hydroscope {

/// What happens in the workstation, for many readers of different speed. One thread looks at the workstation;
/// each reader keeps its own place. A reader that falls behind gets the newest status, and of warnings and
/// contact the last kKept. Any thread.
class News {
 public:
  static constexpr std::size_t kKept = 1000;

  struct Item {
    std::uint64_t number = 0;
    std::string event;  ///< "warning" or "contact"
    std::string data;   ///< JSON
  };
  /// How far somebody has read.
  struct Place {
    std::uint64_t change = 0;  ///< of the status
    std::uint64_t item = 0;    ///< number of the last one read
  };
  struct Reading {
    bool is_closed = false;
    bool has_status = false;  ///< it has changed
    WorkstationStatus status;
    std::vector<Item> items;
  };

  /// `on_state` is called by the thread of the news at each change: newest snapshot, its branch, whether the
  /// solver works.
  using OnState = std::function<void(std::shared_ptr<const Snapshot>, int branch, bool is_solving)>;
  News(const Workstation& workstation, OnState on_state);
  ~News();
  News(const News&) = delete;
  News& operator=(const News&) = delete;

  /// Where a new reader begins: with the present status, and with what comes from now on.
  Place now() const;
  /// Waits for something behind `place`, which moves on; at most `patience`.
  Reading wait(Place& place, std::chrono::milliseconds patience) const;
  /// Something that the status JSON shows besides the workstation (viewers) has changed.
  void touch();
  void close();

 private:
  void work();
  void look(const WorkstationStatus& status);
  void add(const std::string& event, std::string data);

  const Workstation& workstation_;
  const OnState on_state_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  bool is_closed_ = false;
  std::uint64_t change_ = 1;
  WorkstationStatus status_;
  std::deque<Item> items_;
  std::uint64_t last_item_ = 0;
  int branch_ = 0;          ///< of what was read last; the thread's own, as the next two
  std::size_t events_ = 0;  ///< read so far of this branch
  std::size_t warnings_ = 0;
  std::thread thread_;
};

}  // namespace hydroscope
