// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/contact_life.h"

#include <algorithm>
#include <cmath>

namespace hydroscope {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

LifeClass find_class(const Snapshot& s, std::size_t node, double since) {
  const ContactClass now = s.contact_state[node];
  if (now == ContactClass::kStick || now == ContactClass::kSlip) return LifeClass::kTouching;
  if (now == ContactClass::kDetachedNow) return LifeClass::kLetGoNow;
  if (s.let_go_time.empty() || std::isnan(s.let_go_time[node])) return LifeClass::kNeverTouching;
  return s.let_go_time[node] > since ? LifeClass::kLetGoNow : LifeClass::kLetGo;
}

double calc_margin(const Snapshot& s, std::size_t node) {
  const double reference = s.release_reference[node];
  if (!(reference > 0.0)) return kUnknown;
  return calc_release_margin(s, node) / reference;
}

/// By margin; equal ones by node.
std::vector<int> sort_by_margin(const std::vector<double>& margin) {
  std::vector<int> nodes;
  for (std::size_t i = 0; i < margin.size(); ++i)
    if (!std::isnan(margin[i])) nodes.push_back(static_cast<int>(i));
  std::stable_sort(nodes.begin(), nodes.end(), [&](int a, int b) {
    return margin[static_cast<std::size_t>(a)] < margin[static_cast<std::size_t>(b)];
  });
  return nodes;
}

}  // namespace

int find_toggle_class(int toggles) {
  if (toggles <= 2) return std::max(toggles, 0);
  if (toggles <= 4) return 3;
  return toggles <= 8 ? 4 : 5;
}

ContactLife calc_contact_life(const Snapshot& s, double since) {
  const std::size_t nodes = s.points.size();
  ContactLife life;
  life.is_known = !s.toggles.empty();
  life.age.assign(nodes, kUnknown);
  life.margin.assign(nodes, kUnknown);
  for (std::size_t i = 0; i < nodes; ++i) {
    const LifeClass now = find_class(s, i, since);
    life.classes.push_back(now);
    ++life.counts[static_cast<std::size_t>(now)];
    if (!life.is_known) continue;
    if (now == LifeClass::kTouching) life.margin[i] = calc_margin(s, i);
    if (now == LifeClass::kLetGo || now == LifeClass::kLetGoNow) life.age[i] = s.time - s.let_go_time[i];
    life.toggles += s.toggles[i];
    ++life.toggle_counts[static_cast<std::size_t>(find_toggle_class(s.toggles[i]))];
  }
  life.nearest = sort_by_margin(life.margin);
  life.near_release = static_cast<int>(std::count_if(life.nearest.begin(), life.nearest.end(), [&](int node) {
    return life.margin[static_cast<std::size_t>(node)] <= kNearRelease;
  }));
  if (!life.nearest.empty()) life.nearest.resize(static_cast<std::size_t>(std::max(1, life.near_release)));
  return life;
}

}  // namespace hydroscope
