// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "solver/base/types.h"

namespace hydroscope {

/// The quadrilaterals of a VTK unstructured grid file (.vtu): XML with data as
/// text or as base64 without compression. Other cells are refused. Throws
/// InputError naming the file and what is wrong.
QuadMesh read_vtu_quads(const std::string& file);

}  // namespace hydroscope
