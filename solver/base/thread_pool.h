// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace hydroscope {

/// A few workers that share out index ranges. Ranges are contiguous and their
/// results must not depend on how they are cut: then a run gives the same bits
/// for any number of threads.
class ThreadPool {
 public:
  /// `threads` >= 1, the caller's included.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  /// Calls body(begin, end) on parts of [0, n) and waits; rethrows the first exception.
  void for_ranges(std::size_t n, const std::function<void(std::size_t, std::size_t)>& body);

  int size() const { return static_cast<int>(workers_.size()) + 1; }

 private:
  void work(std::size_t index);
  void run_part(std::size_t part);

  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable start_, done_;
  const std::function<void(std::size_t, std::size_t)>* body_ = nullptr;
  std::size_t n_ = 0, round_ = 0, running_ = 0;
  bool is_stopping_ = false;
  std::exception_ptr error_;
};

}  // namespace hydroscope
