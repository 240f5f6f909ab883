// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/ledger_filter.h"

#include <algorithm>
#include <cmath>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

std::vector<std::size_t> gather_events(const Episode& episode) {
  std::vector<std::size_t> events = episode.changes;
  events.insert(events.end(), episode.taken_back.begin(), episode.taken_back.end());
  if (episode.touched) events.push_back(*episode.touched);
  if (episode.let_go) events.push_back(*episode.let_go);
  return events;
}

bool is_in_region(const std::array<double, 6>& region, const Vec3& point) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = point[static_cast<Eigen::Index>(k)];
    if (x < region[2 * k] || x > region[2 * k + 1]) return false;
  }
  return true;
}

bool passes(const Ledger& ledger, const Episode& episode, const LedgerFilter& filter) {
  if (filter.tool && episode.tool != *filter.tool) return false;
  if (filter.nodes && (episode.node < (*filter.nodes)[0] || episode.node > (*filter.nodes)[1])) return false;
  if (!filter.verdicts.empty() && (!episode.let_go || filter.verdicts.count(episode.verdict) == 0))
    return false;
  const auto events = gather_events(episode);
  return std::any_of(events.begin(), events.end(), [&](std::size_t index) {
    const ContactEvent& event = ledger.event(index);
    return filter.kinds.count(event.kind) > 0 && event.time >= filter.from && event.time <= filter.to &&
           (!filter.region || is_in_region(*filter.region, event.position));
  });
}

/// The smaller comes first; what is not known comes last.
double calc_sort_key(const Ledger& ledger, const Episode& episode, const std::string& sort) {
  constexpr double kLast = std::numeric_limits<double>::max();
  const auto known = [](double key) { return std::isnan(key) ? kLast : key; };
  if (sort == "node") return episode.node;
  if (sort == "time") {
    const auto events = gather_events(episode);
    return ledger.event(episode.let_go ? *episode.let_go : *std::min_element(events.begin(), events.end()))
        .time;
  }
  if (!episode.let_go) return kLast;
  const ReleaseFigures& f = episode.figures;
  if (sort == "force") return known(f.force_share);
  if (sort == "gap") return known(-f.gap_reached);
  if (sort == "toggles") return -f.toggles;
  return -static_cast<double>(episode.verdict);
}

}  // namespace

const std::vector<std::string>& ledger_sort_names() {
  static const std::vector<std::string> kNames = {"time", "node", "force", "gap", "toggles", "verdict"};
  return kNames;
}

std::vector<std::size_t> select_episodes(const Ledger& ledger, const LedgerFilter& filter) {
  std::vector<std::pair<double, std::size_t>> chosen;
  for (std::size_t i = 0; i < ledger.episodes.size(); ++i)
    if (passes(ledger, ledger.episodes[i], filter))
      chosen.emplace_back(calc_sort_key(ledger, ledger.episodes[i], filter.sort), i);
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::size_t> sorted;
  for (const auto& [key, index] : chosen) sorted.push_back(index);
  return sorted;
}

LedgerSummary sum_up_ledger(const Ledger& ledger, const std::vector<std::size_t>& chosen) {
  LedgerSummary summary;
  std::set<int> nodes, patches;
  for (const std::size_t i : chosen) {
    const Episode& episode = ledger.episodes[i];
    ++summary.episodes;
    nodes.insert(episode.node);
    summary.taken_back += static_cast<int>(episode.taken_back.size());
    if (!episode.let_go) continue;
    ++summary.detachments;
    patches.insert(episode.patch);
    if (episode.back) ++summary.back;
    ++summary.verdicts[static_cast<std::size_t>(episode.verdict)];
    const std::string& cause = ledger.event(*episode.let_go).cause;
    auto found = std::find_if(summary.causes.begin(), summary.causes.end(),
                              [&](const auto& known) { return known.first == cause; });
    if (found == summary.causes.end()) found = summary.causes.insert(found, {cause, 0});
    ++found->second;
  }
  summary.nodes = static_cast<int>(nodes.size());
  summary.patches = static_cast<int>(patches.size());
  summary.patch_list.assign(patches.begin(), patches.end());
  return summary;
}

}  // namespace hydroscope
