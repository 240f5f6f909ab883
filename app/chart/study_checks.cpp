// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/study_checks.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/chart/study_entry.h"
#include "app/chart/study_grid.h"
#include "solver/base/error.h"
#include "solver/scene/scene_reader.h"

namespace hydroscope {
namespace {

void need(bool holds, const std::string& where, const std::string& what) {
  if (!holds) throw InputError(where + ": " + what);
}

/// Names become parts of file names.
void check_name(const std::string& name, const std::string& where) {
  const auto allowed = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
  };
  need(!name.empty() && name[0] != '.' && std::all_of(name.begin(), name.end(), allowed), where,
       "name '" + name + "': letters, digits, _, - and . expected");
}

void label(std::string& text, const std::string& name) {
  if (text.empty()) text = name;
}

void check_quantity(StudyQuantity& q, const StudyCase& one) {
  const std::string start = "quantity '" + q.name + "': ";
  label(q.label, q.name);
  if (q.column.empty()) q.column = "q." + q.name;
  need(q.driver.empty() == q.at.empty(), q.where,
       start +
           "'driver' (a column) and 'at' (its values) go together; without both the end of the run counts");
  using Reference = StudyQuantity::Reference;
  need(q.reference != Reference::kFormula || !q.formula.empty(), q.where, start + "'formula' expected");
  need(q.reference == Reference::kFormula || q.formula.empty(), q.where,
       start + "'formula' counts only with reference = \"formula\"");
  need(q.reference == Reference::kTable || q.values.empty(), q.where,
       start + "'values' count only with reference = \"table\"");
  need(q.reference != Reference::kTable || q.values.size() == std::max<std::size_t>(q.at.size(), 1), q.where,
       start + "'values': one for each of 'at' expected");
  need(q.reference != Reference::kTable || !q.source.empty(), q.where,
       start + "'source' expected: where the values come from");
  need(q.reference != Reference::kFinest || one.finest, q.where,
       start + "[case." + one.name + ".finest] expected, the settings of the finest run");
}

void check_runs(const std::vector<std::string>& runs, const StudyCase& one, const std::string& where,
                const std::string& key) {
  const std::vector<std::string> known = find_run_ids(one);
  for (const std::string& run : runs)
    if (std::find(known.begin(), known.end(), run) == known.end()) fail_unknown(where, key, run, known);
}

void check_axes(StudyCase& one) {
  for (StudyAxis& axis : one.axes) {
    label(axis.label, axis.name);
    need(!axis.settings.empty() && !axis.settings[0].name.empty(), axis.where,
         "axis '" + axis.name + "': 'key' and 'values', or tables [case." + one.name + ".axis." + axis.name +
             ".point.NAME] expected");
    std::set<std::string> names;
    for (StudySetting& setting : axis.settings) {
      label(setting.label, setting.name);
      check_name(setting.name, setting.where);
      need(names.insert(setting.name).second, setting.where, "'" + setting.name + "' is there twice");
    }
  }
}

void check_parts(StudyCase& one) {
  for (StudyQuantity& quantity : one.quantities) check_quantity(quantity, one);
  for (StudyElsewhere& point : one.elsewhere) {
    label(point.label, point.name);
    need(point.error_percent.has_value(), point.where,
         "elsewhere '" + point.name + "': 'error_percent' expected");
  }
  for (StudyHistory& history : one.histories) {
    check_name(history.name, history.where);
    need(!history.columns.empty(), history.where, "history '" + history.name + "': 'columns' expected");
    check_runs(history.runs, one, history.where, "runs");
  }
  for (StudyProfile& profile : one.profiles) {
    check_name(profile.name, profile.where);
    check_runs(profile.runs, one, profile.where, "runs");
    need(profile.formula.empty() || !profile.driver.empty(), profile.where,
         "profile '" + profile.name +
             "': 'formula' needs 'driver', the column of history.csv that it is a function of");
  }
  for (StudyConvergence& convergence : one.convergences) {
    check_name(convergence.name, convergence.where);
    std::vector<std::string> numeric;
    for (const StudyAxis& axis : one.axes)
      if (std::all_of(axis.settings.begin(), axis.settings.end(),
                      [](const auto& s) { return s.size.has_value(); }))
        numeric.push_back(axis.name);
    if (std::find(numeric.begin(), numeric.end(), convergence.axis) == numeric.end())
      fail_unknown(convergence.where, "convergence '" + convergence.name + "': axis of numbers",
                   convergence.axis, numeric);
  }
}

void check_case(StudyCase& one) {
  check_name(one.name, one.where);
  label(one.title, one.name);
  need(!one.scene.empty(), one.where, "[case." + one.name + "]: key 'scene' expected, a scene file");
  check_axes(one);
  for (StudySetting& variant : one.variants) {
    check_name(variant.name, variant.where);
    label(variant.label, variant.name);
  }
  if (!one.standard.empty()) check_runs({one.standard}, one, one.where, "default");
  StudyCase whole = one;
  whole.without.clear();
  check_runs(one.without, whole, one.where, "without");
  const auto ids = find_run_ids(one);
  need(!ids.empty(), one.where, "[case." + one.name + "]: 'without' leaves no run");
  std::set<std::string> seen;
  for (const std::string& id : ids)
    need(seen.insert(id).second, one.where, "two runs are called '" + id + "'");
  check_parts(one);
}

void check_plot(StudyPlot& plot) {
  check_name(plot.name, plot.where);
  need(!plot.file.empty() && !plot.x.empty() && !plot.y.empty(), plot.where,
       "[plot." + plot.name + "]: 'file', 'x' and 'y' expected");
  label(plot.title, plot.name);
  label(plot.x_title, plot.x);
}

/// A column of history.csv that is a quantity must be one of the scene's.
void check_column(const std::string& column, const std::string& where, const Scene& scene) {
  if (column.rfind("q.", 0) != 0) return;
  std::vector<std::string> known;
  for (const auto& [name, quantity] : scene.quantities) known.push_back("q." + name);
  if (std::find(known.begin(), known.end(), column) == known.end())
    fail_unknown(where, "quantity of " + scene.file, column, known);
}

void check_columns(const StudyCase& one, const Scene& scene) {
  for (const StudyQuantity& quantity : one.quantities) {
    check_column(quantity.column, quantity.where, scene);
    check_column(quantity.driver, quantity.where, scene);
  }
  for (const StudyHistory& history : one.histories) {
    check_column(history.x, history.where, scene);
    for (const std::string& column : history.columns) check_column(column, history.where, scene);
  }
  for (const StudyProfile& profile : one.profiles) check_column(profile.driver, profile.where, scene);
}

}  // namespace

void check_study(Study& study) {
  if (study.cases.empty() && study.plots.empty())
    throw InputError(study.file + ":1: a table [case.NAME] or [plot.NAME] expected");
  for (StudyCase& one : study.cases) check_case(one);
  for (StudyPlot& plot : study.plots) check_plot(plot);
  if (study.title.empty()) study.title = std::filesystem::path(study.file).stem().string();
}

void check_study_scenes(const Study& study) {
  for (const StudyCase& one : study.cases) {
    if (!std::filesystem::exists(one.scene))
      throw InputError(one.scene_where + ": key 'scene': there is no file " + one.scene);
    for (const StudyRun& run : make_study_runs(one)) {
      try {
        read_scene(one.scene, run.overrides);
      } catch (const InputError& error) {
        throw InputError(one.where + ": [case." + one.name + "], run '" + run.id + "': " + error.what());
      }
    }
    check_columns(one, read_scene(one.scene, make_study_runs(one).front().overrides));
  }
  for (const StudyPlot& plot : study.plots)
    need(std::filesystem::exists(plot.file), plot.where,
         "[plot." + plot.name + "]: key 'file': there is no file " + plot.file);
}

}  // namespace hydroscope
