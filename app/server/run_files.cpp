// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/run_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

std::vector<std::string> split(const std::string& name) {
  std::vector<std::string> parts(1);
  for (const char c : name) {
    if (c == '/')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

bool is_plain(const std::string& part) {
  if (part.empty() || part.front() == '.') return false;
  return std::none_of(part.begin(), part.end(),
                      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\\' || c == 0x7F; });
}

[[noreturn]] void refuse(const std::string& name) {
  throw InputError("there is no file '" + name.substr(0, 200) + "' in the run folder");
}

bool is_file(int descriptor) {
  struct stat facts {};
  return fstat(descriptor, &facts) == 0 && S_ISREG(facts.st_mode);
}

}  // namespace

OpenFile::~OpenFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::uint64_t OpenFile::size() const {
  struct stat facts {};
  return fstat(descriptor_, &facts) == 0 ? static_cast<std::uint64_t>(facts.st_size) : 0;
}

std::string OpenFile::read(std::uint64_t offset, std::size_t most) const {
  std::string bytes(most, '\0');
  ssize_t done = 0;
  do {
    done = pread(descriptor_, bytes.data(), most, static_cast<off_t>(offset));
  } while (done < 0 && errno == EINTR);
  if (done < 0)
    throw EnvironmentError(std::string("a file of the run cannot be read: ") + std::strerror(errno));
  bytes.resize(static_cast<std::size_t>(done));
  return bytes;
}

OpenFile open_run_file(const std::filesystem::path& folder, const std::string& name) {
  const std::vector<std::string> parts = split(name);
  if (!std::all_of(parts.begin(), parts.end(), is_plain)) refuse(name);
  int parent = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  for (std::size_t i = 0; i < parts.size() && parent >= 0; ++i) {
    const bool is_last = i + 1 == parts.size();
    const int kind = is_last ? O_NONBLOCK : O_DIRECTORY;
    const int next = openat(parent, parts[i].c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC | kind);
    close(parent);
    parent = next;
  }
  if (parent < 0) refuse(name);
  OpenFile file(parent);
  if (!is_file(parent)) refuse(name);
  return file;
}

std::vector<RunFile> list_run_files(const std::filesystem::path& folder, std::size_t most) {
  namespace fs = std::filesystem;
  std::vector<RunFile> files;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end;
  while (!error && at != end && files.size() < most) {
    const bool is_hidden = at->path().filename().string().front() == '.';
    const bool is_link = at->is_symlink(error);
    if (is_hidden || is_link) at.disable_recursion_pending();
    if (!is_hidden && !is_link && at->is_regular_file(error)) {
      const std::uintmax_t size = at->file_size(error);
      if (!error) files.push_back({at->path().lexically_relative(folder).generic_string(), size});
    }
    at.increment(error);
  }
  std::sort(files.begin(), files.end(), [](const RunFile& a, const RunFile& b) { return a.name < b.name; });
  return files;
}

std::string find_media_type(const std::string& name) {
  static const std::array<std::pair<const char*, const char*>, 8> types = {
      {{".csv", "text/csv; charset=utf-8"},
       {".json", "application/json"},
       {".jsonl", "application/jsonl"},
       {".toml", "text/plain; charset=utf-8"},
       {".txt", "text/plain; charset=utf-8"},
       {".png", "image/png"},
       {".webp", "image/webp"},
       {".mp4", "video/mp4"}}};
  const std::string ending = std::filesystem::path(name).extension().string();
  for (const auto& [known, type] : types)
    if (ending == known) return type;
  return "application/octet-stream";
}

}  // namespace hydroscope
