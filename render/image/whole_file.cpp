// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/whole_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& file, int code) {
  throw EnvironmentError("cannot " + what + " " + file + ": " + std::strerror(code));
}

}  // namespace

std::string temporary_name(const std::string& file) {
  const std::filesystem::path path(file);
  return path.parent_path() / (path.filename().string().insert(0, 1, '.') + ".part");
}

void rename_whole_file(const std::string& file) {
  if (std::rename(temporary_name(file).c_str(), file.c_str()) != 0) fail("write", file, errno);
}

void write_whole_file(const std::string& file, std::string_view content) {
  const std::string temporary = temporary_name(file);
  std::FILE* stream = std::fopen(temporary.c_str(), "wb");
  if (stream == nullptr) fail("write", file, errno);
  const bool is_written = std::fwrite(content.data(), 1, content.size(), stream) == content.size();
  const int write_error = errno;
  // A full disk may show only when the last buffer goes out.
  const bool is_closed = std::fclose(stream) == 0;
  if (!is_written || !is_closed) {
    const int code = is_written ? errno : write_error;
    std::remove(temporary.c_str());
    fail("write", file, code);
  }
  rename_whole_file(file);
}

void make_folder(const std::string& folder) {
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (code) throw EnvironmentError("cannot make the folder " + folder + ": " + code.message());
  if (access(folder.c_str(), W_OK | X_OK) != 0) fail("write into the folder", folder, errno);
}

}  // namespace hydroscope
