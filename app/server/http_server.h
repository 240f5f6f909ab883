// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "app/server/http_library.h"

namespace hydroscope {

/// The library's server with our own connections (ConnectionStream, ConnectionThreads), a port that nobody
/// else may share, and an end that does not wait for slow readers.
class HttpServer : public httplib::Server {
 public:
  static constexpr std::size_t kMostBody = 64 * 1024;  ///< of a request

  /// `write_patience`: who reads nothing for so long is dropped.
  explicit HttpServer(std::chrono::milliseconds write_patience);
  ~HttpServer() override;

  /// Port 0: any free one. Returns the port; throws EnvironmentError naming it when it cannot be had.
  int open(const std::string& host, int port);
  /// Answers from now on, on threads of its own.
  void start();
  /// For handlers: the connection that is served by this thread ends with this answer.
  static void end_connection(httplib::Response& response);
  /// Takes no more connections, lets answers under way finish for a short while, and joins all threads.
  void finish();

 private:
  class Entry;
  bool process_and_close_socket(socket_t socket) override;
  void shut_all(int how);

  const std::chrono::milliseconds write_patience_;
  std::mutex mutex_;
  std::condition_variable closed_;
  std::set<socket_t> sockets_;
  std::atomic<bool> is_ending_{false};
  std::atomic<bool> is_over_{false};  ///< listening came to its end
  std::thread thread_;
};

}  // namespace hydroscope
