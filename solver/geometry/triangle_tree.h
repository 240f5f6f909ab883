// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "solver/base/types.h"
#include "solver/geometry/closest_point.h"

namespace hydroscope {

/// Bounding-volume tree over the facets of a mesh: axis-aligned boxes, halved at
/// the median, four facets a leaf. Immutable after construction.
class TriangleTree {
 public:
  explicit TriangleTree(const TriangleMesh& mesh);

  struct Nearest {
    int facet = -1;
    double distance2 = std::numeric_limits<double>::infinity();  ///< [mm^2]
  };

  /// The facet nearest to `x`, if one is nearer than `start` (or as near with a lower
  /// id); otherwise `start`. Exact ties go to the lowest facet id, so the answer does
  /// not depend on `start`: a good start only makes it cheaper.
  Nearest find_nearest(const Vec3& x, Nearest start) const;

  /// Squared distance of `x` to one facet, with the same rounding as in `find_nearest`.
  double calc_distance2(const Vec3& x, int facet) const;

  /// Calls visit(facet) for each facet whose box is within `radius` of `x`.
  template <class Visit>
  void visit_within(const Vec3& x, double radius, Visit&& visit) const;

  int depth() const { return depth_; }
  const Vec3& low() const { return nodes_[0].low; }
  const Vec3& high() const { return nodes_[0].high; }

 private:
  static constexpr int kStack = 64;
  struct Node {
    Vec3 low, high;
    int first = 0;  ///< a leaf: its first slot; else its first child (the second follows)
    int count = 0;  ///< facets of a leaf; 0: an inner node
  };
  struct Slot {
    Vec3 a, b, c;
    int facet = -1;
  };

  void build(int node, int first, int count, int level, const std::vector<Vec3>& centres);
  static double calc_box_distance2(const Node& node, const Vec3& x) {
    const Vec3 outside = (node.low - x).cwiseMax(x - node.high).cwiseMax(0.0);
    return outside.squaredNorm();
  }
  void search_leaf(const Node& node, const Vec3& x, Nearest& best) const;

  std::vector<Node> nodes_;
  std::vector<Slot> slots_;
  std::vector<int> slot_of_facet_;
  int depth_ = 0;
};

template <class Visit>
void TriangleTree::visit_within(const Vec3& x, double radius, Visit&& visit) const {
  std::array<int, kStack> stack{};
  int top = 0;
  stack[0] = 0;
  while (top >= 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[static_cast<std::size_t>(top--)])];
    if (calc_box_distance2(node, x) > radius * radius) continue;
    for (int k = 0; k < node.count; ++k) visit(slots_[static_cast<std::size_t>(node.first + k)].facet);
    if (node.count > 0) continue;
    stack[static_cast<std::size_t>(++top)] = node.first + 1;
    stack[static_cast<std::size_t>(++top)] = node.first;
  }
}

}  // namespace hydroscope
