// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "solver/base/types.h"

namespace hydroscope {

/// Content of a binary STL file; `title` goes into its header.
std::string make_binary_stl(const TriangleMesh& mesh, const std::string& title);

/// Content of a text STL file.
std::string make_text_stl(const TriangleMesh& mesh, const std::string& title);

/// Writes `content` to `path` under a temporary name, then renames. Throws EnvironmentError.
void write_file(const std::string& path, const std::string& content);

}  // namespace hydroscope
