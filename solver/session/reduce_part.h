// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "solver/scene/scene.h"
#include "solver/session/part_symmetry.h"

namespace hydroscope {

/// Opening of the modelled section [deg].
double find_section_angle(const TubeScene& tube);

/// The smallest part of a tube that stands for all of it: section and extent become what the symmetry
/// allows, quantities are folded into it, and counts of elements, where given, fall with it. A section whose
/// `grading_around` the user gave stays as it is, and so does the extent with `grading_along`. Adds to
/// `scene.choices` what was done, or what stands against it.
void reduce_part(const PartSymmetry& symmetry, double sector_angle, Scene& scene);

}  // namespace hydroscope
