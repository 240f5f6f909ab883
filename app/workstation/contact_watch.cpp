// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/contact_watch.h"

#include "render/contact_life.h"

namespace hydroscope {

namespace {

std::string name_node(int node, int tool, const Snapshot& snapshot) {
  std::string text = "node " + std::to_string(node);
  if (tool >= 0) text += " (tool " + snapshot.model->tools[static_cast<std::size_t>(tool)].name + ")";
  return text;
}

std::string count_others(int others) {
  if (others == 0) return {};
  return others == 1 ? ", and another node" : ", and " + std::to_string(others) + " others";
}

Warning make_warning(const IncrementReport& report, const char* kind, std::string text) {
  return {report.increment, report.time, kind, std::move(text)};
}

/// Touching nodes whose margin to release is small, against their reference force (mechanics 9.4).
std::vector<int> find_near_release(const Snapshot& s) {
  std::vector<int> near;
  for (std::size_t i = 0; i < s.release_reference.size(); ++i) {
    if (s.contact_tool[i] < 0 || s.release_reference[i] <= 0.0) continue;
    if (calc_release_margin(s, i) <= kNearRelease * s.release_reference[i])
      near.push_back(static_cast<int>(i));
  }
  return near;
}

}  // namespace

std::vector<Warning> ContactWatch::look(const IncrementReport& report, const Snapshot& snapshot) {
  std::vector<Warning> warnings;
  int back = 0;
  std::string first;
  for (const ContactEvent& event : report.events) {
    if (event.kind == EventKind::kDetach) let_go_[event.node] = report.increment;
    const auto found = let_go_.find(event.node);
    if (event.kind != EventKind::kRetouch || found == let_go_.end()) continue;
    const int after = report.increment - found->second;
    if (after <= kWindow && back++ == 0) {
      first = name_node(event.node, event.tool, snapshot) + " came back " +
              (after == 1 ? "one increment" : std::to_string(after) + " increments") + " after it let go";
    }
  }
  if (back > 0 && report.increment - last_chatter_ >= kWindow) {
    warnings.push_back(make_warning(report, "chatter", first + count_others(back - 1)));
    last_chatter_ = report.increment;
  }

  const std::vector<int> near = find_near_release(snapshot);
  if (!near.empty() && !was_near_) {
    const int node = near.front();
    const int others = static_cast<int>(near.size()) - 1;
    warnings.push_back(
        make_warning(report, "near-release",
                     name_node(node, snapshot.contact_tool[static_cast<std::size_t>(node)], snapshot) +
                         " may let go soon" + count_others(others)));
  }
  was_near_ = !near.empty();
  return warnings;
}

}  // namespace hydroscope
