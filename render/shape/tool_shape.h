// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "render/shape/surface.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// The drawn form of one tool: what does not depend on where it has moved to.
class ToolShape {
 public:
  /// `mirrors`: of the part; those about which the tool is whole are left out, and
  /// what reaches over the others is cut off (see find_open_mirrors).
  /// Throws ContractError when normals are missing or an index is wrong.
  ToolShape(const SnapshotModel::Tool& tool, const std::vector<Plane>& mirrors);

  const std::vector<Reflection>& reflections() const { return reflections_; }

  /// Facets with one vertex a corner. `values` = angle between the facet's
  /// normal and the continuous normal at the corner [deg]. The light follows the
  /// continuous normal, but the facet's own beside edges sharper than `kCrease`.
  /// `set_back` [mm] moves the drawn facets into the tool, against their normals:
  /// else a sheet that lies on them would shine through in stripes.
  Surface make_surface(const Vec3& translation, double set_back = 0.0) const;

  /// Open edges and edges sharper than `kCrease`.
  LineSet make_edges(const Vec3& translation) const;

  /// All facet edges.
  LineSet make_facet_edges(const Vec3& translation) const;

  /// Where the plane cuts the facets.
  LineSet make_section(const Vec3& translation, const Plane& plane) const;

  /// Centre and unit normal of each facet, in the tool's frame (no reflections).
  const std::vector<Vec3>& facet_normals() const { return facet_normals_; }
  std::vector<Vec3> calc_facet_centres() const;
  double calc_facet_area(std::size_t facet) const;  ///< [mm^2]

  /// Largest angle between a facet normal and the continuous normal [deg].
  double largest_angle() const { return largest_angle_; }
  /// The same at each facet, over its corners [deg].
  std::vector<double> calc_facet_angles() const;

  const TriangleMesh& mesh() const { return mesh_; }
  const std::vector<Vec3>& normals() const { return normals_; }

  static constexpr double kCrease = 30.0;  ///< [deg]

 private:
  double corner_angle(std::size_t facet, std::size_t corner) const;
  void find_edges(const std::vector<Plane>& seams, double tolerance);

  TriangleMesh mesh_;
  std::vector<Vec3> normals_;
  std::vector<Vec3> facet_normals_;
  std::vector<std::array<int, 2>> edges_;        ///< all, once
  std::vector<std::array<int, 2>> sharp_edges_;  ///< open or sharp
  std::vector<Reflection> reflections_;
  double largest_angle_ = 0.0;
};

/// Angle between unit vectors [deg], exact also for small ones.
double calc_angle(const Vec3& a, const Vec3& b);

}  // namespace hydroscope
