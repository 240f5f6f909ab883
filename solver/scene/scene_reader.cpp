// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/scene_reader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "solver/base/error.h"
#include "solver/scene/key_suggestion.h"
#include "solver/scene/scene_checks.h"
#include "solver/scene/scene_table.h"
#include "solver/scene/scene_values.h"

namespace hydroscope {
namespace {

std::string join_path(const std::vector<std::string>& path) {
  std::string joined;
  for (const std::string& part : path) joined += (joined.empty() ? "" : ".") + part;
  return joined;
}

std::vector<std::string> table_names() {
  std::vector<std::string> names;
  for (const SceneTable& table : scene_tables()) {
    if (!table.name.empty()) names.push_back(table.name);
  }
  return names;
}

/// Names become columns and file names.
bool is_plain_name(const std::string& name) {
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  return !name.empty() && name.size() <= 60 && std::all_of(name.begin(), name.end(), allowed);
}

[[noreturn]] void fail_unknown_table(const std::string& where, const std::string& name) {
  const std::string nearest = find_nearest_name(name, table_names());
  throw InputError(where + ": table '[" + name + "]': unknown" +
                   (nearest.empty() ? "" : "; did you mean '[" + nearest + "]'?"));
}

[[noreturn]] void fail_unknown_key(const std::string& where, const std::string& path, const std::string& key,
                                   const SceneTable& table) {
  const std::string start = where + ": key '" + path + "': unknown";
  const std::string nearest = find_nearest_name(key, table.key_names());
  if (!nearest.empty()) throw InputError(start + "; did you mean '" + nearest + "'?");
  for (const SceneTable& other : scene_tables()) {
    if (other.find(key) != nullptr) throw InputError(start + "; it belongs to " + other.header());
  }
  std::string list;
  for (const std::string& name : table.key_names()) list += (list.empty() ? "" : ", ") + name;
  throw InputError(start + "; known here: " + list);
}

void check_table_header(const SourceTable& header) {
  const std::string& name = header.path.front();
  const SceneTable* table = find_scene_table(name);
  if (table == nullptr || name.empty()) {
    const SceneKey* top = find_scene_table("")->find(name);
    if (top != nullptr)
      throw InputError(header.where + ": key '" + name + "': is a table here; expected a value");
    fail_unknown_table(header.where, name);
  }
  const size_t deepest = table->is_named() ? 2 : 1;
  if (header.path.size() > deepest) {
    const std::string& key = header.path[deepest];
    if (table->find(key) != nullptr) {
      throw InputError(header.where + ": key '" + join_path(header.path) +
                       "': is a table here; expected a value");
    }
    fail_unknown_key(header.where, join_path(header.path), key, *table);
  }
  if (header.path.size() < 2) return;
  const std::string& own = header.path[1];
  if (table->of.front() != "*" && std::find(table->of.begin(), table->of.end(), own) == table->of.end()) {
    throw InputError(header.where + ": table '[" + name + "." + own + "]': unknown; allowed: " +
                     table->header() + " and [" + name + "." + table->of.back() + "]");
  }
  if (!is_plain_name(own)) {
    throw InputError(header.where + ": table '[" + name + "." + own +
                     "]': the name may have letters, digits, '_' and '-' only");
  }
}

struct Resolved {
  const SceneTable* table = nullptr;
  const SceneKey* key = nullptr;
  std::string name;  ///< of a named table
};

Resolved resolve(const SourceEntry& entry) {
  const std::string path = join_path(entry.path);
  if (entry.path.size() == 1) {
    const SceneTable* table = find_scene_table(entry.path[0]);
    if (table != nullptr && !entry.path[0].empty()) {
      throw InputError(entry.where + ": key '" + path + "': is a table; write " + table->header());
    }
    const SceneTable& top = *find_scene_table("");
    const SceneKey* key = top.find(entry.path[0]);
    if (key == nullptr) fail_unknown_key(entry.where, path, path, top);
    return {&top, key, ""};
  }
  const SceneTable* table = find_scene_table(entry.path[0]);
  if (table == nullptr) fail_unknown_table(entry.where, entry.path[0]);
  const size_t depth = table->is_named() ? 3 : 2;
  if (entry.path.size() < depth) {
    throw InputError(entry.where + ": key '" + path + "': [" + table->name +
                     "] holds tables by name; write " + table->header());
  }
  const SceneKey* key = entry.path.size() == depth ? table->find(entry.path.back()) : nullptr;
  if (key == nullptr) fail_unknown_key(entry.where, path, entry.path[depth - 1], *table);
  return {table, key, table->is_named() ? entry.path[1] : std::string()};
}

std::string text_in(const SceneTable& table, const std::string& key, Scene& scene, const std::string& name) {
  return *std::get<std::string*>(table.find(key)->slot(scene, name));
}

std::string describe_condition(const SceneKey& key) {
  std::string values;
  for (const std::string& value : key.condition.values)
    values += (values.empty() ? "\"" : " or \"") + value + "\"";
  return key.condition.key + " = " + values;
}

/// Required keys are there, and no key is given that the chosen kind does not read.
void check_kinds(Scene& scene, const GivenKeys& given, const SceneTable& table, const std::string& path,
                 const std::string& name) {
  for (const SceneKey& key : table.keys) {
    bool counts = true;
    if (!key.condition.key.empty()) {
      const std::string chosen = text_in(table, key.condition.key, scene, name);
      const auto& values = key.condition.values;
      counts = std::find(values.begin(), values.end(), chosen) != values.end();
    }
    const std::string full = path + "." + key.name;
    const std::string selector = path + "." + key.condition.key;
    if (!counts && given.has(full) && (given.is_override(full) || !given.is_override(selector))) {
      given.fail(full, "has no effect here; it is for " + describe_condition(key));
    }
    if (counts && key.is_required && !given.has(full)) {
      given.fail_at(path,
                    "key '" + full + "' is missing" +
                        (key.condition.key.empty() ? "" : " (needed with " + describe_condition(key) + ")"));
    }
  }
}

void check_all_kinds(Scene& scene, const GivenKeys& given, const SceneSource& source) {
  for (const SourceTable& header : source.tables) {
    const SceneTable& table = *find_scene_table(header.path.front());
    if (header.path.size() != (table.is_named() ? 2U : 1U)) continue;
    check_kinds(scene, given, table, join_path(header.path),
                table.is_named() ? header.path[1] : std::string());
  }
}

void set_dependent_defaults(Scene& scene, const GivenKeys& given) {
  for (auto& [name, quantity] : scene.quantities) {
    if (quantity.kind == "corner_radius" && !given.has("quantity." + name + ".angle_deg"))
      quantity.angle = 45.0;
    if (quantity.kind == "sum" && quantity.factors.empty()) quantity.factors.assign(quantity.of.size(), 1.0);
  }
}

/// So that `[tool.die]` without a key exists, too.
void touch_named_table(Scene& scene, const SourceTable& header) {
  const SceneTable* table = find_scene_table(header.path.front());
  if (table->is_named() && header.path.size() == 2) table->keys.front().slot(scene, header.path[1]);
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& file,
                  const std::vector<SceneOverride>& overrides, bool require_files) {
  const SceneSource source = parse_scene_source(text, file, overrides);
  Scene scene;
  scene.file = file;
  scene.directory = std::filesystem::path(file).parent_path().string();
  if (scene.directory.empty()) scene.directory = ".";
  GivenKeys given(file);
  for (const SourceTable& header : source.tables) {
    check_table_header(header);
    touch_named_table(scene, header);
    given.add(join_path(header.path), header.where, false);
  }
  for (const SourceEntry& entry : source.entries) {
    const Resolved found = resolve(entry);
    const std::string path = join_path(entry.path);
    given.add(path, entry.where, entry.is_override);
    const std::string fault = assign_value(entry.value, *found.key, found.key->slot(scene, found.name));
    if (!fault.empty()) given.fail(path, fault);
  }
  check_all_kinds(scene, given, source);
  set_dependent_defaults(scene, given);
  check_scene(scene, given);
  if (require_files) check_scene_files(scene, given);
  return scene;
}

Scene read_scene(const std::string& file, const std::vector<SceneOverride>& overrides) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw InputError(file + ": no such scene file");
  if (!std::filesystem::is_regular_file(file, error)) throw InputError(file + ": is not a scene file");
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) throw InputError(file + ": cannot be read");
  return parse_scene(text.str(), file, overrides, true);
}

}  // namespace hydroscope
