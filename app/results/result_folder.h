// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace hydroscope {

/// Where the parts of a run lie in its folder.
struct ResultFolder {
  std::filesystem::path path;

  std::filesystem::path summary() const { return path / "summary.json"; }
  std::filesystem::path history() const { return path / "history.csv"; }
  std::filesystem::path events() const { return path / "events.csv"; }
  std::filesystem::path scene() const { return path / "scene.toml"; }
  std::filesystem::path overrides() const { return path / "overrides.txt"; }
  std::filesystem::path state_index() const { return path / "states.pvd"; }
  std::filesystem::path states() const { return path / "states"; }
  std::filesystem::path frames() const { return path / "frames"; }
  /// "states/00012.vtp", as in the index.
  static std::string state_name(int number);
};

/// Throws InputError when results may not go to `path`: it is a file, or a folder
/// that is not empty and `force` is false.
void check_result_folder(const std::filesystem::path& path, bool force);

/// Makes the folder and its subfolders. With `force` what an earlier run left is
/// removed first, its summary before all else; files that no run writes stay.
/// Throws InputError when the folder cannot be made or written.
ResultFolder make_result_folder(const std::filesystem::path& path, bool force);

/// Removes earlier frames and films of these views; foreign files stay. Throws EnvironmentError.
void remove_frames(const ResultFolder& folder, const std::vector<std::string>& views);

/// The saved states in order of time. Throws InputError when there are none.
std::vector<std::filesystem::path> find_states(const ResultFolder& folder);

}  // namespace hydroscope
