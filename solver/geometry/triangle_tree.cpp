// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/triangle_tree.h"

#include <numeric>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

constexpr int kLeaf = 4;
// A box is never farther than the facets in it, but its distance rounds differently.
constexpr double kSlack = 1.0 + 1e-12;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  const int count = static_cast<int>(mesh.triangles.size());
  require(count > 0, "a triangle tree needs at least one facet");
  slots_.resize(at(count));
  std::vector<Vec3> centres(at(count));
  for (int f = 0; f < count; ++f) {
    const auto& t = mesh.triangles[at(f)];
    slots_[at(f)] = {mesh.points[at(t[0])], mesh.points[at(t[1])], mesh.points[at(t[2])], f};
    const Slot& slot = slots_[at(f)];
    centres[at(f)] =
        0.5 * (slot.a.cwiseMin(slot.b).cwiseMin(slot.c) + slot.a.cwiseMax(slot.b).cwiseMax(slot.c));
  }
  nodes_.reserve(at(count));
  nodes_.emplace_back();
  build(0, 0, count, 1, centres);
  require(depth_ < kStack, "a triangle tree deeper than its stack");
  slot_of_facet_.resize(at(count));
  for (int s = 0; s < count; ++s) slot_of_facet_[at(slots_[at(s)].facet)] = s;
}

void TriangleTree::build(int node, int first, int count, int level, const std::vector<Vec3>& centres) {
  depth_ = std::max(depth_, level);
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  Vec3 centre_low = low;
  Vec3 centre_high = high;
  for (int s = first; s < first + count; ++s) {
    const Slot& slot = slots_[at(s)];
    low = low.cwiseMin(slot.a).cwiseMin(slot.b).cwiseMin(slot.c);
    high = high.cwiseMax(slot.a).cwiseMax(slot.b).cwiseMax(slot.c);
    centre_low = centre_low.cwiseMin(centres[at(slot.facet)]);
    centre_high = centre_high.cwiseMax(centres[at(slot.facet)]);
  }
  nodes_[at(node)].low = low;
  nodes_[at(node)].high = high;
  if (count <= kLeaf) {
    nodes_[at(node)].first = first;
    nodes_[at(node)].count = count;
    return;
  }
  int axis = 0;
  (centre_high - centre_low).maxCoeff(&axis);
  const int half = count / 2;
  const auto begin = slots_.begin() + first;
  // The facet id breaks ties, so that the tree is the same on every machine.
  std::nth_element(begin, begin + half, begin + count, [&](const Slot& p, const Slot& q) {
    const double a = centres[at(p.facet)][axis];
    const double b = centres[at(q.facet)][axis];
    return a != b ? a < b : p.facet < q.facet;
  });
  const int child = static_cast<int>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[at(node)].first = child;
  nodes_[at(node)].count = 0;
  build(child, first, half, level + 1, centres);
  build(child + 1, first + half, count - half, level + 1, centres);
}

void TriangleTree::search_leaf(const Node& node, const Vec3& x, Nearest& best) const {
  for (int s = node.first; s < node.first + node.count; ++s) {
    const Slot& slot = slots_[at(s)];
    const double distance2 = find_closest_point(x, slot.a, slot.b, slot.c).distance2;
    const bool is_better = distance2 < best.distance2 ||
                           (distance2 == best.distance2 && (best.facet < 0 || slot.facet < best.facet));
    if (is_better) best = {slot.facet, distance2};
  }
}

TriangleTree::Nearest TriangleTree::find_nearest(const Vec3& x, Nearest start) const {
  struct Entry {
    int node;
    double distance2;
  };
  std::array<Entry, kStack> stack;
  int top = 0;
  stack[0] = {0, calc_box_distance2(nodes_[0], x)};
  Nearest best = start;
  while (top >= 0) {
    const Entry entry = stack[at(top--)];
    if (entry.distance2 > best.distance2 * kSlack) continue;
    const Node& node = nodes_[at(entry.node)];
    if (node.count > 0) {
      search_leaf(node, x, best);
      continue;
    }
    const double first = calc_box_distance2(nodes_[at(node.first)], x);
    const double second = calc_box_distance2(nodes_[at(node.first + 1)], x);
    const bool is_first_nearer = first <= second;
    const double farther = is_first_nearer ? second : first;
    if (farther <= best.distance2 * kSlack) {
      stack[at(++top)] = {node.first + (is_first_nearer ? 1 : 0), farther};
    }
    stack[at(++top)] = {node.first + (is_first_nearer ? 0 : 1), is_first_nearer ? first : second};
  }
  return best;
}

double TriangleTree::calc_distance2(const Vec3& x, int facet) const {
  const Slot& slot = slots_[at(slot_of_facet_[at(facet)])];
  return find_closest_point(x, slot.a, slot.b, slot.c).distance2;
}

}  // namespace hydroscope
