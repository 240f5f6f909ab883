// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>  // VTK::CommonCore

#include "render/shape/surface.h"
#include "solver/snapshot/snapshot.h"

class vtkPolyData;

namespace hydroscope {

/// Polygons with point normals and, as active point scalars, `value` (float) or
/// `colour` (RGB): point data throughout, as some renderers drop cell colours.
/// `polygons` are those of the surface that are wanted.
vtkSmartPointer<vtkPolyData> make_poly_data(const Surface& surface,
                                            const std::vector<std::array<int, 4>>& polygons);
vtkSmartPointer<vtkPolyData> make_poly_data(const LineSet& lines);

/// The mid-surface with every nodal array under the names of the state files
/// (`thickness_mm`, `contact_state`, `slip_mm`, `node_id`, ...), on request
/// mirrored to the whole part; forces, normals and slips turn with the mirrors.
vtkSmartPointer<vtkPolyData> make_poly_data(const Snapshot& snapshot, bool is_mirrored);

}  // namespace hydroscope
