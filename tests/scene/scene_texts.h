// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "solver/base/error.h"
#include "solver/scene/scene_reader.h"

namespace hydroscope::test {

/// A small valid scene; line numbers in the tests count from its first line.
inline const std::string kTube = R"(title = "Free expansion"
[tube]
radius_mm = 30
thickness_mm = 1.5
length_mm = 5.0
extent = "slice"
section = "octant"
elements_around = 8
[material]
youngs_modulus_MPa = 206e3
hardening = "swift"
swift_K_MPa = 550.0
swift_eps0 = 0.01
swift_n = 0.2
[load]
pressure_MPa = [[0.0, 0.0], [1.0, 17.0]]
[tool.die]
shape = "cylinder"
radius_mm = 32.0
friction = 0.05
[quantity.t_mm]
kind = "thickness"
angle_deg = 45
)";  // 23 lines

inline const std::string kStrip = R"([strip]
thickness_mm = 1.5
width_mm = 1.0
lead_in_mm = 20
elements_lead_in = 10
[material]
youngs_modulus_MPa = 206e3
[edge.start]
hold = ["x", "y", "rotation"]
[edge.end]
tension_N_per_mm = [[0, 0], [1, 100]]
[quantity.pull]
kind = "edge_force"
)";  // 13 lines

/// `text` with its line `number` (from 1) replaced.
inline std::string with_line(const std::string& text, int number, const std::string& line) {
  std::string out;
  int at = 1;
  for (size_t start = 0; start < text.size(); ++at) {
    const size_t end = text.find('\n', start);
    out += (at == number ? line : text.substr(start, end - start)) + "\n";
    start = end + 1;
  }
  return out;
}

/// The message of the InputError that reading `text` must cause.
inline std::string error_of(const std::string& text, const std::vector<std::string>& sets = {}) {
  std::vector<SceneOverride> overrides;
  try {
    for (const std::string& set : sets) overrides.push_back(make_override(set));
    parse_scene(text, "a.toml", overrides);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

inline Scene read(const std::string& text, const std::vector<std::string>& sets = {}) {
  std::vector<SceneOverride> overrides;
  for (const std::string& set : sets) overrides.push_back(make_override(set));
  return parse_scene(text, "a.toml", overrides);
}

}  // namespace hydroscope::test
