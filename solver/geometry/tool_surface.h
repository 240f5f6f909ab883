// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

/// Where a point meets a tool surface, in the tool's own frame.
struct FootPoint {
  double gap = 0.0;             ///< signed distance along `normal` [mm]; > 0 on the free side
  Vec3 point = Vec3::Zero();    ///< foot point on the tool surface [mm]
  Vec3 normal = Vec3::UnitZ();  ///< unit, from the tool into free space; continuous
  /// Change of `normal` with the position of the point that projects here,
  /// dn/dx [1/mm]; (4.29)-(4.44) with the normalised interpolated normal:
  /// (1/|m|)(I - n n^T) dm/dx. Its rows are tangential (n^T dn/dx = 0); +1/R on a convex,
  /// -1/R on a concave surface.
  Mat3 normal_gradient = Mat3::Zero();
  /// dg/dx of the returned gap, exactly: `normal` on smooth surfaces; on a mesh at gap 0 the facet's
  /// normal over its cosine with `normal` (so that normal . dg/dx = 1).
  Vec3 gap_gradient = Vec3::UnitZ();
  int facet = -1;            ///< facet of a mesh, patch of an analytic surface
  double beyond_edge = 0.0;  ///< how far the point lies beyond an open edge of the tool [mm]; 0 inside
};

/// Carried by a node from one look-up to the next, so that a sliding node is
/// followed through neighbours and a far node is skipped.
struct SearchHint {
  int facet = -1;                ///< facet of the last look-up
  Vec3 position = Vec3::Zero();  ///< where the last full look-up was made [mm]
  double clearance = 0.0;        ///< no surface within this distance of `position` [mm]
};

/// A rigid tool surface in its own frame. Immutable and safe for concurrent use.
class ToolSurface {
 public:
  virtual ~ToolSurface() = default;

  /// The foot point of `x` [mm], or nothing when no surface lies within
  /// `band` [mm] on the free side or `depth` [mm] behind it.
  /// Every point within the local focal distance has exactly one foot point: no dead zones.
  virtual std::optional<FootPoint> find_foot_point(const Vec3& x, double band, double depth,
                                                   SearchHint& hint) const = 0;

  /// Triangles for pictures and files [mm] (analytic surfaces: fine facets).
  virtual const TriangleMesh& display_mesh() const = 0;
  /// One unit normal a node of `display_mesh()`, as used by contact.
  virtual const std::vector<Vec3>& display_normals() const = 0;

  /// Number of the connected part of each facet, from 0; empty: all is one.
  virtual std::vector<int> list_parts() const { return {}; }
};

}  // namespace hydroscope
