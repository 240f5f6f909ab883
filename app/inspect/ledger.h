// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/inspect/patch.h"
#include "app/inspect/verdict.h"
#include "app/results/result_folder.h"

namespace hydroscope {

/// All lettings go of a run, with what is known of each.
struct Ledger {
  std::string title;
  std::vector<std::string> tools;
  ContactLog log;
  SheetHistory sheet;
  VerdictBounds bounds;
  std::vector<Episode> episodes;  ///< in order of their first events
  std::vector<Patch> patches;     ///< in order of time

  const ContactEvent& event(std::size_t index) const { return log.events[index]; }
};

/// Episodes, figures, verdicts and patches from what has been read.
Ledger make_ledger(ContactLog log, SheetHistory sheet, const VerdictBounds& bounds,
                   const FacetNoiseModel& noise = {}, const std::vector<ToolMotion>& motions = {});

/// Reads a run's folder; finished or not. Throws InputError.
Ledger read_ledger(const ResultFolder& folder);

}  // namespace hydroscope
