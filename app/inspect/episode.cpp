// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/episode.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

using Pair = std::pair<int, int>;  // node and tool

/// Increments at which each node let go of a tool or came back to it.
std::map<Pair, std::vector<int>> gather_toggles(const ContactLog& log) {
  std::map<Pair, std::vector<int>> toggles;
  for (const ContactEvent& event : log.events)
    if (event.kind == EventKind::kDetach || event.kind == EventKind::kRetouch)
      toggles[{event.node, event.tool}].push_back(event.increment);
  return toggles;
}

void measure_gap(const ContactEvent& event, int back, const SheetHistory& sheet, ReleaseFigures& f) {
  const auto node = static_cast<std::size_t>(event.node);
  f.gap_reached = event.gap;
  bool is_first = true;
  for (const SheetState& state : sheet.states) {
    if (state.increment < event.increment || state.increment >= back) continue;
    const double gap = state.gap[node];
    f.gap_reached = std::isnan(gap) ? std::numeric_limits<double>::infinity() : std::max(f.gap_reached, gap);
    if (state.increment == event.increment) continue;
    if (is_first && !std::isnan(gap)) f.gap_growth = (gap - event.gap) / (state.time - event.time);
    is_first = false;
    if (std::isnan(gap)) break;
  }
}

void measure_forces(const ContactLog& log, const ContactEvent& event, int back, const SheetHistory& sheet,
                    ReleaseFigures& f) {
  const auto node = static_cast<std::size_t>(event.node);
  f.pressure = log.row(event.increment).pressure;
  const auto here = log.increments.find(event.increment);
  if (here != log.increments.begin()) {
    const IncrementRow& before = std::prev(here)->second;
    f.pressure_before = before.pressure;
    if (event.time > before.time) f.opening_speed = event.gap / (event.time - before.time);
  }
  if (const SheetState* before = sheet.find_before(event.increment)) {
    f.state_before = before->increment;
    f.contact_pressure_before = before->contact_pressure[node];
    f.area = before->area[node];
  }
  const SheetState* state = sheet.find_from(event.increment);
  if (state != nullptr && state->increment < back) {
    f.state_after = state->increment;
    f.contact_pressure_after = state->contact_pressure[node];
  }
  f.fluid_share = std::abs(f.pressure_before) * f.area;
  if (f.fluid_share > 0.0) f.force_share = event.force_before / f.fluid_share;
}

/// With thickness and tool as in the last state before.
void measure_noise(const ContactEvent& event, const SheetHistory& sheet, const FacetNoiseModel& model,
                   ReleaseFigures& f) {
  const SheetState* before = sheet.find_before(event.increment);
  const auto tool = static_cast<std::size_t>(event.tool);
  if (before == nullptr || tool >= model.tools.size() || tool >= before->tool_translation.size()) return;
  const Vec3 translation = before->tool_translation[tool];
  if (!translation.allFinite()) return;
  const FacetNoise noise = model.tools[tool].estimate(
      event.position - translation, before->thickness[static_cast<std::size_t>(event.node)], model.modulus);
  f.facet_angle = noise.angle;
  f.facet_sagitta = noise.sagitta;
  f.facet_noise = noise.pressure;
  if (f.fluid_share > 0.0) f.facet_noise_share = noise.pressure * f.area / f.fluid_share;
}

/// What its own tool and the others did in the increment.
void measure_motion(const ContactLog& log, const ContactEvent& event, const SheetHistory& sheet,
                    const std::vector<ToolMotion>& motions, ReleaseFigures& f) {
  const auto here = log.increments.find(event.increment);
  if (here == log.increments.begin() || motions.empty()) return;
  const double before = std::prev(here)->second.time;
  for (std::size_t t = 0; t < motions.size(); ++t) {
    const Vec3 way = motions[t].at(event.time) - motions[t].at(before);
    if (static_cast<int>(t) != event.tool) {
      if (way.norm() > f.moving_way) f.moving_tool = motions[t].name;
      f.moving_way = std::max(f.moving_way, way.norm());
    } else if (const SheetState* state = sheet.find_before(event.increment)) {
      const Vec3& normal = state->tool_normal[static_cast<std::size_t>(event.node)];
      if (normal.norm() > 0.0) f.tool_retreat = -way.dot(normal);
    }
  }
}

}  // namespace

std::string find_drive(const ReleaseFigures& f) {
  if (f.tool_retreat > 0.0) return "tool withdrawn";
  if (f.pressure < f.pressure_before) return "unloading";
  if (f.tool_retreat < 0.0) return "tool comes on";
  if (!f.moving_tool.empty()) return "tool moves";
  return f.pressure > f.pressure_before ? "loading" : "steady";
}

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPhysical:
      return "physical";
    case Verdict::kNoise:
      return "noise";
    case Verdict::kChatter:
      return "chatter";
  }
  return "";
}

std::vector<Episode> make_episodes(const ContactLog& log) {
  std::vector<Episode> episodes;
  std::map<Pair, std::size_t> last;  // episode of each node and tool
  for (std::size_t i = 0; i < log.events.size(); ++i) {
    const ContactEvent& event = log.events[i];
    const Pair key{event.node, event.tool};
    const auto found = last.find(key);
    const bool is_open = found != last.end() && !episodes[found->second].let_go;
    const auto fail = [&](const char* what) {
      throw InputError(log.event_places[i] + ": node " + std::to_string(event.node) + what);
    };
    const bool is_touch = event.kind == EventKind::kTouch || event.kind == EventKind::kRetouch;
    if (is_touch && is_open) fail(" touches without having let go before");
    if (!is_touch && !is_open && found != last.end()) fail(" is free, and cannot stick, slide or let go");
    if (is_touch || found == last.end()) {
      if (is_touch && found != last.end()) episodes[found->second].back = i;
      last[key] = episodes.size();
      episodes.push_back({});
      episodes.back().node = event.node;
      episodes.back().tool = event.tool;
    }
    Episode& episode = episodes[last[key]];
    if (is_touch) episode.touched = i;
    if (event.kind == EventKind::kDetach) episode.let_go = i;
    if (event.kind == EventKind::kStick || event.kind == EventKind::kSlip) episode.changes.push_back(i);
    if (event.kind == EventKind::kTakenBack) episode.taken_back.push_back(i);
  }
  return episodes;
}

int count_toggles(const std::vector<int>& toggles, int at) {
  int most = 0;
  for (int start = at - kToggleWindow + 1; start <= at; ++start) {
    const auto low = std::lower_bound(toggles.begin(), toggles.end(), start);
    const auto high = std::upper_bound(toggles.begin(), toggles.end(), start + kToggleWindow - 1);
    most = std::max(most, static_cast<int>(high - low));
  }
  return most;
}

void measure_releases(const ContactLog& log, const SheetHistory& sheet, const FacetNoiseModel& noise,
                      const std::vector<ToolMotion>& motions, std::vector<Episode>& episodes) {
  const auto toggles = gather_toggles(log);
  for (Episode& episode : episodes) {
    if (!episode.let_go) continue;
    const ContactEvent& event = log.events[*episode.let_go];
    const int back = episode.back ? log.events[*episode.back].increment : std::numeric_limits<int>::max();
    measure_forces(log, event, back, sheet, episode.figures);
    measure_gap(event, back, sheet, episode.figures);
    episode.figures.release = log.notes[*episode.let_go];
    measure_noise(event, sheet, noise, episode.figures);
    measure_motion(log, event, sheet, motions, episode.figures);
    for (const std::size_t i : episode.taken_back)
      if (event.increment - log.events[i].increment < kToggleWindow) ++episode.figures.taken_back;
    episode.figures.toggles = count_toggles(toggles.at({episode.node, episode.tool}), event.increment);
  }
}

}  // namespace hydroscope
