// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// A node by what became of its contact.
enum class LifeClass { kNeverTouching, kTouching, kLetGo, kLetGoNow };
constexpr int kLifeClasses = 4;

/// Classes of the map of toggles: none, 1, 2, 3 to 4, 5 to 8, more.
constexpr int kToggleClasses = 6;
int find_toggle_class(int toggles);

/// A touching node counts as near release when this share of its reference force, or
/// less, is left until it may let go.
constexpr double kNearRelease = 0.05;

/// How contact ends in one frame. What a snapshot does not know (older states) is NaN, and counts nothing.
struct ContactLife {
  bool is_known = false;           ///< the snapshot says when nodes let go, and against which force
  std::vector<LifeClass> classes;  ///< a node
  std::vector<double> age;         ///< since it let go [s]; NaN: has not
  /// Of a touching node: (normal force + tension at which it may let go) over its reference force,
  /// mechanics 9.4. 0: it may let go; NaN: it does not touch, or there is no force to compare with.
  std::vector<double> margin;
  std::array<int, kLifeClasses> counts{};
  std::array<int, kToggleClasses> toggle_counts{};
  long toggles = 0;          ///< sum over the nodes
  std::vector<int> nearest;  ///< touching nodes by rising margin: all near release, at least the first one
  int near_release = 0;      ///< how many of them are near release
};

/// `since`: process time of the frame before [s]; what let go later counts as let go now. NaN:
/// there was none, and only the snapshot's own increment counts.
ContactLife calc_contact_life(const Snapshot& snapshot,
                              double since = std::numeric_limits<double>::quiet_NaN());

}  // namespace hydroscope
