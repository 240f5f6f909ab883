// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that knows the TOML library.
#include "solver/scene/scene_source.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <tuple>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

std::string make_place(const std::string& file, const toml::source_region& region) {
  return file + ":" + std::to_string(region.begin.line);
}

SourceValue convert(const toml::node& node) {
  if (const auto* flag = node.as_boolean()) return {flag->get()};
  if (const auto* integer = node.as_integer()) return {integer->get()};
  if (const auto* number = node.as_floating_point()) return {number->get()};
  if (const auto* text = node.as_string()) return {text->get()};
  if (const auto* array = node.as_array()) {
    SourceValue::List list;
    for (const toml::node& item : *array) list.push_back(convert(item));
    return {std::move(list)};
  }
  return {SourceValue::Other{node.is_table() ? "a table" : "a date or time"}};
}

struct Collector {
  const std::string& file;
  SceneSource& source;
  std::vector<std::tuple<unsigned, unsigned, size_t>> order;  ///< line, column, entry

  void collect(const toml::table& table, const std::vector<std::string>& path) {
    for (const auto& [key, node] : table) {
      std::vector<std::string> inner = path;
      inner.emplace_back(key.str());
      if (const auto* inner_table = node.as_table()) {
        source.tables.push_back({inner, make_place(file, key.source())});
        collect(*inner_table, inner);
      } else {
        order.emplace_back(key.source().begin.line, key.source().begin.column, source.entries.size());
        source.entries.push_back({inner, convert(node), make_place(file, key.source()), false});
      }
    }
  }

  /// The library sorts keys by name; errors should come in the order of the file.
  void sort_as_written() {
    std::sort(order.begin(), order.end());
    std::vector<SourceEntry> sorted;
    sorted.reserve(order.size());
    for (const auto& [line, column, index] : order) sorted.push_back(std::move(source.entries[index]));
    source.entries = std::move(sorted);
  }
};

std::vector<std::string> split_key(const std::string& key) {
  std::vector<std::string> parts;
  std::istringstream stream(key);
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  return parts;
}

/// A word such as `volume` or `dies/square.stl`, which a shell user will not put in quotes.
bool is_bare_word(const std::string& text) {
  const auto allowed = [](unsigned char c) {
    return std::isalnum(c) != 0 ||
           std::string_view("_-./").find(static_cast<char>(c)) != std::string_view::npos;
  };
  return !text.empty() &&
         (std::isalpha(static_cast<unsigned char>(text[0])) != 0 || text[0] == '.' || text[0] == '/') &&
         std::all_of(text.begin(), text.end(), allowed);
}

SourceValue parse_override_value(const SceneOverride& item) {
  try {
    const toml::table table = toml::parse("value = " + item.value);
    if (table.size() == 1 && table.contains("value")) return convert(*table.get("value"));
  } catch (const toml::parse_error&) {
    if (is_bare_word(item.value)) return {item.value};
  }
  throw InputError(item.shown + ": '" + item.value +
                   "' is not a TOML value (a number, true, false, \"text\" or [a, list])");
}

void apply_override(const SceneOverride& item, SceneSource& source) {
  SourceEntry entry{split_key(item.key), parse_override_value(item), item.shown, true};
  std::erase_if(source.entries, [&entry](const SourceEntry& old) { return old.path == entry.path; });
  for (size_t depth = 1; depth < entry.path.size(); ++depth) {
    const std::vector<std::string> path(entry.path.begin(), entry.path.begin() + static_cast<long>(depth));
    const auto same = [&path](const SourceTable& table) { return table.path == path; };
    if (std::none_of(source.tables.begin(), source.tables.end(), same)) {
      source.tables.push_back({path, item.shown});
    }
  }
  source.entries.push_back(std::move(entry));
}

}  // namespace

SceneOverride make_override(const std::string& assignment) {
  const size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError("--set " + assignment + ": write it as key=value, e.g. --set tool.die.friction=0.1");
  }
  const auto trim = [](const std::string& text) {
    const size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
  };
  return {trim(assignment.substr(0, equals)), trim(assignment.substr(equals + 1)), "--set " + assignment};
}

SceneSource parse_scene_source(const std::string& text, const std::string& file,
                               const std::vector<SceneOverride>& overrides) {
  SceneSource source;
  source.file = file;
  try {
    const toml::table table = toml::parse(text, file);
    Collector collector{file, source, {}};
    collector.collect(table, {});
    collector.sort_as_written();
  } catch (const toml::parse_error& error) {
    throw InputError(make_place(file, error.source()) +
                     ": not valid TOML: " + std::string(error.description()));
  }
  for (const SceneOverride& item : overrides) apply_override(item, source);
  return source;
}

}  // namespace hydroscope
