// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/model.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// Scene -> Model: meshes, supports, tools as placed, quantities resolved to
/// nodes. Throws InputError for whatever cannot be analysed (tool on the wrong
/// side, initial penetration, quantities outside the mesh, ...).
Model build_model(const Scene& scene);

/// What pictures and files need to know about the model.
SnapshotModel make_snapshot_model(const Model& model);

}  // namespace hydroscope
