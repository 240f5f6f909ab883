// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/results/json.h"
#include "app/server/view_query.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// What a state says of one node, as a flat record; unknown values are null. The normal force presses when it
/// is positive. `margin_N` is the normal force that may still be lost until the node lets go: the share of
/// ContactLife::margin times the reference force. `first`: the state that displacements start from. Throws
/// InputError when there is no such node.
Json::Object make_node_record(const Snapshot& snapshot, const Snapshot& first, int node, int branch);

/// Of one element: its nodes, and the means over them.
Json::Object make_element_record(const Snapshot& snapshot, int element);

/// The life of a node, state by state, as one array a key.
class NodeHistory {
 public:
  explicit NodeHistory(int node) : node_(node) {}
  void add(const Snapshot& snapshot);
  Json make_json() const;

 private:
  int node_;
  Json::Array increment_, time_, pressure_, thickness_, plastic_strain_, gap_, normal_force_, margin_,
      contact_, slip_;
};

/// Counts of the contact classes, and least, mean and greatest thickness, plastic strain, contact pressure
/// and gap over some nodes.
Json::Object make_nodes_summary(const Snapshot& snapshot, const std::vector<int>& nodes);

}  // namespace hydroscope
