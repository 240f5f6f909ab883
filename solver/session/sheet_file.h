// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/geometry/sheet_mesh.h"

namespace hydroscope {

/// A sheet from the quadrilaterals of a VTU file ([mesh].file). Directors are
/// averaged from the quads' normals and turned away from the z axis. Border nodes
/// on x = 0, y = 0 or z = 0 with the mesh on one side lie on symmetry planes; those at the
/// lowest and highest z are the ends. Throws InputError naming the file and what is wrong.
SheetMesh read_sheet_mesh(const Scene& scene);

}  // namespace hydroscope
