// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/http_server.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "app/server/connection_stream.h"
#include "app/server/connection_threads.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr std::size_t kMostConnections = 512;
constexpr int kMostRequests = 1000;                    ///< over one connection
constexpr std::chrono::milliseconds kIdleTime{5'000};  ///< between two of them
constexpr std::chrono::milliseconds kEndTime{1'500};
constexpr int kBacklog = 128;

void set_flag(socket_t socket, int level, int name) {
  const int yes = 1;
  setsockopt(socket, level, name, &yes, sizeof yes);
}

thread_local bool is_last_answer = false;  // of the connection that this thread serves

bool has_body(const httplib::Request& request) {
  return request.has_header("Transfer-Encoding") ||
         (request.has_header("Content-Length") && request.get_header_value("Content-Length") != "0");
}

}  // namespace

/// A socket while it is open.
class HttpServer::Entry {
 public:
  Entry(HttpServer& server, socket_t socket) : server_(server), socket_(socket) {
    const std::lock_guard lock(server_.mutex_);
    server_.sockets_.insert(socket_);
  }
  ~Entry() {
    const std::lock_guard lock(server_.mutex_);
    server_.sockets_.erase(socket_);
    close(socket_);
    server_.closed_.notify_all();
  }
  Entry(const Entry&) = delete;
  Entry& operator=(const Entry&) = delete;

 private:
  HttpServer& server_;
  const socket_t socket_;
};

HttpServer::HttpServer(std::chrono::milliseconds write_patience) : write_patience_(write_patience) {
  new_task_queue = [] { return new ConnectionThreads(kMostConnections); };
  // The library's own choice would let a second server listen at the same port.
  set_socket_options([](socket_t socket) { set_flag(socket, SOL_SOCKET, SO_REUSEADDR); });
  set_payload_max_length(kMostBody);
  set_keep_alive_max_count(kMostRequests);  // these two are only told to the other side
  set_keep_alive_timeout(std::chrono::duration_cast<std::chrono::seconds>(kIdleTime).count());
}

HttpServer::~HttpServer() {
  const bool was_started = thread_.joinable();
  finish();
  if (!was_started && svr_sock_ != INVALID_SOCKET) close(svr_sock_);
}

int HttpServer::open(const std::string& host, int port) {
  errno = 0;
  const int found = port == 0 ? bind_to_any_port(host) : (bind_to_port(host, port) ? port : -1);
  if (found <= 0) {
    const std::string why = errno != 0 ? std::strerror(errno) : "the address cannot be used";
    throw EnvironmentError("cannot listen at " + host + " port " + std::to_string(port) + ": " + why);
  }
  ::listen(svr_sock_, kBacklog);
  return found;
}

void HttpServer::start() {
  thread_ = std::thread([this] {
    listen_after_bind();
    is_over_ = true;
  });
}

void HttpServer::shut_all(int how) {
  const std::lock_guard lock(mutex_);
  for (const socket_t socket : sockets_) shutdown(socket, how);
}

void HttpServer::finish() {
  is_ending_ = true;
  if (!thread_.joinable()) return;
  while (!is_running() && !is_over_) std::this_thread::yield();
  stop();
  shut_all(SHUT_RD);  // whoever waits for a next request stops waiting
  {
    std::unique_lock lock(mutex_);
    closed_.wait_for(lock, kEndTime, [this] { return sockets_.empty(); });
  }
  shut_all(SHUT_RDWR);
  thread_.join();
}

void HttpServer::end_connection(httplib::Response& response) {
  response.set_header("Connection", "close");
  is_last_answer = true;
}

bool HttpServer::process_and_close_socket(socket_t socket) {
  const Entry entry(*this, socket);
  set_flag(socket, IPPROTO_TCP, TCP_NODELAY);
  ConnectionStream stream(socket, write_patience_);
  for (int count = 1; count <= kMostRequests && !is_ending_; ++count) {
    if (!stream.wait_request(kIdleTime)) break;
    stream.begin_request();
    is_last_answer = false;
    bool is_closed = false, had_body = false;
    const bool is_done = process_request(stream, count == kMostRequests || is_ending_, is_closed,
                                         [&had_body](httplib::Request& request) {
                                           request.ranges.clear();  // whole answers only
                                           had_body = has_body(request);
                                         });
    // What a refused request carries must not be read as the next request.
    if (!is_done || had_body || is_last_answer) stream.linger();
    if (!is_done || is_closed || had_body || is_last_answer) break;
  }
  stream.abort_if_stuck();
  return true;
}

}  // namespace hydroscope
