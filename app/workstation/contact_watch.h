// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "solver/increment/report.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// What somebody who watches a run wants to be told of its contact as it happens, beside the solver's own
/// warnings: nodes that come and go, and contact that is about to be lost. Fed with each increment in order.
class ContactWatch {
 public:
  /// "chatter": nodes came back within kWindow increments after they let go; once in as many increments.
  /// "near-release": touching nodes have kNearRelease (render/contact_life.h) or less of their reference
  /// force left until they may let go; once until none has.
  std::vector<Warning> look(const IncrementReport& report, const Snapshot& snapshot);

  static constexpr int kWindow = 5;

 private:
  std::map<int, int> let_go_;  ///< by node: increment
  int last_chatter_ = -kWindow;
  bool was_near_ = false;
};

}  // namespace hydroscope
