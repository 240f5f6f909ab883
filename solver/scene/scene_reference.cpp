// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/scene_reference.h"

#include <sstream>

#include "solver/scene/scene_table.h"
#include "solver/scene/scene_values.h"

namespace hydroscope {
namespace {

std::string describe_allowed(const SceneKey& key) {
  std::string allowed;
  for (const std::string& choice : key.choices)
    allowed += (allowed.empty() ? "`\"" : ", `\"") + choice + "\"`";
  return allowed.empty() ? describe_range(key.range) : allowed;
}

std::string describe_default(const SceneTable& table, const SceneKey& key) {
  if (key.is_required) return "required";
  Scene defaults;
  const std::string name = table.is_named() ? table.of.front() : "";
  const std::string value = format_slot(key.slot(defaults, name));
  return value.empty() ? "none" : "`" + value + "`";
}

/// A value outside the range stands for "not given" (a radius of 0).
bool is_default_unset(const SceneKey& key, const SceneSlot& slot) {
  if (const auto* number = std::get_if<double*>(&slot)) return **number < key.range.low;
  if (const auto* number = std::get_if<int*>(&slot)) return **number < key.range.low;
  return false;
}

void write_key(std::ostream& out, const SceneTable& table, const SceneKey& key) {
  Scene defaults;
  const SceneSlot slot = key.slot(defaults, table.is_named() ? table.of.front() : "");
  std::string counts;
  for (const std::string& value : key.condition.values)
    counts += (counts.empty() ? "`" : ", `") + value + "`";
  if (!counts.empty()) counts = " For `" + key.condition.key + "` = " + counts + ".";
  const std::string standard =
      !key.is_required && is_default_unset(key, slot) ? "none" : describe_default(table, key);
  out << "| `" << key.name << "` | " << describe_type(key, slot) << " | " << standard << " | "
      << describe_allowed(key) << " | " << key.doc << counts << " |\n";
}

constexpr const char* kStart = R"(# Scene reference

<!-- Made by `hydroscope reference > docs/scene_reference.md` from solver/scene/scene_table.cpp. Do not edit. -->

A scene is a TOML file. Units are mm, N, MPa and s, and stand in the name of the key. Files are relative to the
scene file. A key that is not in these tables, a value of the wrong type or out of its range, and a key that has
no effect beside the others are errors that name the line. A path is a list of points, `[[0.0, 0.0], [1.0, 35.0]]`:
process time in s and value, linear in between, times increasing.

Any key can be given on the command line, where it replaces that of the file:
`--set tool.die.friction=0.1`, `--set load.control=volume`, `--set 'load.pressure_MPa=[[0, 0], [1, 20]]'`.
)";

}  // namespace

std::string make_scene_reference() {
  std::ostringstream out;
  out << kStart;
  for (const SceneTable& table : scene_tables()) {
    out << "\n## " << (table.name.empty() ? "Top of the file" : "`" + table.header() + "`") << "\n\n"
        << table.doc << "\n\n| key | type | default | allowed | meaning |\n|---|---|---|---|---|\n";
    for (const SceneKey& key : table.keys) write_key(out, table, key);
  }
  return out.str();
}

}  // namespace hydroscope
