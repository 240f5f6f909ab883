// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

#include "app/server/desk.h"
#include "app/server/http_library.h"

namespace hydroscope {

/// The server-sent events of one viewer, written by the thread of its connection. Status at most once in
/// kInterval; a viewer that reads slowly gets the newest only.
class EventStream {
 public:
  static constexpr std::chrono::milliseconds kInterval{100};  ///< between two writings
  static constexpr std::chrono::milliseconds kHeartBeat{5'000};

  EventStream(Desk& desk, std::string viewer);
  ~EventStream();
  EventStream(const EventStream&) = delete;
  EventStream& operator=(const EventStream&) = delete;

  /// Waits for something to tell, and tells it; false: the stream is over.
  bool go_on(httplib::DataSink& sink);

 private:
  using Clock = std::chrono::steady_clock;
  std::string make_text(const News::Reading& reading);

  Desk& desk_;
  const std::string viewer_;
  News::Place place_;
  Clock::time_point last_write_{};
};

}  // namespace hydroscope
