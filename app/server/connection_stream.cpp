// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/connection_stream.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace hydroscope {
namespace {

std::chrono::milliseconds until(std::chrono::steady_clock::time_point time) {
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(time - std::chrono::steady_clock::now());
  return std::max(left, std::chrono::milliseconds(0));
}

void find_name(const sockaddr_storage& address, std::string& ip, int& port) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  if (address.ss_family == AF_INET) {
    sockaddr_in four{};
    std::memcpy(&four, &address, sizeof four);
    inet_ntop(AF_INET, &four.sin_addr, text.data(), text.size());
    port = ntohs(four.sin_port);
  } else if (address.ss_family == AF_INET6) {
    sockaddr_in6 six{};
    std::memcpy(&six, &address, sizeof six);
    inet_ntop(AF_INET6, &six.sin6_addr, text.data(), text.size());
    port = ntohs(six.sin6_port);
  }
  ip = text.data();
}

}  // namespace

bool ConnectionStream::wait(short what, std::chrono::milliseconds patience) const {
  pollfd entry{socket_, what, 0};
  const Clock::time_point end = Clock::now() + patience;
  int ready = 0;
  do {
    ready = poll(&entry, 1, static_cast<int>(until(end).count()));
  } while (ready < 0 && errno == EINTR);
  return ready > 0 && (entry.revents & (what | POLLHUP)) != 0;
}

bool ConnectionStream::is_open() const {
  if (from_ < to_ || !wait(POLLIN, std::chrono::milliseconds(0))) return true;
  char byte = 0;
  return recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT) > 0;
}

bool ConnectionStream::wait_request(std::chrono::milliseconds patience) {
  return from_ < to_ || (wait(POLLIN, patience) && is_open());
}

void ConnectionStream::begin_request() {
  bytes_left_ = kMostBytes;
  deadline_ = Clock::now() + kRequestTime;
}

void ConnectionStream::linger() {
  constexpr int kMostReads = 64;
  if (is_stuck_) return;
  shutdown(socket_, SHUT_WR);
  const Clock::time_point end = Clock::now() + std::chrono::milliseconds(500);
  for (int i = 0; i < kMostReads && wait(POLLIN, until(end)); ++i)
    if (recv(socket_, buffer_.data(), buffer_.size(), MSG_DONTWAIT) <= 0) break;
}

void ConnectionStream::abort_if_stuck() const {
  const ::linger at_once{1, 0};
  if (is_stuck_) setsockopt(socket_, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
}

bool ConnectionStream::is_readable() const { return from_ < to_ || wait(POLLIN, until(deadline_)); }

bool ConnectionStream::is_writable() const { return wait(POLLOUT, write_patience_) && is_open(); }

ssize_t ConnectionStream::read(char* bytes, size_t size) {
  if (from_ == to_) {
    if (bytes_left_ == 0 || !wait(POLLIN, until(deadline_))) return -1;
    const ssize_t got = recv(socket_, buffer_.data(), std::min(buffer_.size(), bytes_left_), MSG_DONTWAIT);
    if (got <= 0) return got;
    from_ = 0;
    to_ = static_cast<std::size_t>(got);
    bytes_left_ -= to_;
  }
  const std::size_t taken = std::min(size, to_ - from_);
  std::memcpy(bytes, buffer_.data() + from_, taken);
  from_ += taken;
  return static_cast<ssize_t>(taken);
}

ssize_t ConnectionStream::write(const char* bytes, size_t size) {
  const Clock::time_point end = Clock::now() + kLongestWrite;
  std::size_t done = 0;
  while (done < size) {
    if (!wait(POLLOUT, std::min(write_patience_, until(end)))) {
      is_stuck_ = true;
      return -1;
    }
    const ssize_t sent = send(socket_, bytes + done, size - done, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (sent <= 0) return -1;
    done += static_cast<std::size_t>(sent);
  }
  return static_cast<ssize_t>(size);
}

void ConnectionStream::get_remote_ip_and_port(std::string& ip, int& port) const {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (getpeername(socket_, reinterpret_cast<sockaddr*>(&address), &size) == 0) find_name(address, ip, port);
}

void ConnectionStream::get_local_ip_and_port(std::string& ip, int& port) const {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size) == 0) find_name(address, ip, port);
}

}  // namespace hydroscope
