// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "app/inspect/ledger.h"

namespace hydroscope {

/// Which episodes to list. An empty member lets all pass.
struct LedgerFilter {
  std::optional<int> tool;
  std::optional<std::array<int, 2>> nodes;                 ///< first and last
  std::optional<std::array<double, 6>> region;             ///< x from, to, y from, to, z from, to [mm]
  double from = -std::numeric_limits<double>::infinity();  ///< [s]
  double to = std::numeric_limits<double>::infinity();     ///< [s]
  std::set<EventKind> kinds = {EventKind::kDetach};        ///< one of these events within from ... to
  std::set<Verdict> verdicts;
  std::string sort = "time";  ///< one of ledger_sort_names()
};

const std::vector<std::string>& ledger_sort_names();

/// The episodes that pass, sorted: by time and node as they come, or by the
/// force (most pulled first), gap and toggles (largest first), verdict (most doubtful first) of the letting
/// go.
std::vector<std::size_t> select_episodes(const Ledger& ledger, const LedgerFilter& filter);

/// Counts over the chosen episodes.
struct LedgerSummary {
  int episodes = 0, detachments = 0, nodes = 0, patches = 0, back = 0, taken_back = 0;
  std::array<int, 3> verdicts{};
  std::vector<std::pair<std::string, int>> causes;  ///< in order of appearance
  std::vector<int> patch_list;                      ///< indices of patches with a chosen episode, sorted
};
LedgerSummary sum_up_ledger(const Ledger& ledger, const std::vector<std::size_t>& chosen);

}  // namespace hydroscope
