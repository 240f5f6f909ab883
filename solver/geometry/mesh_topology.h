// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// Who borders on whom in a triangle mesh. Edge k of a facet lies opposite to
/// its corner k: from corner (k + 1) % 3 to corner (k + 2) % 3.
struct MeshTopology {
  static constexpr int kOpen = -1;         ///< no neighbour
  static constexpr int kNonManifold = -2;  ///< three or more facets share the edge
  struct Side {
    int facet = kOpen;        ///< neighbour, or kOpen, or kNonManifold
    int edge = -1;            ///< the neighbour's number for the same edge
    bool is_flipped = false;  ///< both facets run along the edge the same way
  };
  std::vector<std::array<Side, 3>> sides;  ///< one triple a facet
  std::vector<int> ring_start;  ///< facets around point p: ring[ring_start[p] .. ring_start[p + 1])
  std::vector<int> ring;        ///< ascending for each point
  int open_edges = 0, non_manifold_edges = 0, flipped_edges = 0;
};

MeshTopology make_topology(const TriangleMesh& mesh);

/// Unit normal of each facet (4.1); zero for a facet without area.
std::vector<Vec3> calc_facet_normals(const TriangleMesh& mesh);

/// Turns facets so that neighbours run along shared edges in opposite ways. In each
/// connected part the orientation that covers more area wins. Returns the number of facets turned;
/// parts that cannot be oriented (a Moebius strip) keep flipped edges.
int orient_consistently(TriangleMesh& mesh);

/// Number of each facet's connected part (across edges of two facets), from 0.
std::vector<int> find_parts(const MeshTopology& topology);

}  // namespace hydroscope
