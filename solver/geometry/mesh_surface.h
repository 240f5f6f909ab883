// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "solver/geometry/edge_foot.h"
#include "solver/geometry/facet_search.h"
#include "solver/geometry/mesh_topology.h"
#include "solver/geometry/prism.h"
#include "solver/geometry/tool_surface.h"
#include "solver/geometry/vertex_normals.h"

namespace hydroscope {

/// How a point is paired with a facet near it (the local search of method 7).
enum class Projection {
  prism,      ///< along the interpolated normal: one foot point for every point
  orthogonal  ///< along the facet's normal: none over convex edges, several over concave ones
};

/// "prism" or "orthogonal"; throws InputError otherwise.
Projection parse_projection(const std::string& name);

struct MeshSurfaceOptions {
  NormalRule normals = NormalRule::area;
  double crease_angle = 40.0;  ///< [deg]; normals are not averaged over sharper edges
  bool is_smooth = false;      ///< facets bent to fit their node normals, see bend_edges()
  SearchRule search = SearchRule::tree;
  Projection projection = Projection::prism;
  /// Facets that were split from one quadrilateral: they become bilinear (4.2), and are not bent.
  std::vector<std::array<int, 2>> quads = {};
};

/// A tool surface of triangles (flat, or bent to fit their normals) and bilinear quadrilaterals with
/// averaged node normals (method 2), searched through normal prisms (mechanics 7.2), so that no point
/// is lost. Orthogonal projection is there to show what is lost without them.
///
/// The answer for a point is a function of the point alone: the nearest facet, then a
/// walk to the prism that holds the point. A hint (the facet of the last look-up) makes
/// the search cheap, but does not change a bit of the result.
/// With `NormalRule::facet`: the closest point of the mesh with its facet's normal, which jumps.
class MeshSurface final : public ToolSurface {
 public:
  /// Facets must have an area (ContractError) and should be oriented alike.
  explicit MeshSurface(const TriangleMesh& mesh, const MeshSurfaceOptions& options = {});

  std::optional<FootPoint> find_foot_point(const Vec3& x, double band, double depth,
                                           SearchHint& hint) const override;
  /// Points on creases are repeated, one for each of their normals; facets keep their numbers.
  const TriangleMesh& display_mesh() const override { return display_mesh_; }
  const std::vector<Vec3>& display_normals() const override { return normals_; }
  std::vector<int> list_parts() const override { return find_parts(topology_); }

  int crease_edges() const { return crease_edges_; }
  const MeshTopology& topology() const { return topology_; }

  /// Quadrilaterals among the facets.
  int quad_count() const { return static_cast<int>(quads_.size()); }

  /// Facets on which the orthogonal projection of `x` lies, at most `reach` [mm] away; by trying all of them.
  std::vector<int> list_projections_at(const Vec3& x, double reach) const;
  /// Facets whose prism holds `x` with a height |g| <= `reach` [mm]; by trying all of them.
  std::vector<int> list_prisms_at(const Vec3& x, double reach) const;

 private:
  enum class Link : unsigned char { smooth, crease, rim, seam };  ///< seam: a rim that touches other facets

  void link_facets(const CornerNormals& corners);
  void mark_seams(const TriangleMesh& mesh);
  void bend_facets();
  void make_quads(const TriangleMesh& mesh, const QuadCover& cover, const CornerNormals& corners);
  /// Place of `x` in the prism of a facet, of half a quad in the quad's; and the foot point there.
  PrismPoint locate_in(int facet, const Vec3& x) const;
  FootPoint make_foot(int facet, const PrismPoint& at, const Vec3& x) const;
  bool is_half_quad(int facet) const {
    return !halves_.empty() && halves_[static_cast<std::size_t>(facet)].quad >= 0;
  }
  std::optional<FootPoint> find_orthogonal(const Vec3& x, double window) const;
  FootPoint locate(const Vec3& x, int nearest, double distance) const;
  FootPoint locate_facet_normal(const Vec3& x, int nearest) const;
  FootPoint locate_quad_normal(const Vec3& x, int nearest) const;
  FootPoint finish_in_prism(const Vec3& x, int facet, const PrismPoint& at) const;
  std::optional<FootPoint> find_rim(const Vec3& x, int facet, const PrismPoint& at) const;
  FootPoint follow_rim(const Vec3& x, int facet, int k) const;
  /// The rim edge (facet, edge) that follows (direction +1) or precedes (-1) another at their common point.
  std::array<int, 2> step_along_rim(int facet, int k, int direction) const;
  std::optional<FootPoint> find_any_prism(const Vec3& x, double radius) const;
  std::optional<FootPoint> find_any_crease(const Vec3& x, double radius) const;
  FootPoint find_any_end(const Vec3& x, int nearest, double distance, double radius) const;
  ToolEdge make_edge(int facet, int k) const;

  MeshTopology topology_;
  TriangleMesh display_mesh_;
  std::vector<Vec3> normals_;
  std::vector<Prism> prisms_;
  std::vector<QuadPrism> quads_;
  std::vector<QuadHalf> halves_;            // one a facet; empty without quads
  std::vector<std::array<int, 3>> next_;    // neighbour across edge k, -1 at a rim
  std::vector<std::array<Link, 3>> links_;  // kind of edge k
  std::vector<std::array<int, 3>> points_;  // as given, before points on creases were repeated
  std::vector<char> is_tip_;                // points on creases
  std::unique_ptr<const FacetSearch> search_;
  bool keeps_facet_normals_ = false;
  Projection projection_ = Projection::prism;
  int crease_edges_ = 0;
  double size_ = 0.0;   // diagonal of the bounding box [mm]
  double rise_ = 0.0;   // how far smooth facets may rise over flat ones [mm]
  double floor_ = 0.0;  // radius given to a crease in curvatures [mm]
};

}  // namespace hydroscope
