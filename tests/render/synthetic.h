// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// A round tube that bulges into a square die with rounded corners: no
/// mechanics, only fields that look and vary like a run's.
struct SyntheticBulge {
  int around = 20;                                        ///< elements over the quarter
  int along = 24;                                         ///< elements over the half length
  double radius = 30.0, length = 120.0, thickness = 1.5;  ///< [mm]
  double half_width = 36.0, corner = 9.0;                 ///< of the die [mm]
  bool has_die = true;
  bool is_whole_die = false;  ///< the die's mesh is the whole die instead of an eighth

  std::shared_ptr<const SnapshotModel> make_model() const;
  /// `progress` 0 (round) .. 1 (filled).
  std::shared_ptr<Snapshot> make_snapshot(std::shared_ptr<const SnapshotModel> model, double progress,
                                          int increment) const;
};

}  // namespace hydroscope
