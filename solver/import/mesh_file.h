// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace hydroscope {

/// A mesh file in memory that has passed a check of its own: complete, in a known format, with
/// facets and finite coordinates. Mesh readers are lenient or fragile with broken files;
/// the user gets the reason instead.
struct MeshFile {
  std::string path;
  std::string content;
  std::string format;      ///< "stl", "obj" or "ply"
  std::size_t facets = 0;  ///< as announced by the file
};

/// Reads and checks the file; throws InputError naming it and what is wrong.
MeshFile read_mesh_file(const std::string& path);

/// The whole file; throws InputError when it is missing, empty, no file, or larger than 2 GB.
std::string read_mesh_content(const std::string& path);

/// InputError "FILE: what".
[[noreturn]] void refuse_mesh_file(const std::string& path, const std::string& what);

/// Checks a PLY file of which `content` holds everything; returns its number of facets.
std::size_t check_ply(const std::string& path, const std::string& content);

}  // namespace hydroscope
