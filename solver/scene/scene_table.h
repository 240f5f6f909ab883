// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "solver/scene/scene.h"

namespace hydroscope {

/// The member that a key fills. Its C++ type says what may be written.
/// Lists of rows and paths have a first column that must increase.
using SceneSlot =
    std::variant<double*, std::optional<double>*, int*, bool*, std::string*, std::array<double, 2>*,
                 std::array<double, 3>*, std::array<int, 2>*, Path*, std::vector<std::array<double, 2>>*,
                 std::vector<std::array<double, 4>>*, std::vector<std::string>*, std::vector<double>*>;

/// Allowed values, both ends included.
struct KeyRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

/// A key that counts only when another key of its table has one of some values.
struct KeyCondition {
  std::string key;  ///< empty: always
  std::vector<std::string> values;
};

/// All there is to know of one scene key; parsing, checks and documentation come from here.
struct SceneKey {
  std::string name;
  std::string unit;  ///< "" for a pure number; otherwise the end of the name, too
  std::string doc;   ///< one sentence
  SceneSlot (*slot)(Scene& scene, const std::string& table_name) = nullptr;
  KeyRange range;                    ///< of every number in the value (of a row: not of the first column)
  std::vector<std::string> choices;  ///< of text
  KeyCondition condition;
  bool is_required = false;  ///< whenever the condition holds

  SceneKey& in(double low, double high);
  SceneKey& one_of(std::vector<std::string> names);
  SceneKey& when(std::string key, std::vector<std::string> values);
  SceneKey& required();
};

struct SceneTable {
  std::string name;             ///< "" for the keys before the first table
  std::string doc;              ///< what it describes
  std::vector<std::string> of;  ///< names that a named table may have: {"*"} any; empty: not a named table
  std::vector<SceneKey> keys;

  bool is_named() const { return !of.empty(); }
  /// "[tool.NAME]" as in the documentation.
  std::string header() const;
  const SceneKey* find(const std::string& key) const;
  std::vector<std::string> key_names() const;
};

/// The whole table, in the order in which the documentation lists it.
const std::vector<SceneTable>& scene_tables();
const SceneTable* find_scene_table(const std::string& name);

}  // namespace hydroscope
