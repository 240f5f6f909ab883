// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/contact_log.h"

#include <algorithm>

#include "solver/base/error.h"
#include "solver/scene/key_suggestion.h"

namespace hydroscope {
namespace {

std::map<int, IncrementRow> read_increments(const CsvTable& table) {
  const std::size_t increment = table.column("increment"), time = table.column("time_s"),
                    pressure = table.column("pressure_MPa"), fraction = table.column("step_fraction"),
                    by = table.column("limited_by"), at = table.column("limited_at");
  std::map<int, IncrementRow> rows;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const int number = table.whole_number(i, increment);
    if (!rows.empty() && number <= rows.rbegin()->first) table.fail(i, "increments do not rise");
    rows[number] = {table.number(i, time), table.number(i, pressure), table.number(i, fraction),
                    table.text(i, by), table.whole_number(i, at)};
  }
  return rows;
}

int find_tool(const CsvTable& table, std::size_t row, const std::string& name, const LogBounds& bounds) {
  const auto found = std::find(bounds.tools.begin(), bounds.tools.end(), name);
  if (found == bounds.tools.end()) table.fail(row, "the run has no tool '" + name + "'");
  return static_cast<int>(found - bounds.tools.begin());
}

ContactEvent read_event(const CsvTable& table, std::size_t row, const LogBounds& bounds) {
  ContactEvent event;
  event.increment = table.whole_number(row, table.column("increment"));
  event.time = table.number(row, table.column("time_s"));
  event.kind = parse_event_kind(table.text(row, table.column("kind")),
                                table.file() + ":" + std::to_string(table.line(row)) + ": ");
  event.node = table.whole_number(row, table.column("node"));
  if (event.node < 0 || event.node >= bounds.nodes)
    table.fail(row, "node " + std::to_string(event.node) + ": the sheet has nodes 0 to " +
                        std::to_string(bounds.nodes - 1));
  event.position = {table.number(row, table.column("x_mm")), table.number(row, table.column("y_mm")),
                    table.number(row, table.column("z_mm"))};
  event.tool = find_tool(table, row, table.text(row, table.column("tool")), bounds);
  event.cause = table.text(row, table.column("cause"));
  event.force_before = table.number(row, table.column("force_before_N"));
  event.force_after = table.number(row, table.column("force_after_N"));
  event.gap = table.number(row, table.column("gap_mm"));
  return event;
}

/// Older runs have neither of the two columns, and no force of that moment.
ReleaseNote read_note(const CsvTable& table, std::size_t row, const ContactEvent& event) {
  const auto pressure = table.find_column("patch_pressure_MPa"), threshold = table.find_column("threshold_N");
  const bool is_release = event.kind == EventKind::kDetach || event.kind == EventKind::kTakenBack;
  if (!is_release || !pressure || !threshold) return {};
  return {event.force_after, table.number(row, *threshold), table.number(row, *pressure)};
}

}  // namespace

const IncrementRow& ContactLog::row(int increment) const {
  static const IncrementRow kNothing;
  const auto found = increments.find(increment);
  return found != increments.end() ? found->second : kNothing;
}

const std::vector<std::string>& event_kind_names() {
  static const std::vector<std::string> kNames = {"touch",  "stick",   "slip",
                                                  "detach", "retouch", "taken-back"};
  return kNames;
}

EventKind parse_event_kind(const std::string& text, const std::string& place) {
  const auto& names = event_kind_names();
  for (int i = 0; i < static_cast<int>(names.size()); ++i)
    if (text == to_string(static_cast<EventKind>(i))) return static_cast<EventKind>(i);
  const std::string nearest = find_nearest_name(text, names);
  throw InputError(place + "'" + text + "' is no kind of event" +
                   (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") +
                   " (touch, stick, slip, detach, retouch, taken-back)");
}

ContactLog make_contact_log(const CsvTable& events, const CsvTable& history, const LogBounds& bounds) {
  ContactLog log;
  log.increments = read_increments(history);
  const int last = log.increments.empty() ? 0 : log.increments.rbegin()->first;
  int increment = 0;
  for (std::size_t i = 0; i < events.rows(); ++i) {
    const ContactEvent event = read_event(events, i, bounds);
    if (event.increment < increment) events.fail(i, "increments do not rise");
    increment = event.increment;
    if (increment > last) break;
    if (log.increments.count(increment) == 0)
      events.fail(i, "increment " + std::to_string(increment) + " is not in " + history.file());
    log.events.push_back(event);
    log.notes.push_back(read_note(events, i, event));
    log.event_places.push_back(events.file() + ":" + std::to_string(events.line(i)));
  }
  return log;
}

}  // namespace hydroscope
