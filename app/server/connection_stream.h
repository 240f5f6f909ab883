// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>

#include "app/server/http_library.h"

namespace hydroscope {

/// One connection, with bounds that the library does not have: a request must be here as a whole within
/// kRequestTime and kMostBytes, and whoever stops reading is dropped after
/// `write_patience` without progress.
class ConnectionStream : public httplib::Stream {
 public:
  static constexpr std::size_t kMostBytes = 192 * 1024;  ///< head and body
  static constexpr std::chrono::milliseconds kRequestTime{10'000};
  static constexpr std::chrono::milliseconds kLongestWrite{60'000};

  ConnectionStream(socket_t socket, std::chrono::milliseconds write_patience)
      : socket_(socket), write_patience_(write_patience) {}

  /// Waits for the first byte of the next request.
  bool wait_request(std::chrono::milliseconds patience);
  /// Bounds count from here.
  void begin_request();
  /// Says good-bye so that the last answer arrives although not all of the request was read.
  void linger();

  /// The other side did not read in time: what it has not got is thrown away.
  void abort_if_stuck() const;

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* bytes, size_t size) override;
  ssize_t write(const char* bytes, size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return socket_; }

 private:
  using Clock = std::chrono::steady_clock;
  bool wait(short what, std::chrono::milliseconds patience) const;
  bool is_open() const;

  socket_t socket_;
  std::chrono::milliseconds write_patience_;
  std::array<char, 4096> buffer_{};
  std::size_t from_ = 0, to_ = 0;  ///< unread bytes of `buffer_`
  bool is_stuck_ = false;
  std::size_t bytes_left_ = kMostBytes;
  Clock::time_point deadline_{};
};

}  // namespace hydroscope
