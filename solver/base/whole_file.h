// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace hydroscope {

/// Writes `bytes` under a temporary name (`.NAME.part`) beside `path`, then renames: whoever looks
/// sees the old file or the whole new one. Throws EnvironmentError; the old file stays.
void write_whole_file(const std::filesystem::path& path, std::string_view bytes);

/// Makes a folder and those above it, and checks that it can be written. Throws EnvironmentError.
void make_folder(const std::filesystem::path& folder);

/// Throws InputError when the file is missing or cannot be read.
std::string read_whole_file(const std::filesystem::path& path);

/// A file that grows line by line; each append is on its way to disk when it returns.
class LineFile {
 public:
  /// Starts the file anew. Throws EnvironmentError.
  explicit LineFile(const std::filesystem::path& path);
  ~LineFile();
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  /// Adds `lines` (each ended by a newline), all of them or none.
  /// Throws EnvironmentError; the file then ends with its last whole line.
  void append(std::string_view lines);

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;
};

}  // namespace hydroscope
