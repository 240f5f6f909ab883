// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/patch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>

namespace hydroscope {
namespace {

/// Who belongs together: each points towards the representative of its group.
class Groups {
 public:
  explicit Groups(std::size_t number) : parent_(number) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

/// Joins every pair of neighbours, and the same node's own, that let go within kToggleWindow increments: a
/// front goes on by a row every few increments.
Groups join_neighbours(const ContactLog& log, const std::vector<std::vector<int>>& neighbours,
                       const std::vector<Episode>& episodes) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> at;  // by tool and node
  for (std::size_t i = 0; i < episodes.size(); ++i)
    if (episodes[i].let_go) at[{episodes[i].tool, episodes[i].node}].push_back(i);
  Groups groups(episodes.size());
  const auto increment = [&](std::size_t i) { return log.events[*episodes[i].let_go].increment; };
  for (const auto& [place, mine] : at) {
    std::vector<int> nodes = neighbours[static_cast<std::size_t>(place.second)];
    nodes.push_back(place.second);
    for (const int node : nodes) {
      const auto others = at.find({place.first, node});
      if (others == at.end()) continue;
      for (const std::size_t a : mine)
        for (const std::size_t b : others->second)
          if (std::abs(increment(a) - increment(b)) < kToggleWindow) groups.join(a, b);
    }
  }
  return groups;
}

Patch sum_up(const ContactLog& log, const std::vector<Episode>& episodes, std::vector<std::size_t> members) {
  Patch patch;
  std::set<int> nodes;
  for (const std::size_t i : members) {
    const Episode& episode = episodes[i];
    const ContactEvent& event = log.events[*episode.let_go];
    nodes.insert(episode.node);
    if (std::find(patch.causes.begin(), patch.causes.end(), event.cause) == patch.causes.end())
      patch.causes.push_back(event.cause);
    const std::string drive = find_drive(episode.figures);
    if (std::find(patch.drives.begin(), patch.drives.end(), drive) == patch.drives.end())
      patch.drives.push_back(drive);
    patch.centre += event.position / static_cast<double>(members.size());
    patch.area += episode.figures.area;
    patch.force_before += event.force_before;
    patch.fluid_share += episode.figures.fluid_share;
    const double noise = episode.figures.facet_noise * episode.figures.area;
    patch.facet_noise = std::sqrt(patch.facet_noise * patch.facet_noise + noise * noise);
    patch.gap_reached = std::max(patch.gap_reached, episode.figures.gap_reached);
    if (episode.back) ++patch.back;
  }
  const ContactEvent& first = log.events[*episodes[members.front()].let_go];
  const ContactEvent& last = log.events[*episodes[members.back()].let_go];
  patch.tool = first.tool;
  patch.nodes = static_cast<int>(nodes.size());
  patch.first_increment = first.increment;
  patch.last_increment = last.increment;
  patch.first_time = first.time;
  patch.last_time = last.time;
  patch.episodes = std::move(members);
  return patch;
}

}  // namespace

std::vector<Patch> make_patches(const ContactLog& log, const std::vector<std::vector<int>>& neighbours,
                                std::vector<Episode>& episodes) {
  std::vector<std::size_t> released;
  for (std::size_t i = 0; i < episodes.size(); ++i)
    if (episodes[i].let_go) released.push_back(i);
  std::stable_sort(released.begin(), released.end(), [&](std::size_t a, std::size_t b) {
    const int first = log.events[*episodes[a].let_go].increment;
    const int second = log.events[*episodes[b].let_go].increment;
    return first != second ? first < second : episodes[a].node < episodes[b].node;
  });
  Groups groups = join_neighbours(log, neighbours, episodes);
  std::vector<std::vector<std::size_t>> members;
  std::map<std::size_t, std::size_t> patch_of;  // by representative
  for (const std::size_t i : released) {
    const auto [found, is_new] = patch_of.try_emplace(groups.find(i), members.size());
    if (is_new) members.emplace_back();
    members[found->second].push_back(i);
    episodes[i].patch = static_cast<int>(found->second);
  }
  std::vector<Patch> patches;
  for (auto& group : members) {
    patches.push_back(sum_up(log, episodes, std::move(group)));
    const Patch& patch = patches.back();
    if (!(patch.fluid_share > 0.0)) continue;
    for (const std::size_t i : patch.episodes) {
      episodes[i].figures.patch_force_share = patch.force_before / patch.fluid_share;
      episodes[i].figures.patch_noise_share = patch.facet_noise / patch.fluid_share;
    }
  }
  return patches;
}

void count_verdicts(const std::vector<Episode>& episodes, std::vector<Patch>& patches) {
  for (Patch& patch : patches) {
    for (const std::size_t i : patch.episodes)
      ++patch.verdicts[static_cast<std::size_t>(episodes[i].verdict)];
    for (std::size_t k = 0; k < patch.verdicts.size(); ++k)
      if (patch.verdicts[k] >= patch.verdicts[static_cast<std::size_t>(patch.verdict)])
        patch.verdict = static_cast<Verdict>(k);
  }
}

}  // namespace hydroscope
