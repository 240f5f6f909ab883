// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// The facets of `mesh` that a model between symmetry planes can meet: all but those that lie
/// wholly behind one of the `planes` (normals point into the model) by more than `margin` [mm].
/// Facets are kept whole, so that nodes on the planes find neighbours beyond them.
TriangleMesh clip_to_half_spaces(const TriangleMesh& mesh, const std::vector<Plane>& planes, double margin);

}  // namespace hydroscope
