// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "solver/geometry/facet_search.h"

namespace hydroscope {

/// Bounding-volume tree over the facets of a mesh: axis-aligned boxes, halved at
/// the median, four facets a leaf.
class TriangleTree final : public FacetSearch {
 public:
  explicit TriangleTree(const TriangleMesh& mesh);

  Nearest find_nearest(const Vec3& x, Nearest start) const override;
  void visit_within(const Vec3& x, double radius, const std::function<void(int)>& visit) const override;

  int depth() const { return depth_; }

 private:
  static constexpr int kStack = 64;
  struct Node {
    Vec3 low, high;
    int first = 0;  ///< a leaf: its first slot; else its first child (the second follows)
    int count = 0;  ///< facets of a leaf; 0: an inner node
  };

  void build(int node, int first, int count, int level, const std::vector<Vec3>& centres);
  static double calc_box_distance2(const Node& node, const Vec3& x) {
    const Vec3 outside = (node.low - x).cwiseMax(x - node.high).cwiseMax(0.0);
    return outside.squaredNorm();
  }

  std::vector<Node> nodes_;
  int depth_ = 0;
};

}  // namespace hydroscope
