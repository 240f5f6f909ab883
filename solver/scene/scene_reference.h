// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hydroscope {

/// The documentation of all scene keys, in Markdown: docs/scene_reference.md.
std::string make_scene_reference();

}  // namespace hydroscope
