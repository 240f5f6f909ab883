// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/geometry/sheet_mesh.h"
#include "solver/increment/model.h"

namespace hydroscope {

/// Turns the scene's [quantity.NAME] tables into nodes and weights of the mesh;
/// quantities that refer to others come after them. Throws InputError.
void resolve_quantities(const Scene& scene, const SheetMesh& sheet, Model& model);

}  // namespace hydroscope
