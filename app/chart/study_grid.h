// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/chart/study.h"

namespace hydroscope {

/// One run of a case's grid.
struct StudyRun {
  std::string id;     ///< "none+newton": the axes' settings, or the variant's name
  std::string label;  ///< the same for charts
  std::vector<SceneOverride> overrides;
  std::vector<int> settings;  ///< one an axis; empty for variants
  bool is_finest = false;     ///< the reference, not a point of the charts
};

/// All runs: the product of the axes in the order of the file, the first axis slowest, then the
/// variants, then the finest run. A case with neither axes nor variants has one run, "base".
std::vector<StudyRun> make_study_runs(const StudyCase& one);
std::vector<std::string> find_run_ids(const StudyCase& one);

}  // namespace hydroscope
