// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/geometry/sheet_mesh.h"

namespace hydroscope {

/// Reads the quadrilaterals of a VTU file ([mesh].file; text, or base64 without
/// compression) as a sheet. Directors are averaged from the quads' normals.
/// Throws InputError naming the file and what is wrong.
SheetMesh read_sheet_mesh(const Scene& scene);

}  // namespace hydroscope
