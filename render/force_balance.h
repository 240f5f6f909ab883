// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// Do the forces of a snapshot belong together? In equilibrium the fluid, the tools
/// and the supports leave nothing over on the modelled part: a contact map that
/// lies does not add up. The fluid's share is taken from the mesh, not from the solver.
struct ForceBalance {
  Vec3 pressure = Vec3::Zero();  ///< sum of p a n over the loaded face [N]
  Vec3 contact = Vec3::Zero();   ///< sum of the nodal contact forces [N]
  Vec3 support = Vec3::Zero();   ///< supports, symmetry planes and edge loads [N]
  bool is_support_known = false;
  /// What is left over: pressure + contact + support [N]; no number while supports are not known.
  Vec3 rest = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  /// Largest of the sums of magnitudes of the three kinds of force [N].
  double scale = 0.0;
  /// |contact - what the tools say themselves| [N]; no number while that is not known.
  double contact_error = std::numeric_limits<double>::quiet_NaN();
  /// Free nodes with a contact force or a tool, and touching nodes without a tool.
  int contradicting_nodes = 0;

  /// |rest| / scale; no number while supports are not known.
  double rest_share() const { return scale > 0.0 ? rest.norm() / scale : rest.norm(); }
  double contact_error_share() const { return scale > 0.0 ? contact_error / scale : contact_error; }
};

ForceBalance calc_force_balance(const Snapshot& snapshot);

}  // namespace hydroscope
