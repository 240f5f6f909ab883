// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/viewers.h"

namespace hydroscope {

bool Viewers::is_free(Time now) const {
  return wheel_.empty() || (streams_.count(wheel_) == 0 && now - last_sign_ > grace_);
}

bool Viewers::enter(const std::string& id, Time now) {
  const std::lock_guard lock(mutex_);
  if (streams_.count(id) == 0 && static_cast<int>(streams_.size()) >= most_) return false;
  ++streams_[id];
  if (is_free(now)) wheel_ = id;
  return true;
}

void Viewers::leave(const std::string& id, Time now) {
  const std::lock_guard lock(mutex_);
  const auto found = streams_.find(id);
  if (found == streams_.end() || --found->second > 0) return;
  streams_.erase(found);
  if (wheel_ == id) last_sign_ = now;
}

bool Viewers::may_steer(const std::string& id, Time now) { return take(id, false, now); }

bool Viewers::take(const std::string& id, bool by_force, Time now) {
  const std::lock_guard lock(mutex_);
  if (wheel_ != id && !by_force && !is_free(now)) return false;
  wheel_ = id;
  last_sign_ = now;
  return true;
}

void Viewers::give(const std::string& id) {
  const std::lock_guard lock(mutex_);
  if (wheel_ == id) wheel_.clear();
}

int Viewers::count() const {
  const std::lock_guard lock(mutex_);
  return static_cast<int>(streams_.size());
}

std::string Viewers::steering(Time now) const {
  const std::lock_guard lock(mutex_);
  return is_free(now) ? std::string() : wheel_;
}

}  // namespace hydroscope
