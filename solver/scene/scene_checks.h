// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>

#include "solver/scene/scene.h"

namespace hydroscope {

/// What the user wrote, and where: full key or table path ("tool.die.friction") to
/// its place ("scene.toml:12" or "--set ...").
class GivenKeys {
 public:
  explicit GivenKeys(std::string file) : file_(std::move(file)) {}
  void add(const std::string& path, const std::string& where, bool is_override);

  bool has(const std::string& path) const { return places_.count(path) > 0; }
  bool is_override(const std::string& path) const;
  /// All paths, or those of overrides.
  std::set<std::string> list(bool only_overrides) const;
  /// The place of the key, else of the tables around it, else the file.
  std::string find_place(const std::string& path) const;
  const std::string& file() const { return file_; }

  /// Throws InputError "PLACE: key 'PATH': TEXT".
  [[noreturn]] void fail(const std::string& path, const std::string& text) const;
  /// Throws InputError "PLACE: TEXT", with the place of `path`.
  [[noreturn]] void fail_at(const std::string& path, const std::string& text) const;

 private:
  struct Place {
    std::string where;
    bool is_override = false;
  };
  std::string file_;
  std::map<std::string, Place> places_;
};

/// Rules that tie several keys together, and values that follow from others
/// (`outer_radius_mm` to the mid-surface). Throws InputError.
void check_scene(Scene& scene, const GivenKeys& given);

/// Every file that the scene names must be there. Throws InputError.
void check_scene_files(const Scene& scene, const GivenKeys& given);

}  // namespace hydroscope
