// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hydroscope {

/// DIRECTORY/VIEW/00001 for frame 1, without ending.
std::string make_frame_name(const std::string& directory, const std::string& view, int number);

/// Makes DIRECTORY/VIEW. Frames and animations in the way are an InputError, or
/// are deleted with `replace`. Throws EnvironmentError when it cannot be written.
void make_view_folder(const std::string& directory, const std::string& view, bool replace);

}  // namespace hydroscope
