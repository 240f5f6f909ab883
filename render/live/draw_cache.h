// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <memory>
#include <optional>

#include "render/draw_list.h"
#include "render/live/live_view.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// Keeps the draw lists of the pictures drawn last, so that another camera costs no building and no sending
/// to the renderer. Each has a place (slot) in the stage.
class DrawCache {
 public:
  explicit DrawCache(int capacity) : capacity_(capacity) {}

  /// `look` is a view without what may change from picture to picture: see calc_look(). A new entry takes
  /// the slot of the one that has waited longest, if possible of one of the same view, which shares its
  /// tools.
  struct Entry {
    LiveView look;
    Vec3 cut;        ///< the normal of the tools' cut
    bool is_coarse;  ///< see FrameOptions
    std::shared_ptr<const Snapshot> snapshot;
    DrawList list;
    std::optional<Range> range;  ///< of the scalar
    int slot = 0;
  };
  /// Null if there is none.
  const Entry* find(const LiveView& look, const Vec3& cut, bool is_coarse,
                    const std::shared_ptr<const Snapshot>& snapshot);
  const Entry& keep(Entry entry);

 private:
  int capacity_;
  std::list<Entry> entries_;  ///< the last used one first
};

}  // namespace hydroscope
