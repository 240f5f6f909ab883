// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// Measures of a tool mesh; nothing is judged here.
struct MeshStatistics {
  int points = 0, facets = 0, parts = 0;
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< bounding box [mm]
  double area = 0.0;                             ///< [mm^2]

  int open_edges = 0, non_manifold_edges = 0;
  int flipped_edges = 0;            ///< neighbours that face opposite ways
  std::vector<double> rim_lengths;  ///< closed chains of open edges, longest first [mm]
  int t_joints = 0;                 ///< rim points that lie on a facet they are no corner of

  double smallest_edge = 0.0, mean_edge = 0.0, largest_edge = 0.0;  ///< [mm]
  int slivers = 0;            ///< facets more than 50 times as long as high
  double worst_aspect = 0.0;  ///< length over height

  int creases = 0;                                           ///< edges sharper than the limit
  double sharpest_crease = 0.0;                              ///< [deg]; 0 without creases
  double largest_facet_angle = 0.0, mean_facet_angle = 0.0;  ///< [deg]; bent edges below the limit
  double smallest_radius = 0.0;  ///< [mm], of the tightest bend below the limit; 0: all is flat
};

/// `crease_angle` [deg].
MeshStatistics measure_mesh(const TriangleMesh& mesh, double crease_angle);

}  // namespace hydroscope
