// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "app/command_line.h"
#include "app/results/result_folder.h"
#include "solver/scene/scene.h"
#include "solver/scene/scene_source.h"

namespace hydroscope {

/// --views, --frames, --size, --camera, --theme, --animation and --set as overrides of
/// scene keys, in the order that lets --set have the last word. Their values are
/// checked with all others when the scene is read, and kept with the results.
std::vector<SceneOverride> make_overrides(const Arguments& arguments);

/// How a run drew its frames, changed by what the command line says now. Throws InputError.
FramesScene read_frames_scene(const ResultFolder& folder, const Arguments& arguments);

/// "1280x720"; throws InputError naming `option`.
std::array<int, 2> parse_size(const std::string& option, const std::string& text);

}  // namespace hydroscope
