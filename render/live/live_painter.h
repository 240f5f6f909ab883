// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "render/image/image.h"
#include "render/live/live_view.h"
#include "render/offscreen_context.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// Draws whatever view of whatever snapshot of one model is asked for, quickly one after the other. Belongs
/// to the thread that makes it.
class LivePainter {
 public:
  explicit LivePainter(std::shared_ptr<const Snapshot> first, int rasteriser_threads = 1);
  ~LivePainter();
  LivePainter(const LivePainter&) = delete;
  LivePainter& operator=(const LivePainter&) = delete;

  const RendererInfo& info() const;

  /// Throws InputError for a view that cannot be drawn (see check_live_view()). What a snapshot needs is kept
  /// for its next pictures, and the snapshot with it: a few of them at most.
  Image paint(const LiveView& view, const std::shared_ptr<const Snapshot>& snapshot);
  /// The same for a snapshot that nobody shares: a copy is drawn, and every picture costs the whole work.
  Image paint(const LiveView& view, const Snapshot& snapshot);

  /// What the colours of the last picture cover; absent where its view has no scalar.
  std::optional<Range> last_range() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hydroscope
