// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include "app/server/view_query.h"

namespace hydroscope {

/// The detachment ledger of a result folder as JSON, computed by whoever asks first and kept until the run
/// has gone on: while it works, not sooner than kRest times what computing it took. Any thread.
class LedgerCache {
 public:
  static constexpr double kRest = 10.0;

  /// `now`: newest state; `is_solving`: it will change soon. Throws InputError when the folder cannot be read
  /// as a run's.
  std::shared_ptr<const std::string> get(const std::filesystem::path& folder, StateKey now, bool is_solving);

 private:
  using Clock = std::chrono::steady_clock;
  bool is_fresh(StateKey now, bool is_solving) const;

  std::mutex mutex_;
  std::condition_variable done_;
  bool is_busy_ = false;
  std::shared_ptr<const std::string> text_;
  StateKey state_;
  Clock::time_point good_until_{};
};

/// Episodes and patches as `hydroscope inspect` knows them, with the place of each.
std::string make_ledger_text(const std::filesystem::path& folder, StateKey state);

}  // namespace hydroscope
