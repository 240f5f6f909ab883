// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "solver/scene/scene_source.h"
#include "solver/scene/scene_table.h"

namespace hydroscope {

/// Puts `value` into `slot` after checking it against type, choices and range
/// of `key`. Returns an empty string, or what is wrong ("-1 is out of range; allowed: 0 to 10").
std::string assign_value(const SourceValue& value, const SceneKey& key, const SceneSlot& slot);

/// The type as the documentation and the messages name it: "a number [mm]".
std::string describe_type(const SceneKey& key, const SceneSlot& slot);

/// The value in a slot as one would write it in a scene; empty when there is none.
std::string format_slot(const SceneSlot& slot);

/// "0 to 10", "at least 0"; empty when every number is allowed.
std::string describe_range(const KeyRange& range);

/// As written in TOML, cut when long.
std::string format_value(const SourceValue& value);

}  // namespace hydroscope
