// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/chart/study_entry.h"

namespace hydroscope {

using StudyPath = std::vector<std::string>;
using KeySetter = std::function<void(const StudyEntry&)>;
using KeySetters = std::map<std::string, KeySetter>;

/// Gives the entry to the setter of its key; an unknown key is an InputError.
void set_study_key(const SourceEntry& entry, const std::string& table, const KeySetters& setters);

KeySetter to(std::string& text);
KeySetter to(bool& flag);
KeySetter to(std::vector<double>& numbers);
KeySetter to(std::vector<std::string>& texts);
KeySetter to(std::optional<double>& number);

/// The scene key that the path names from its part `first` on.
SceneOverride make_scene_override(const SourceEntry& entry, std::size_t first);

/// One table header or one `key = value`.
struct StudyItem {
  int line = 0;
  const SourceTable* table = nullptr;
  const SourceEntry* entry = nullptr;
  const StudyPath& path() const { return table != nullptr ? table->path : entry->path; }
  const std::string& where() const { return table != nullptr ? table->where : entry->where; }
};

/// All of them in the order of the file.
std::vector<StudyItem> sort_study_items(const SceneSource& source);

/// The item of this name, made when it is not there.
template <class Named>
Named& find_or_add(std::vector<Named>& items, const std::string& name, const std::string& where) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Named& item) { return item.name == name; });
  if (found != items.end()) return *found;
  items.emplace_back();
  items.back().name = name;
  items.back().where = where;
  return items.back();
}

}  // namespace hydroscope
