// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.h"
#include "solver/scene/scene_source.h"

namespace hydroscope {

/// Reads and checks a scene file. Every fault throws InputError with place, key,
/// value and what is allowed; the first one in the order of the file.
/// `overrides` replace keys of the file, in the order given. A key of the file that
/// no longer counts because an override chose another kind is passed over.
Scene read_scene(const std::string& file, const std::vector<SceneOverride>& overrides = {});

/// The same from text. `file` names it in messages, and its folder is the scene's.
/// With `require_files` false the files that the scene names need not be there.
Scene parse_scene(const std::string& text, const std::string& file,
                  const std::vector<SceneOverride>& overrides = {}, bool require_files = false);

}  // namespace hydroscope
