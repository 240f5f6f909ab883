// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// One saved state, as far as contact asks for it. Arrays have one entry a node.
struct SheetState {
  int increment = 0;
  double time = 0.0;                     ///< [s]
  double pressure = 0.0;                 ///< [MPa]
  std::vector<double> gap;               ///< to the nearest tool [mm]; NaN: none is near
  std::vector<double> normal_force;      ///< tool on sheet, pressing is positive [N]
  std::vector<double> contact_pressure;  ///< smoothed [MPa]
  std::vector<double> area;              ///< a node's share of the mid-surface [mm^2]
  std::vector<int> tool;                 ///< -1: free
  std::vector<double> thickness;         ///< [mm]
  std::vector<Vec3> tool_translation;    ///< one a tool [mm]; not a number: taken away
  std::vector<Vec3> tool_normal;         ///< from the tool to the sheet; zero: free
};

/// The saved states in order of increments, and who is whose neighbour in the mesh.
struct SheetHistory {
  std::vector<SheetState> states;
  std::vector<std::vector<int>> neighbours;  ///< nodes of the same elements, sorted

  /// The last state before `increment`; null when there is none.
  const SheetState* find_before(int increment) const;
  /// The first state at `increment` or later; null when there is none.
  const SheetState* find_from(int increment) const;
};

/// Each quadrilateral, half the product of its diagonals, gives a quarter to each corner.
std::vector<double> calc_node_areas(const std::vector<std::array<int, 4>>& quads,
                                    const std::vector<Vec3>& points);

/// Nodes that share an element.
std::vector<std::vector<int>> find_neighbours(const std::vector<std::array<int, 4>>& quads, int nodes);

SheetState make_sheet_state(const Snapshot& snapshot);

}  // namespace hydroscope
