// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/ledger_record.h"

#include <algorithm>
#include <cmath>

#include "app/inspect/figure_text.h"
#include "solver/scene/number_text.h"

namespace hydroscope {
namespace {

std::string tool_name(const Ledger& ledger, int tool) {
  const auto i = static_cast<std::size_t>(tool);
  return tool >= 0 && i < ledger.tools.size() ? ledger.tools[i] : "";
}

/// The value where it is known, else null.
Json known_or_null(bool is_known, const Json& value) {
  if (is_known) return value;
  return {};
}

/// Written as null when negative.
double number_or_null(int number) { return number >= 0 ? number : kUnknown; }

/// Increments of the episode's changes to `kind`.
Json::Array gather_increments(const Ledger& ledger, const Episode& episode, EventKind kind) {
  std::vector<int> increments;
  for (const std::size_t i : episode.changes)
    if (ledger.event(i).kind == kind) increments.push_back(ledger.event(i).increment);
  return {increments.begin(), increments.end()};
}

void add_moment(const Ledger& ledger, const char* name, const std::optional<std::size_t>& event,
                Json::Object& record) {
  const std::string start = name;
  const ContactEvent moment = event ? ledger.event(*event) : ContactEvent{};
  record.emplace_back(start + "_increment", known_or_null(event.has_value(), moment.increment));
  record.emplace_back(start + "_time_s", known_or_null(event.has_value(), moment.time));
}

void add_release(const Ledger& ledger, const Episode& episode, Json::Object& record) {
  const ContactEvent event = episode.let_go ? ledger.event(*episode.let_go) : ContactEvent{};
  const IncrementRow& row = ledger.log.row(event.increment);
  const auto add = [&](const char* name, const Json& value) {
    record.emplace_back(name, known_or_null(episode.let_go.has_value(), value));
  };
  add("cause", event.cause);
  add("x_mm", event.position.x());
  add("y_mm", event.position.y());
  add("z_mm", event.position.z());
  add("force_before_N", event.force_before);
  add("force_after_N", event.force_after);
  add("gap_mm", event.gap);
  add("limited_by", row.limited_by);
  add("limited_at", number_or_null(row.limited_at));
  add("step_fraction", row.step_fraction);
}

void add_figures(const ReleaseFigures& f, Json::Object& record) {
  const Json::Object figures{{"pressure_before_MPa", f.pressure_before},
                             {"pressure_MPa", f.pressure},
                             {"node_area_mm2", f.area},
                             {"fluid_share_N", f.fluid_share},
                             {"force_share", f.force_share},
                             {"patch_force_share", f.patch_force_share},
                             {"release_force_N", f.release.force},
                             {"release_threshold_N", f.release.threshold},
                             {"release_pressure_MPa", f.release.pressure},
                             {"facet_angle_deg", f.facet_angle},
                             {"facet_sagitta_mm", f.facet_sagitta},
                             {"facet_noise_MPa", f.facet_noise},
                             {"facet_noise_share", f.facet_noise_share},
                             {"patch_noise_share", f.patch_noise_share},
                             {"contact_pressure_before_MPa", f.contact_pressure_before},
                             {"state_before_increment", number_or_null(f.state_before)},
                             {"contact_pressure_after_MPa", f.contact_pressure_after},
                             {"state_after_increment", number_or_null(f.state_after)},
                             {"gap_reached_mm", f.gap_reached},
                             {"left_reach", std::isinf(f.gap_reached)},
                             {"opening_speed_mm_per_s", f.opening_speed},
                             {"gap_growth_mm_per_s", f.gap_growth},
                             {"toggles", f.toggles},
                             {"taken_back_before", f.taken_back},
                             {"drive", find_drive(f)},
                             {"tool_retreat_mm", f.tool_retreat},
                             {"moving_tool", f.moving_tool},
                             {"moving_tool_mm", f.moving_way}};
  record.insert(record.end(), figures.begin(), figures.end());
}

std::string quote_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string make_cell(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_number()) return std::isfinite(value.number()) ? format_exact(value.number()) : "";
  if (value.is_array()) {
    std::string joined;
    for (const Json& item : value.items()) joined += (joined.empty() ? "" : " ") + make_cell(item);
    return joined;
  }
  const std::string written = value.write();
  return written == "true" || written == "false" ? written : quote_cell(value.text());
}

std::string describe_taken_back(const Ledger& ledger, std::size_t event) {
  const ReleaseNote& note = ledger.log.notes[event];
  if (std::isnan(note.force)) return "the fluid pushed it back in the same increment";
  return "it let go at " + format_figure(note.force) + " N, threshold " + format_figure(-note.threshold) +
         " N, and the fluid pushed it back in the same increment";
}

}  // namespace

Json::Object make_episode_record(const Ledger& ledger, const Episode& episode) {
  Json::Object record{{"node", episode.node}, {"tool", tool_name(ledger, episode.tool)}};
  record.emplace_back("patch", known_or_null(episode.patch >= 0, episode.patch + 1));
  add_moment(ledger, "touched", episode.touched, record);
  record.emplace_back("stuck_increments", gather_increments(ledger, episode, EventKind::kStick));
  record.emplace_back("slid_increments", gather_increments(ledger, episode, EventKind::kSlip));
  Json::Array taken_back;
  for (const std::size_t i : episode.taken_back) taken_back.push_back(ledger.event(i).increment);
  record.emplace_back("taken_back_increments", taken_back);
  add_moment(ledger, "let_go", episode.let_go, record);
  add_moment(ledger, "back", episode.back, record);
  add_release(ledger, episode, record);
  add_figures(episode.figures, record);
  record.emplace_back("verdict", known_or_null(episode.let_go.has_value(), to_string(episode.verdict)));
  record.emplace_back("reason", known_or_null(episode.let_go.has_value(), episode.reason));
  return record;
}

Json::Object make_patch_record(const Ledger& ledger, const Patch& patch) {
  std::vector<int> nodes;
  std::vector<std::string> limiters;
  for (const std::size_t i : patch.episodes) nodes.push_back(ledger.episodes[i].node);
  for (int i = patch.first_increment; i <= patch.last_increment; ++i)
    limiters.push_back(ledger.log.row(i).limited_by);
  return {{"patch", ledger.episodes[patch.episodes.front()].patch + 1},
          {"tool", tool_name(ledger, patch.tool)},
          {"node_count", patch.nodes},
          {"first_increment", patch.first_increment},
          {"last_increment", patch.last_increment},
          {"first_time_s", patch.first_time},
          {"last_time_s", patch.last_time},
          {"causes", Json::Array(patch.causes.begin(), patch.causes.end())},
          {"drives", Json::Array(patch.drives.begin(), patch.drives.end())},
          {"centre_mm", Json::Array{patch.centre.x(), patch.centre.y(), patch.centre.z()}},
          {"area_mm2", patch.area},
          {"force_before_N", patch.force_before},
          {"fluid_share_N", patch.fluid_share},
          {"facet_noise_N", patch.facet_noise},
          {"gap_reached_mm", patch.gap_reached},
          {"left_reach", std::isinf(patch.gap_reached)},
          {"came_back", patch.back},
          {"physical", patch.verdicts[0]},
          {"noise", patch.verdicts[1]},
          {"chatter", patch.verdicts[2]},
          {"verdict", to_string(patch.verdict)},
          {"limited_by", Json::Array(limiters.begin(), limiters.end())},
          {"nodes", Json::Array(nodes.begin(), nodes.end())}};
}

std::vector<LifeLine> make_life(const Ledger& ledger, int node) {
  std::vector<LifeLine> life;
  for (std::size_t i = 0; i < ledger.log.events.size(); ++i)
    if (ledger.event(i).node == node) life.push_back({ledger.event(i).increment, i, {}, {}});
  for (LifeLine& line : life)
    for (std::size_t k = 0; k < ledger.episodes.size(); ++k)
      if (ledger.episodes[k].let_go == line.event) line.episode = k;
  for (std::size_t i = 0; i < ledger.sheet.states.size(); ++i)
    life.push_back({ledger.sheet.states[i].increment, {}, i, {}});
  std::stable_sort(life.begin(), life.end(),
                   [](const LifeLine& a, const LifeLine& b) { return a.increment < b.increment; });
  return life;
}

Json::Object make_life_record(const Ledger& ledger, int node, const LifeLine& line) {
  const auto n = static_cast<std::size_t>(node);
  const bool is_event = line.event.has_value(), is_release = line.episode.has_value();
  const IncrementRow& row = ledger.log.row(line.increment);
  ContactEvent event;
  double pressure = row.pressure, contact_pressure = kUnknown;
  if (is_event) event = ledger.event(*line.event);
  if (line.state) {
    const SheetState& state = ledger.sheet.states[*line.state];
    event.time = state.time;
    event.tool = state.tool[n];
    event.force_after = state.normal_force[n];
    event.gap = state.gap[n];
    pressure = state.pressure;
    contact_pressure = state.contact_pressure[n];
  }
  const bool is_taken_back = is_event && event.kind == EventKind::kTakenBack;
  const Episode episode = is_release ? ledger.episodes[*line.episode] : Episode{};
  return {
      {"increment", line.increment},
      {"time_s", event.time},
      {"what", is_event ? to_string(event.kind) : "state"},
      {"tool", tool_name(ledger, event.tool)},
      {"cause", known_or_null(is_event, event.cause)},
      {"force_before_N", known_or_null(is_event, event.force_before)},
      {"force_N", event.force_after},
      {"gap_mm", event.gap},
      {"contact_pressure_MPa", contact_pressure},
      {"pressure_MPa", pressure},
      {"limited_by", row.limited_by},
      {"limited_at", number_or_null(row.limited_at)},
      {"verdict", known_or_null(is_release || is_taken_back,
                                to_string(is_taken_back ? Verdict::kNoise : episode.verdict))},
      {"reason", known_or_null(is_release || is_taken_back,
                               is_taken_back ? describe_taken_back(ledger, *line.event) : episode.reason)}};
}

std::string make_csv(const Json::Object& keys, const std::vector<Json::Object>& records) {
  std::string csv;
  for (const auto& [key, value] : keys) csv += (csv.empty() ? "" : ",") + key;
  csv += "\n";
  for (const Json::Object& record : records) {
    std::string line;
    for (const auto& [key, value] : record)
      line += (&key == &record.front().first ? "" : ",") + make_cell(value);
    csv += line + "\n";
  }
  return csv;
}

}  // namespace hydroscope
