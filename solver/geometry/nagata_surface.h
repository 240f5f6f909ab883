// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "solver/geometry/facet_search.h"
#include "solver/geometry/mesh_topology.h"
#include "solver/geometry/nagata_patch.h"
#include "solver/geometry/tool_surface.h"
#include "solver/geometry/vertex_normals.h"

namespace hydroscope {

struct NagataSurfaceOptions {
  NormalRule normals = NormalRule::area;  ///< of the nodes; not `facet` (ContractError)
  double crease_angle = 40.0;             ///< [deg]; sharper edges stay edges
  SearchRule search = SearchRule::tree;
};

/// A tool surface of quadratic patches over the facets of a mesh (Nagata 2005, mechanics 6.2). Foot point,
/// normal and curvature are those of the patches: the foot is the nearest point, the gap its distance, dg/dx
/// the normal, dn/dx symmetric.
///
/// Patches meet along common curves, with normals that differ a little there. Where no patch leads to a
/// point, the nearest edge or corner does, and its normal swings from one side to the other: there is always
/// a foot point, and the gap is continuous. The answer is a function of the point alone; a hint makes it
/// cheaper.
class NagataSurface final : public ToolSurface {
 public:
  /// Facets must have an area (ContractError) and should be oriented alike.
  explicit NagataSurface(const TriangleMesh& mesh, const NagataSurfaceOptions& options = {});

  std::optional<FootPoint> find_foot_point(const Vec3& x, double band, double depth,
                                           SearchHint& hint) const override;
  /// The flat facets; points on creases are repeated, one for each of their normals.
  const TriangleMesh& display_mesh() const override { return display_mesh_; }
  const std::vector<Vec3>& display_normals() const override { return normals_; }
  std::vector<int> list_parts() const override { return find_parts(topology_); }

  int crease_edges() const { return crease_edges_; }
  /// The point of a facet's patch at l1, l2 (of its corners 0 and 1), with its derivatives.
  PatchPlace place_on_patch(int facet, double l1, double l2) const {
    return {patches_[static_cast<std::size_t>(facet)], l1, l2};
  }

 private:
  enum class Link : unsigned char { smooth, crease, rim };

  void link_facets(const CornerNormals& corners);
  void bend_patches();
  FootPoint locate(const Vec3& x, int nearest, double distance) const;
  FootPoint make_inner_foot(const Vec3& x, int facet, const PatchFoot& at) const;
  FootPoint make_edge_foot(const Vec3& x, int facet, const PatchFoot& at) const;
  FootPoint make_rim_foot(const Vec3& x, int facet, int k, double s) const;
  FootPoint make_corner_foot(const Vec3& x, int facet, int corner) const;
  const Vec3& corner_normal(int facet, int k) const;

  MeshTopology topology_;
  TriangleMesh display_mesh_;
  std::vector<Vec3> normals_;
  std::vector<NagataPatch> patches_;
  std::vector<double> rise_;                // of each patch over its facet [mm]
  std::vector<std::array<Link, 3>> links_;  // kind of edge k
  std::vector<std::array<int, 3>> points_;  // as given, before points on creases were repeated
  std::unique_ptr<const FacetSearch> search_;
  int crease_edges_ = 0;
  double largest_rise_ = 0.0;  // [mm]
  double floor_ = 0.0;         // radius given to a crease in curvatures [mm]
};

}  // namespace hydroscope
