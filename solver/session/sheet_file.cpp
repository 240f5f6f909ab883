// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/sheet_file.h"

#include "solver/base/error.h"

namespace hydroscope {

SheetMesh read_sheet_mesh(const Scene& scene) {
  throw InputError(scene.file + ": mesh.file: reading of meshes is not built in");
}

}  // namespace hydroscope
