// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/inspect/ledger.h"

namespace hydroscope::test {

/// A strip of five square elements, 2 mm wide: nodes 0 to 5 below, 6 to 11 above
/// them. End nodes have 1 mm^2, the others 2 mm^2. Two tools: "die" and "punch".
std::shared_ptr<const SnapshotModel> make_strip_model();

/// A saved state in which nothing touches: gap 1 mm everywhere.
Snapshot make_strip_state(int increment);

/// "9,0.9,detach,3,6,0,0,die,tension,0.5,0,0.01\n": an increment takes 0.1 s, the node lies where the strip
/// has it.
std::string make_event_line(int increment, const std::string& kind, int node,
                            const std::string& rest = "die,tension,0.5,0,0.01");

/// Head and rows for the increments 1 to `last`; the fluid has 10 MPa, then 9 MPa from increment 9 on.
std::string make_history(int last);
std::string make_events(const std::string& lines);

ContactLog make_log(const std::string& event_lines, int last = 30);

/// Log and these states, judged: open from 0.002 mm, pulled from 1 %.
Ledger make_small_ledger(const std::string& event_lines, const std::vector<Snapshot>& states, int last = 30);

/// A run's folder as a run leaves it.
void write_small_run(const std::filesystem::path& folder, const std::string& event_lines,
                     const std::vector<Snapshot>& states);

}  // namespace hydroscope::test
