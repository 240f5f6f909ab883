// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/desk.h"

#include <set>

#include "app/server/api_json.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr std::size_t kRecent = 32;  // states that were shown live: what is seen can be picked

std::shared_ptr<const Snapshot> find_first(const Workstation& workstation) {
  const std::vector<KeptState> kept = workstation.kept_states();
  if (!kept.empty()) {
    auto first = workstation.kept(kept.front().branch, kept.front().increment);
    if (first != nullptr) return first;
  }
  auto newest = workstation.newest();
  if (newest == nullptr) throw InputError("there is no state that could be shown");
  return newest;
}

}  // namespace

Desk::Desk(Workstation& given, std::vector<std::string> settable_keys, const PicturePainterFactory& painter,
           int most_viewers)
    : workstation(given),
      settable(std::move(settable_keys)),
      folder(given.folder()),
      first(find_first(given)),
      viewers(most_viewers),
      frames(painter ? painter : make_live_painter(first)),
      films(frames, [this](StateKey key) { return find_state(key); }),
      news(given, [this](std::shared_ptr<const Snapshot> snapshot, int branch, bool is_solving) {
        show(std::move(snapshot), branch, is_solving);
      }) {}

void Desk::show(std::shared_ptr<const Snapshot> snapshot, int branch, bool is_solving) {
  const StateKey key{branch, snapshot != nullptr ? snapshot->increment : 0};
  if (snapshot != nullptr) {
    const std::lock_guard lock(mutex_);
    if (recent_.empty() || recent_.back().snapshot != snapshot) recent_.push_back({key, snapshot});
    if (recent_.size() > kRecent) recent_.pop_front();
  }
  frames.publish(std::move(snapshot), key, is_solving);
}

std::shared_ptr<const Snapshot> Desk::find_state(const std::optional<StateKey>& key) const {
  if (key) {
    auto kept = workstation.kept(key->branch, key->increment);
    if (kept != nullptr) return kept;
    const std::lock_guard lock(mutex_);
    for (const Shown& shown : recent_)
      if (shown.key == *key) return shown.snapshot;
  }
  auto newest = workstation.newest();
  const bool is_asked = !key || (newest != nullptr && newest->increment == key->increment &&
                                 workstation.status().branch == key->branch);
  return is_asked ? newest : nullptr;
}

std::vector<StateKey> Desk::list_line(int branch) const {
  std::set<int> increments;
  for (const KeptState& kept : workstation.kept_states())
    if (kept.branch <= branch) increments.insert(kept.increment);
  std::vector<StateKey> line;
  for (const int increment : increments) line.push_back({branch, increment});
  return line;
}

Json Desk::make_status(const WorkstationStatus& status, const std::string& viewer) const {
  return make_status_json(status, {viewers.count(), viewers.steering(Viewers::Time::clock::now()), viewer},
                          frames.figures());
}

void Desk::close() {
  news.close();
  films.stop();
  frames.stop();
}

}  // namespace hydroscope
