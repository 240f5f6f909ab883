// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/server/view_query.h"
#include "render/image/image.h"
#include "render/live/live_view.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// A picture that somebody waits for.
struct FrameOrder {
  /// In order of haste: somebody moves the picture; a live picture is kept up to date; a film is made.
  enum class Kind { kHand, kWatch, kFilm };
  Kind kind = Kind::kHand;
  std::string viewer, slot;  ///< one picture of one viewer: a newer order takes the older one's place
  LiveView view;
  std::shared_ptr<const Snapshot> snapshot;  ///< what to draw; null: the newest there is
  StateKey state;                            ///< of `snapshot`
  std::optional<StateKey> after;             ///< only when the newest is another one than this
};

/// What became of it.
struct FrameAnswer {
  enum class Kind { kDrawn, kReplaced, kNothingNew, kStopped, kBusy, kFailed } kind = Kind::kNothingNew;
  std::shared_ptr<const Image> image;
  std::shared_ptr<const Snapshot> snapshot;  ///< as drawn
  StateKey state;
  std::optional<Range> range;  ///< of the colours; absent where the view has no scalar
  double draw_ms = 0.0;        ///< wall time
  std::string error;           ///< of kFailed
  bool is_view_at_fault = false;
};

}  // namespace hydroscope
