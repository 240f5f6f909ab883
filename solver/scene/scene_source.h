// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace hydroscope {

/// A value as written in a scene, before anyone knows which key it serves.
struct SourceValue {
  struct Other {  ///< a kind that no key takes: a date, a table inside an array
    std::string what;
  };
  using List = std::vector<SourceValue>;
  std::variant<bool, std::int64_t, double, std::string, List, Other> value;
};

/// One `key = value`, and where it stands.
struct SourceEntry {
  std::vector<std::string> path;  ///< {"tool", "die", "friction"}
  SourceValue value;
  std::string where;  ///< "scene.toml:12", or "--set tool.die.friction=0.1"
  bool is_override = false;
};

/// One table header (or inline table).
struct SourceTable {
  std::vector<std::string> path;
  std::string where;
};

/// A scene as text taken apart, entries in the order of the file, overrides last.
/// An override replaces the entry of the same path.
struct SceneSource {
  std::string file;
  std::vector<SourceTable> tables;
  std::vector<SourceEntry> entries;
};

/// A key given on the command line. `shown` is how the user wrote it.
struct SceneOverride {
  std::string key;    ///< "tool.die.friction"
  std::string value;  ///< as TOML; text may go without quotes
  std::string shown;  ///< "--set tool.die.friction=0.1"
};

/// Takes "tool.die.friction=0.1" apart; throws InputError when there is no `=`.
SceneOverride make_override(const std::string& assignment);

/// Parses TOML; throws InputError "file:line: ..." on broken syntax.
SceneSource parse_scene_source(const std::string& text, const std::string& file,
                               const std::vector<SceneOverride>& overrides);

}  // namespace hydroscope
