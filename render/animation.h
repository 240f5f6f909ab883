// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hydroscope {

/// Joins DIRECTORY/VIEW/00001.png ... of `frames` frames into DIRECTORY/VIEW.webp
/// or .mp4 (`kind`) and returns the file's name. MP4 needs the program ffmpeg.
/// Throws EnvironmentError.
std::string make_animation(const std::string& directory, const std::string& view, int frames,
                           const std::string& kind, double frames_per_second);

/// Throws InputError for an unknown kind or speed, EnvironmentError when ffmpeg is needed and missing.
void check_animation(const std::string& kind, double frames_per_second);

}  // namespace hydroscope
