// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "solver/scene/scene.h"
#include "solver/session/mesh_facts.h"

namespace hydroscope {

/// What was measured on the shipped scenes (docs/accuracy.md), as rules.

/// Smallest radius that the mid-surface will have [mm], and what makes it so.
struct LeastRadius {
  double value = 0.0;
  std::string cause;
  bool is_filled = false;  ///< pressure suffices to lay the wall into the tool's fillet
};
/// Of the tools, but no smaller than fluid and tension of the wall make it (rho = N / p).
LeastRadius find_least_radius(const Scene& scene, const std::map<std::string, MeshFacts>& facts);

/// Thickness of the sheet [mm].
double find_thickness(const Scene& scene);

/// Whether moments or bent radii are asked for.
bool asks_for_bending(const Scene& scene);

/// Element over least radius, for the most demanding quantity of the scene.
double find_element_ratio(const Scene& scene, bool is_filled);

/// Whether contact forces or pressures are asked for.
bool asks_for_contact(const Scene& scene);

/// Elements along a tube whose ends are held or clamped, over half of it, graded towards the end.
int count_graded_rows(double accuracy, double half_length, double radius, double thickness);

/// [increment]: tolerance, largest, max_strain.
struct IncrementRule {
  double tolerance = 0.0, largest = 0.0, max_strain = 0.0;
};
IncrementRule find_increment_rule(const Scene& scene);

struct ThicknessChoice {
  int points = 0;
  std::string rule, reason;
};
ThicknessChoice find_thickness_points(const Scene& scene);

}  // namespace hydroscope
