// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/sheet_history.h"

#include <algorithm>
#include <set>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

std::size_t check_node(int node, std::size_t nodes) {
  if (node < 0 || static_cast<std::size_t>(node) >= nodes)
    throw InputError("an element has node " + std::to_string(node) + " of " + std::to_string(nodes));
  return static_cast<std::size_t>(node);
}

}  // namespace

const SheetState* SheetHistory::find_before(int increment) const {
  const SheetState* found = nullptr;
  for (const SheetState& state : states)
    if (state.increment < increment) found = &state;
  return found;
}

const SheetState* SheetHistory::find_from(int increment) const {
  for (const SheetState& state : states)
    if (state.increment >= increment) return &state;
  return nullptr;
}

std::vector<double> calc_node_areas(const std::vector<std::array<int, 4>>& quads,
                                    const std::vector<Vec3>& points) {
  std::vector<double> areas(points.size(), 0.0);
  for (const auto& quad : quads) {
    std::array<std::size_t, 4> n{};
    for (std::size_t k = 0; k < 4; ++k) n[k] = check_node(quad[k], points.size());
    const Vec3 d1 = points[n[2]] - points[n[0]], d2 = points[n[3]] - points[n[1]];
    for (const std::size_t node : n) areas[node] += 0.25 * 0.5 * d1.cross(d2).norm();
  }
  return areas;
}

std::vector<std::vector<int>> find_neighbours(const std::vector<std::array<int, 4>>& quads, int nodes) {
  std::vector<std::set<int>> sets(static_cast<std::size_t>(nodes));
  for (const auto& quad : quads)
    for (const int a : quad)
      for (const int b : quad)
        if (a != b) sets[check_node(a, sets.size())].insert(b);
  std::vector<std::vector<int>> neighbours;
  for (const auto& set : sets) neighbours.emplace_back(set.begin(), set.end());
  return neighbours;
}

SheetState make_sheet_state(const Snapshot& s) {
  const std::size_t nodes = s.points.size();
  if (s.gap.size() != nodes || s.contact_force.size() != nodes || s.tool_normal.size() != nodes ||
      s.contact_pressure.size() != nodes || s.contact_tool.size() != nodes || s.thickness.size() != nodes)
    throw InputError("a contact array has another length than the points");
  SheetState state{s.increment,
                   s.time,
                   s.pressure,
                   s.gap,
                   {},
                   s.contact_pressure,
                   calc_node_areas(s.model->quads, s.points),
                   s.contact_tool,
                   s.thickness,
                   s.tool_translation,
                   s.tool_normal};
  for (std::size_t i = 0; i < nodes; ++i)
    state.normal_force.push_back(s.contact_force[i].dot(s.tool_normal[i]));
  return state;
}

}  // namespace hydroscope
