// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/results/result_folder.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <regex>

#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

namespace fs = std::filesystem;

/// Every file that a run, or drawing it again, writes: relative to its folder.
const std::regex& known_files() {
  // Files under way have a dot before and ".part" after their name.
  static const std::regex pattern(
      R"((branches/\d+/)?(\.?(summary\.json|history\.csv|events\.csv|model\.json|scene\.toml|overrides\.txt))"
      R"(|\.?states\.pvd)"
      R"(|\.?(journal\.jsonl|branch\.json))"
      R"(|states/\.?\d{5,}\.vtp|tools/\.?[A-Za-z0-9_-]+\.(vtp|txt))"
      R"(|frames/[a-z-]+(-\d+)?/\.?\d{5,}\.(png|json)|frames/\.?[a-z-]+(-\d+)?\.(webp|mp4))"
      R"(|check/\.?(index\.html|junit\.xml)|check/[a-z-]+/\.?\d{5,}-(expected|got|difference)\.png)(\.part)?)");
  return pattern;
}

std::vector<fs::path> find_known_files(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    if (entry.is_regular_file() && std::regex_match(name, known_files())) found.push_back(entry.path());
  }
  return found;
}

void remove_earlier_run(const ResultFolder& folder) {
  fs::remove(folder.summary());
  for (const fs::path& file : find_known_files(folder.path)) fs::remove(file);
}

/// A file that comes and goes tells more than permission bits (root, read-only mounts).
void check_writable(const fs::path& folder) {
  const fs::path trial = folder / ".hydroscope-write-test";
  try {
    write_whole_file(trial, "");
  } catch (const EnvironmentError& error) {
    throw InputError("-o " + folder.string() + ": " + error.what());
  }
  fs::remove(trial);
}

}  // namespace

std::string ResultFolder::state_name(int number) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "states/%05d.vtp", number);
  return name.data();
}

void check_result_folder(const fs::path& path, bool force) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return;
  const std::string start = "-o " + path.string() + ": ";
  if (!fs::is_directory(status)) throw InputError(start + "is a file; name a folder for the results");
  const bool is_empty = fs::is_empty(path, error);
  if (error) throw InputError(start + "cannot be read: " + error.message());
  if (is_empty || force) return;
  const bool is_run = fs::exists(path / "history.csv", error);
  const bool is_finished = fs::exists(path / "summary.json", error);
  throw InputError(start + "exists and " +
                   (!is_run       ? "is not empty"
                    : is_finished ? "holds the results of a run"
                                  : "holds what a run left that did not finish") +
                   "; --force replaces earlier results, or choose another folder");
}

ResultFolder make_result_folder(const fs::path& path, bool force) {
  check_result_folder(path, force);
  ResultFolder folder{path};
  try {
    fs::create_directories(path);
    check_writable(path);
    if (force) remove_earlier_run(folder);
    fs::create_directories(folder.states());
  } catch (const fs::filesystem_error& error) {
    throw InputError("-o " + path.string() + ": cannot be written: " + error.code().message());
  }
  return folder;
}

void remove_frames(const ResultFolder& folder, const std::vector<std::string>& views) {
  try {
    if (!fs::exists(folder.frames())) return;
    for (const fs::path& file : find_known_files(folder.path)) {
      const std::string name = file.lexically_relative(folder.frames()).generic_string();
      const std::string view = name.substr(0, name.find_first_of("/."));
      if (!name.starts_with("..") && std::find(views.begin(), views.end(), view) != views.end())
        fs::remove(file);
    }
  } catch (const fs::filesystem_error& error) {
    throw EnvironmentError(folder.frames().string() + ": cannot be written: " + error.code().message());
  }
}

std::vector<fs::path> find_states(const ResultFolder& folder) {
  std::vector<fs::path> states;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder.states(), error)) {
    if (entry.path().extension() == ".vtp") states.push_back(entry.path());
  }
  if (error || states.empty())
    throw InputError(folder.path.string() + ": no saved states here (states/NNNNN.vtp)");
  std::sort(states.begin(), states.end());
  return states;
}

}  // namespace hydroscope
