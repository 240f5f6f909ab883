// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/verification/friction_wall.h"

namespace hydroscope::verification {

/// A run of the thin wall in the square die with friction (V10) beside FrictionWall.
struct FrictionCase {
  std::string name;  ///< of the material
  Metal metal;
  double friction;
  double last_rho;                         ///< where the run ends [mm]
  int elements = 72;                       ///< over the eighth
  std::vector<std::string> settings = {};  ///< keys of the scene, replaced
};

/// Material "M1" or "M2" with the settings used here: M2 as the scene is shipped, by pressure, down to 9 mm.
/// M1's tension hardly rises with its strain, so that a little pressure moves it far: by volume, with 60
/// passes of the corrector allowed, down to just before the neck.
FrictionCase make_friction_case(const std::string& material, double friction, int elements);

struct FrictionResultRow {
  double rho = 0.0;                                ///< [mm]
  double pressure = 0.0, wanted_pressure = 0.0;    ///< [MPa]
  double thickness = 0.0, wanted_thickness = 0.0;  ///< at the corner's 45 degree point [mm]
};

struct FrictionComparison {
  std::vector<FrictionResultRow> rows;
  double neck_rho = 0.0;        ///< radius at which FrictionWall can carry no more force, if above 9 mm
  double end_rho = 0.0;         ///< where the run stood at its end [mm]
  double profile_error = 0.0;   ///< largest relative error in thickness along the wall at the end
  double profile_place = 0.0;   ///< where, in mm from the middle of the flat
  double sticking_share = 0.0;  ///< of the wall's touching nodes at the end
  int increments = 0;
  double seconds = 0.0;
  std::string message;  ///< empty when the run was completed
};

/// Runs `wanted` down to its last radius and compares at `radii` [mm] and along the wall at the end.
FrictionComparison compare_friction(const FrictionCase& wanted, const std::vector<double>& radii);

}  // namespace hydroscope::verification
