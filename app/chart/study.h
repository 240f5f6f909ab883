// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/scene/scene_source.h"

namespace hydroscope {

/// A study file as read: plain values; see docs/charts.md for each key. `where` is the
/// place in the file, for messages.

/// One setting of an axis, or a variant: scene keys that it replaces.
struct StudySetting {
  std::string name;
  std::string label;  ///< on charts; the name if not given
  std::string where;
  std::vector<SceneOverride> overrides;
  std::optional<double> size;  ///< of a numeric axis
};

/// One dimension of the grid of settings.
struct StudyAxis {
  std::string name, label, where;
  std::vector<StudySetting> settings;
  bool is_inverse = false;  ///< its numbers are counts: charts of convergence use 1 / number
};

/// What is compared.
struct StudyQuantity {
  std::string name, label, where;
  std::string column;  ///< of history.csv
  std::string driver;  ///< column at whose `at` values it is taken; empty: at the end of the run
  std::vector<double> at;
  enum class Reference { kFormula, kTable, kFinest } reference = Reference::kFinest;
  std::string formula;          ///< name of a closed form
  std::vector<double> values;   ///< of the table: one for each of `at`, or one
  std::string source;           ///< where the table's values come from
  std::optional<double> scale;  ///< errors are relative to this instead of the reference
};

/// A point of another program.
struct StudyElsewhere {
  std::string name, label, where, note;
  std::optional<double> error_percent, wall_s, factorisations;
};

/// Columns of history.csv of chosen runs.
struct StudyHistory {
  std::string name, title, where;
  std::string x = "increment";
  std::vector<std::string> columns, runs;  ///< no runs: all
  bool is_log = true;
};

struct StudyConvergence {
  std::string name, title, where, axis;
};

/// Thickness around the section in saved states of chosen runs.
struct StudyProfile {
  std::string name, title, where;
  std::vector<std::string> runs;
  std::vector<double> at_pressure;  ///< [MPa], the nearest saved states; none: the last state
  std::string formula;              ///< closed form over the angle; may be empty
  std::string driver;               ///< column whose value at the state the closed form needs
};

struct StudyCase {
  std::string name, title, where;
  std::string scene;  ///< path as it can be opened
  std::string scene_where;
  std::string standard;  ///< id of the run with the default settings; empty: none
  bool is_timed = true;
  bool is_rms = false;  ///< error of a run: root of the mean square, else the largest
  std::vector<SceneOverride> set;
  std::vector<StudyAxis> axes;
  std::vector<StudySetting> variants;
  std::vector<std::string> without;  ///< ids of the grid that are left out
  std::optional<StudySetting> finest;
  std::vector<StudyQuantity> quantities;
  std::vector<StudyElsewhere> elsewhere;
  std::vector<StudyHistory> histories;
  std::vector<StudyConvergence> convergences;
  std::vector<StudyProfile> profiles;
};

/// Columns of any CSV file.
struct StudyPlot {
  std::string name, title, where, file;
  std::string x, x_title, y_title;
  std::vector<std::string> y;
  bool is_x_log = false, is_y_log = false;
  std::optional<double> slope;  ///< a line of this slope beside the first series
};

struct Study {
  std::string file;
  std::string title;
  int jobs = 0;  ///< accuracy runs at a time; 0: as many as cores
  int repeats = 3;
  int threads = 1;                    ///< of timed runs
  double time_limit = 600.0;          ///< [s] of one run
  double finest_time_limit = 3600.0;  ///< [s] of a finest run
  double timed_once_from = 60.0;      ///< [s] of solving from which a run is timed once only
  std::vector<StudyCase> cases;
  std::vector<StudyPlot> plots;
};

/// Reads a study file. Throws InputError with place, key, value and what is expected; scenes are
/// read with every set of settings, so that a wrong scene key is told before anything runs.
Study read_study(const std::filesystem::path& file);

/// The same from text, without looking at scenes and files.
Study parse_study(const std::string& text, const std::filesystem::path& file);

}  // namespace hydroscope
