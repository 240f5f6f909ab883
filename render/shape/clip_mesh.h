// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// Cuts away what lies on the positive side of the plane. Facets across it are
/// split; points on the cut get the interpolated normal. Points nearer to the plane than
/// `tolerance` [mm] count as on it.
void clip_mesh(TriangleMesh& mesh, std::vector<Vec3>& normals, const Plane& plane, double tolerance);

}  // namespace hydroscope
