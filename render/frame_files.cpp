// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/frame_files.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

namespace fs = std::filesystem;

/// 00001.png and 00001.json: the only names that are ours in such a folder.
bool is_frame_file(const fs::path& path) {
  const std::string stem = path.stem().string();
  const bool is_numbered = stem.size() >= 5 && std::all_of(stem.begin(), stem.end(), [](unsigned char c) {
                             return std::isdigit(c) != 0;
                           });
  return is_numbered && (path.extension() == ".png" || path.extension() == ".json");
}

}  // namespace

std::string make_frame_name(const std::string& directory, const std::string& view, int number) {
  char digits[16];
  std::snprintf(digits, sizeof digits, "%05d", number);
  return directory + "/" + view + "/" + digits;
}

void make_view_folder(const std::string& directory, const std::string& view, bool replace) {
  const std::string folder = directory + "/" + view;
  make_folder(folder);
  std::vector<fs::path> old;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder, code))
    if (is_frame_file(entry.path())) old.push_back(entry.path());
  for (const char* ending : {".webp", ".mp4"})
    if (fs::exists(directory + "/" + view + ending, code)) old.emplace_back(directory + "/" + view + ending);
  if (!old.empty() && !replace)
    throw InputError(folder + " holds frames already (" + old.front().filename().string() + ")");
  for (const fs::path& path : old)
    if (!fs::remove(path, code) && code)
      throw EnvironmentError("cannot delete " + path.string() + ": " + code.message());
}

}  // namespace hydroscope
