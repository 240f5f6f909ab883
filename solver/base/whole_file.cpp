// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/base/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw EnvironmentError(path.string() + ": cannot be written: " + std::generic_category().message(error));
}

/// Returns 0, or the error that stopped it.
int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    if (written == 0) return ENOSPC;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return 0;
}

}  // namespace

void write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
  const std::string temporary = (path.parent_path() / ("." + path.filename().string() + ".part")).string();
  const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(path, errno);
  int error = write_all(descriptor, bytes);
  // A power cut after the rename must not leave an empty file under the final name.
  if (error == 0 && ::fsync(descriptor) != 0) error = errno;
  if (::close(descriptor) != 0 && error == 0) error = errno;
  if (error == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    fail(path, error);
  }
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (code) throw EnvironmentError("cannot make the folder " + folder.string() + ": " + code.message());
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fail(folder, errno);
}

std::string read_whole_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error) throw InputError(path.string() + ": cannot be read: " + error.message());
  std::ifstream file(path, std::ios::binary);
  std::string bytes(size, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!file) throw InputError(path.string() + ": cannot be read");
  return bytes;
}

LineFile::LineFile(const std::filesystem::path& path) : path_(path) {
  descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail(path_, errno);
}

LineFile::~LineFile() { ::close(descriptor_); }

void LineFile::append(std::string_view lines) {
  const int error = write_all(descriptor_, lines);
  if (error == 0) {
    size_ += static_cast<std::int64_t>(lines.size());
    return;
  }
  // Part of a line may have gone out before the disk was full.
  if (::ftruncate(descriptor_, size_) == 0) ::lseek(descriptor_, size_, SEEK_SET);
  fail(path_, error);
}

}  // namespace hydroscope
