// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "solver/geometry/height_field.h"
#include "solver/geometry/pose.h"
#include "solver/geometry/quad_prism.h"
#include "solver/geometry/tool_surface.h"
#include "solver/geometry/vertex_normals.h"

namespace hydroscope {

/// A tool surface of bilinear cells over a point set (method 1a), with a normal at each point averaged over
/// the cells around it and interpolated (4.2). The search needs no tree: x and y give the cell. Edges are
/// rounded over one pitch, however sharp; `sharp_edges()` counts them.
///
/// As on a mesh, a point belongs to the nearest cell, and there to the prism that holds it.
class HeightSurface final : public ToolSurface {
 public:
  /// `field` has passed check_height_field(); `pose` places it, z being free space. `crease_angle` [deg].
  HeightSurface(HeightField field, const Pose& pose, NormalRule normals = NormalRule::area,
                double crease_angle = 40.0);

  std::optional<FootPoint> find_foot_point(const Vec3& x, double band, double depth,
                                           SearchHint& hint) const override;
  const TriangleMesh& display_mesh() const override { return display_mesh_; }
  const std::vector<Vec3>& display_normals() const override { return display_normals_; }

  const HeightField& field() const { return field_; }
  /// Lines between points where the cells on both sides differ by more than the crease angle.
  int sharp_edges() const { return sharp_edges_; }

 private:
  struct Cell {
    int i = -1, j = -1;
    bool operator==(const Cell&) const = default;
  };
  struct Nearest {
    Cell cell;
    double distance2;
  };

  bool has_cell(const Cell& cell) const;
  int number(const Cell& cell) const { return cell.j * (field_.columns - 1) + cell.i; }
  Cell cell_of(int number) const { return {number % (field_.columns - 1), number / (field_.columns - 1)}; }
  /// The cell over which `x` lies, or the nearest one of the grid.
  Cell find_column(const Vec3& x) const;
  std::array<Vec3, 4> list_corners(const Cell& cell) const;
  std::array<Vec3, 4> list_normals(const Cell& cell) const;
  QuadPrism make_cell(const Cell& cell) const {
    return make_quad_prism(list_corners(cell), list_normals(cell));
  }
  void make_normals(NormalRule rule);
  void make_display();
  void count_sharp_edges(double crease_angle);

  void search_cell(const Cell& cell, const Vec3& x, Nearest& best) const;
  Nearest find_nearest(const Vec3& x, Nearest start) const;
  FootPoint locate(const Vec3& x, const Cell& nearest) const;
  FootPoint finish(const Vec3& x, const Cell& cell, const QuadPoint& at) const;
  FootPoint follow_rim(const Vec3& x, Cell cell, int side) const;
  FootPoint fix(const Vec3& x, const Cell& cell) const;

  HeightField field_;
  Pose pose_;
  bool keeps_cell_normals_;
  std::vector<Vec3> normals_;  // one a point; with facet normals four a cell
  TriangleMesh display_mesh_;
  std::vector<Vec3> display_normals_;
  double low_ = 0.0, high_ = 0.0;  // heights [mm]
  int sharp_edges_ = 0;
};

}  // namespace hydroscope
