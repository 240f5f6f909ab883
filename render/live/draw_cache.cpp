// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/live/draw_cache.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace hydroscope {

const DrawCache::Entry* DrawCache::find(const LiveView& look, const Vec3& cut, bool is_coarse,
                                        const std::shared_ptr<const Snapshot>& snapshot) {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.snapshot == snapshot && entry.cut == cut && entry.is_coarse == is_coarse &&
           entry.look == look;
  });
  if (found == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found);
  return &entries_.front();
}

const DrawCache::Entry& DrawCache::keep(Entry entry) {
  entry.slot = static_cast<int>(entries_.size());
  if (std::ssize(entries_) >= capacity_) {
    auto oldest = std::prev(entries_.end());
    for (auto it = entries_.begin(); it != entries_.end(); ++it)
      if (it->look.view == entry.look.view) oldest = it;
    entry.slot = oldest->slot;
    entries_.erase(oldest);
  }
  entries_.push_front(std::move(entry));
  return entries_.front();
}

}  // namespace hydroscope
