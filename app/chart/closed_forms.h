// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.h"

namespace hydroscope {

/// Names of the closed forms that a study may compare with; docs/charts.md lists them.
const std::vector<std::string>& closed_form_names();
/// Value at `driver` (rho, radius or pressure, as the form wants it); geometry and material
/// come from the scene. Throws InputError when the scene has no tube, or no Swift law where one is needed.
double calc_closed_form(const std::string& name, const Scene& scene, double driver);

/// Closed forms of the wall's thickness around the section, corner filling in a square die.
const std::vector<std::string>& profile_form_names();
/// Thickness [mm] where the wall stands `angle` [rad] from the middle of a flat (0..pi/4), the corner's
/// mid radius being `rho` [mm].
double calc_profile_form(const std::string& name, const Scene& scene, double angle, double rho);

}  // namespace hydroscope
