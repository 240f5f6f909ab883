// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/study_grid.h"

#include <algorithm>

namespace hydroscope {
namespace {

/// A later override of a key takes the place of an earlier one.
void add_overrides(std::vector<SceneOverride>& all, const std::vector<SceneOverride>& more) {
  for (const SceneOverride& item : more) {
    std::erase_if(all, [&item](const SceneOverride& old) { return old.key == item.key; });
    all.push_back(item);
  }
}

std::vector<StudyRun> make_product(const StudyCase& one) {
  std::vector<StudyRun> runs = {{"", "", one.set, {}, false}};
  for (const StudyAxis& axis : one.axes) {
    std::vector<StudyRun> longer;
    for (const StudyRun& run : runs)
      for (std::size_t i = 0; i < axis.settings.size(); ++i) {
        const StudySetting& setting = axis.settings[i];
        StudyRun next = run;
        next.id += (next.id.empty() ? "" : "+") + setting.name;
        // An axis of one setting tells nothing on a chart.
        if (axis.settings.size() > 1) next.label += (next.label.empty() ? "" : " / ") + setting.label;
        add_overrides(next.overrides, setting.overrides);
        next.settings.push_back(static_cast<int>(i));
        longer.push_back(std::move(next));
      }
    runs = std::move(longer);
  }
  return runs;
}

}  // namespace

std::vector<StudyRun> make_study_runs(const StudyCase& one) {
  std::vector<StudyRun> runs;
  if (!one.axes.empty()) runs = make_product(one);
  if (one.axes.empty() && one.variants.empty()) runs = {{"base", "base", one.set, {}, false}};
  std::erase_if(runs, [&one](const StudyRun& run) {
    return std::find(one.without.begin(), one.without.end(), run.id) != one.without.end();
  });
  const auto add = [&](const StudySetting& setting, bool is_finest) {
    StudyRun run{setting.name, setting.label, one.set, {}, is_finest};
    add_overrides(run.overrides, setting.overrides);
    runs.push_back(std::move(run));
  };
  for (const StudySetting& variant : one.variants) add(variant, false);
  if (one.finest) add(*one.finest, true);
  for (StudyRun& run : runs)
    if (run.label.empty()) run.label = run.id;
  return runs;
}

std::vector<std::string> find_run_ids(const StudyCase& one) {
  std::vector<std::string> ids;
  for (const StudyRun& run : make_study_runs(one)) ids.push_back(run.id);
  return ids;
}

}  // namespace hydroscope
