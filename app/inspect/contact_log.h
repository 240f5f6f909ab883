// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "app/inspect/csv_table.h"
#include "solver/increment/report.h"

namespace hydroscope {

/// What history.csv says of one increment, as far as contact asks for it.
struct IncrementRow {
  double time = 0.0;           ///< [s]
  double pressure = 0.0;       ///< [MPa]
  double step_fraction = 0.0;  ///< r_min
  std::string limited_by;      ///< "strain", "release" ...
  int limited_at = -1;         ///< node or element; -1 none
};

/// What a run keeps of the moment within an increment in which a node let go. NaN: it keeps it not.
struct ReleaseNote {
  double force = std::numeric_limits<double>::quiet_NaN();      ///< normal force that released it [N]
  double threshold = std::numeric_limits<double>::quiet_NaN();  ///< tension from which it was to let go [N]
  double pressure = std::numeric_limits<double>::quiet_NaN();   ///< smoothed contact pressure [MPa]
};

/// The contact events of a run with the increments in which they came.
struct ContactLog {
  std::vector<ContactEvent> events;       ///< in order of increments
  std::vector<std::string> event_places;  ///< "events.csv:12" of each
  std::vector<ReleaseNote> notes;         ///< of each; of lettings go, taken back or not
  std::map<int, IncrementRow> increments;

  /// The increment's row; one of zeros when there is none.
  const IncrementRow& row(int increment) const;
};

/// What nodes and tools the events may name.
struct LogBounds {
  int nodes = 0;
  std::vector<std::string> tools;
};

/// Checks kinds, nodes, tools and order. Events behind the last row of the history
/// are left out: a run that was cut off writes its events first. Throws InputError with file and line.
ContactLog make_contact_log(const CsvTable& events, const CsvTable& history, const LogBounds& bounds);

/// "detach" -> kDetach; throws InputError with the nearest kind, starting with `place`.
EventKind parse_event_kind(const std::string& text, const std::string& place);

/// Names of all kinds, in order.
const std::vector<std::string>& event_kind_names();

}  // namespace hydroscope
