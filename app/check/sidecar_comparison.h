// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/results/json.h"

namespace hydroscope {

/// Where two sidecars of a frame differ: "counts.stick: 41 instead of 42". Words and counts
/// are compared exactly; quantities may differ by 1e-6 of themselves (vectors: of their greatest
/// component) and 1e-8 of the model's size in their unit, angles by 1e-4 degrees, as the
/// facets' angles follow from small differences of coordinates. What describes the machine
/// (renderer, font, lettering, version of the program) is not compared.
std::vector<std::string> compare_sidecars(const Json& expected, const Json& got);

}  // namespace hydroscope
