// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <string>

namespace hydroscope {

/// Who looks on, and who of them steers. The first viewer to come has the wheel; it is free again when its
/// holder gives it, or has had no event stream and sent no command for a while. Any thread.
class Viewers {
 public:
  using Time = std::chrono::steady_clock::time_point;

  explicit Viewers(int most = 64, std::chrono::milliseconds grace = std::chrono::seconds(5))
      : most_(most), grace_(grace) {}

  /// An event stream begins; false when there are too many viewers already.
  bool enter(const std::string& id, Time now);
  void leave(const std::string& id, Time now);

  /// Whether this viewer has the wheel, which it takes when it is free.
  bool may_steer(const std::string& id, Time now);
  /// Takes it, from whoever has it with `by_force`; false when another keeps it.
  bool take(const std::string& id, bool by_force, Time now);
  void give(const std::string& id);

  /// Viewers with an event stream.
  int count() const;
  /// Who has the wheel; empty: nobody.
  std::string steering(Time now) const;
  int most() const { return most_; }

 private:
  bool is_free(Time now) const;

  const int most_;
  const std::chrono::milliseconds grace_;
  mutable std::mutex mutex_;
  std::map<std::string, int> streams_;  ///< open event streams of each viewer
  std::string wheel_;
  Time last_sign_{};  ///< of the holder of the wheel, without a stream
};

}  // namespace hydroscope
