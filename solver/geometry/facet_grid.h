// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "solver/geometry/facet_search.h"

namespace hydroscope {

/// Uniform grid of cells over the box of a mesh; each cell lists the facets whose boxes touch it.
/// A look-up goes outwards from the point's cell, ring by ring. Cells are 1.5 median edges wide
/// (mechanics 7.1), or wider where the box is so large that there would be more than some cells a facet.
class FacetGrid final : public FacetSearch {
 public:
  explicit FacetGrid(const TriangleMesh& mesh);

  Nearest find_nearest(const Vec3& x, Nearest start) const override;
  void visit_within(const Vec3& x, double radius, const std::function<void(int)>& visit) const override;

  double cell_size() const { return size_; }  ///< [mm]

 private:
  using Cell = std::array<int, 3>;

  void choose_cells();
  /// The cell of `x`, or the nearest one of the grid.
  Cell find_cell(const Vec3& x) const;
  std::size_t index(int i, int j, int k) const;
  void search_cell(int i, int j, int k, const Vec3& x, Nearest& best) const;
  void search_ring(const Cell& centre, int ring, const Vec3& x, Nearest& best) const;
  /// Nothing outside of the rings up to `ring` is nearer to `x` than this [mm]; infinite when nothing is
  /// left.
  double calc_ring_distance(const Cell& centre, int ring, const Vec3& x) const;
  template <class Visit>
  static void for_cells(const Cell& low, const Cell& high, Visit&& visit);

  double size_ = 1.0;
  Cell count_{1, 1, 1};
  std::vector<int> start_;  // slots of cell c: listed_[start_[c] .. start_[c + 1])
  std::vector<int> listed_;
};

}  // namespace hydroscope
