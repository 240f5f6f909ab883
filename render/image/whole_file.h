// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace hydroscope {

/// Writes `content` under a temporary name in the same folder and renames it,
/// so that a file of that name is whole or absent. Throws EnvironmentError.
void write_whole_file(const std::string& file, std::string_view content);

/// The temporary name that goes with `file`.
std::string temporary_name(const std::string& file);

/// Renames temporary_name(file) to `file`. Throws EnvironmentError.
void rename_whole_file(const std::string& file);

/// Makes a folder and those above it, and checks that it can be written. Throws EnvironmentError.
void make_folder(const std::string& folder);

}  // namespace hydroscope
