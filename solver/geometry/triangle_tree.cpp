// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/triangle_tree.h"

#include <array>
#include <limits>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

constexpr int kLeaf = 4;
// A box is never farther than the facets in it, but its distance rounds differently.
constexpr double kSlack = 1.0 + 1e-12;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

TriangleTree::TriangleTree(const TriangleMesh& mesh) : FacetSearch(mesh) {
  const int count = static_cast<int>(slots_.size());
  std::vector<Vec3> centres;
  centres.reserve(slots_.size());
  for (const Slot& slot : slots_) centres.push_back(0.5 * (slot.low() + slot.high()));
  nodes_.reserve(slots_.size());
  nodes_.emplace_back();
  build(0, 0, count, 1, centres);
  require(depth_ < kStack, "a triangle tree deeper than its stack");
  number_slots();
}

void TriangleTree::build(int node, int first, int count, int level, const std::vector<Vec3>& centres) {
  depth_ = std::max(depth_, level);
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  Vec3 centre_low = low;
  Vec3 centre_high = high;
  for (int s = first; s < first + count; ++s) {
    const Slot& slot = slots_[at(s)];
    low = low.cwiseMin(slot.low());
    high = high.cwiseMax(slot.high());
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
      for (int s = node.first; s < node.first + node.count; ++s) keep_nearer(slots_[at(s)], x, best);
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

void TriangleTree::visit_within(const Vec3& x, double radius, const std::function<void(int)>& visit) const {
  std::array<int, kStack> stack{};
  int top = 0;
  stack[0] = 0;
  while (top >= 0) {
    const Node& node = nodes_[at(stack[at(top--)])];
    if (calc_box_distance2(node, x) > radius * radius) continue;
    for (int s = node.first; s < node.first + node.count; ++s) {
      if (slots_[at(s)].is_box_within(x, radius)) visit(slots_[at(s)].facet);
    }
    if (node.count > 0) continue;
    stack[at(++top)] = node.first + 1;
    stack[at(++top)] = node.first;
  }
}

}  // namespace hydroscope
