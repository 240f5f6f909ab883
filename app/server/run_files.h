// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace hydroscope {

/// A file of the run folder that is open for reading.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  OpenFile(OpenFile&& other) noexcept : descriptor_(other.descriptor_) { other.descriptor_ = -1; }
  OpenFile& operator=(OpenFile&&) = delete;

  std::uint64_t size() const;
  /// Bytes from `offset` on, at most `most`; fewer at the end of the file. Throws EnvironmentError.
  std::string read(std::uint64_t offset, std::size_t most) const;

 private:
  int descriptor_;
};

/// Opens `name` ("states/00001.vtp") below `folder`. No component may be `.` or `..` or begin with a dot, and
/// no link is followed, whatever changes meanwhile on disk. Throws InputError for such names and for what is
/// no file.
OpenFile open_run_file(const std::filesystem::path& folder, const std::string& name);

struct RunFile {
  std::string name;  ///< below the folder, parts separated by `/`
  std::uint64_t size = 0;
};

/// Files below `folder` that open_run_file() opens, sorted by name; at most `most` of them.
std::vector<RunFile> list_run_files(const std::filesystem::path& folder, std::size_t most);

/// "text/csv" for NAME.csv ...; what a browser might run is none of them.
std::string find_media_type(const std::string& name);

}  // namespace hydroscope
