// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/scratch.h"

namespace hydroscope {

/// E_t of a node [N/mm]: a share of E/h per area (4.45).
double calc_stick_stiffness(const Model& model, double area);

/// Gaps, foot points and normals of all slave points in the trial configuration
/// against the tools as they stand at `loads.time`.
void search_contacts(const Model& model, const Loads& loads, Scratch& scratch);

/// Normal forces from total equilibrium (mechanics 9.1), friction by return
/// mapping, contact stiffness, and the local bases with what is prescribed:
/// minus the gap at contact nodes, the support motions at supports.
/// With `freeze_friction` the normal forces that bound the friction stay as they
/// are: their coupling is unsymmetric and not in the tangent, and left free it
/// would make the corrector creep. The bound is then behind by the last corrections only.
void evaluate_contacts(const Model& model, const State& state, const Loads& loads, bool freeze_friction,
                       Scratch& scratch);

/// A spring of the wall (calc_wall_stiffness()) that has come into the matrix, or gone from it (negative).
struct SpringChange {
  int node = 0;
  NodeVector row;
  double stiffness = 0.0;  ///< [N/mm]; infinite: the constraint is eliminated
};

/// What changed in the set of touching nodes.
struct SetChange {
  int touched = 0, released = 0, reclosed = 0;
  std::vector<SpringChange> springs;  ///< the same in the matrix
  bool any() const { return touched + released + reclosed > 0; }
};

/// Nodes that have gone through a tool touch; nodes under tension let go, by the
/// rule of mechanics 9.4 (relative threshold and patch pressure, in groups); a
/// released node that is pushed back is closed again and locked.
/// `may_release` is false while reactions are still far from equilibrium.
SetChange update_contact_set(const Model& model, const State& state, const Loads& loads, bool may_release,
                             Scratch& scratch);

/// With friction one step behind: forces and status for the next increment (4.46)-(4.48), once this one is
/// done.
void renew_friction(const Model& model, Scratch& scratch);

/// Tangential part of the out-of-balance force at the nodes in contact against their normal forces, both as
/// Euclidean norms: what (4.23) calls the rest.
double calc_tangential_rest(const Scratch& scratch, const Loads& loads);

/// Largest distance by which a node in contact is off its tool [mm].
double calc_gap_error(const Trial& trial);

}  // namespace hydroscope
