// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hydroscope {

/// A scene that a study may name: a slice of tube that is blown, its three increments a matter of
/// milliseconds. `elements` over an octant.
inline std::string make_small_scene() {
  return R"(title = "small"
[tube]
radius_mm = 30.0
thickness_mm = 1.5
length_mm = 1.0
section = "octant"
extent = "slice"
elements_around = 4
[material]
youngs_modulus_MPa = 206e3
hardening = "swift"
swift_K_MPa = 550.0
swift_eps0 = 0.01
swift_n = 0.2
[load]
control = "volume"
volume_ratio = [[0.0, 1.0], [1.0, 1.1]]
[quantity.r_mm]
kind = "radius"
angle_deg = 22.5
[quantity.t_mm]
kind = "thickness"
angle_deg = 22.5
)";
}

/// A study of it: an axis of two meshes and an axis of two tolerances.
inline std::string make_small_study() {
  return R"(title = "Small study"
[run]
repeats = 1
[case.blow]
scene = "small.toml"
default = "8+fine"
[case.blow.axis.mesh]
label = "elements"
key = "tube.elements_around"
values = [4, 8]
size = "inverse"
[case.blow.axis.tolerance.point.coarse]
increment.tolerance = 0.01
[case.blow.axis.tolerance.point.fine]
[case.blow.quantity.pressure]
column = "pressure_MPa"
driver = "q.r_mm"
at = [30.6, 31.0]
reference = "formula"
formula = "expansion-ring-pressure"
)";
}

}  // namespace hydroscope
