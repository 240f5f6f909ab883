// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/study_keys.h"

namespace hydroscope {
namespace {

std::string join_path(const StudyPath& path, std::size_t first) {
  std::string text;
  for (std::size_t i = first; i < path.size(); ++i) text += (text.empty() ? "" : ".") + path[i];
  return text;
}

int find_line(const std::string& where) { return std::stoi(where.substr(where.rfind(':') + 1)); }

}  // namespace

SceneOverride make_scene_override(const SourceEntry& entry, std::size_t first) {
  const std::string key = join_path(entry.path, first), value = write_toml(entry.value);
  return {key, value, entry.where + ": " + key + " = " + value};
}

void set_study_key(const SourceEntry& entry, const std::string& table, const KeySetters& setters) {
  const auto found = setters.find(entry.path.back());
  if (found == setters.end()) {
    std::vector<std::string> known;
    for (const auto& [name, setter] : setters) known.push_back(name);
    fail_unknown(entry.where, "key in " + table, entry.path.back(), known);
  }
  found->second(StudyEntry(entry));
}

KeySetter to(std::string& text) {
  return [&text](const StudyEntry& e) { text = e.text(); };
}
KeySetter to(bool& flag) {
  return [&flag](const StudyEntry& e) { flag = e.flag(); };
}
KeySetter to(std::vector<double>& numbers) {
  return [&numbers](const StudyEntry& e) { numbers = e.numbers(); };
}
KeySetter to(std::vector<std::string>& texts) {
  return [&texts](const StudyEntry& e) { texts = e.texts(); };
}
KeySetter to(std::optional<double>& number) {
  return [&number](const StudyEntry& e) { number = e.number(-1e12, 1e12); };
}

std::vector<StudyItem> sort_study_items(const SceneSource& source) {
  std::vector<StudyItem> items;
  for (const SourceTable& table : source.tables) items.push_back({find_line(table.where), &table, nullptr});
  for (const SourceEntry& entry : source.entries) items.push_back({find_line(entry.where), nullptr, &entry});
  std::stable_sort(items.begin(), items.end(),
                   [](const StudyItem& a, const StudyItem& b) { return a.line < b.line; });
  return items;
}

}  // namespace hydroscope
