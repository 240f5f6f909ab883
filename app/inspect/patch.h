// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/inspect/episode.h"

namespace hydroscope {

/// Neighbours in the mesh that let go of one tool, each within kToggleWindow increments of the next.
struct Patch {
  std::vector<std::size_t> episodes;  ///< in order of increments, then nodes
  int tool = -1;
  int nodes = 0;  ///< different ones
  int first_increment = 0, last_increment = 0;
  double first_time = 0.0, last_time = 0.0;  ///< [s]
  std::vector<std::string> causes;           ///< different ones, in order
  std::vector<std::string> drives;           ///< the same of find_drive()
  Vec3 centre = Vec3::Zero();                ///< mean of the contact points [mm]
  double area = 0.0;                         ///< [mm^2]
  double force_before = 0.0;                 ///< sum of the normal forces [N]
  double fluid_share = 0.0;                  ///< sum of p A [N]
  double facet_noise = 0.0;                  ///< root of the sum of (dp A)^2 [N]; NaN: not known
  double gap_reached = 0.0;                  ///< largest [mm]
  int back = 0;                              ///< episodes after which the node came back
  std::array<int, 3> verdicts{};             ///< how many of each Verdict
  Verdict verdict = Verdict::kPhysical;      ///< of most; of two equal the more doubtful
};

/// Groups what let go, in order of time, and writes each episode's `patch`, `patch_force_share`
/// and `patch_noise_share`.
std::vector<Patch> make_patches(const ContactLog& log, const std::vector<std::vector<int>>& neighbours,
                                std::vector<Episode>& episodes);

/// Counts the verdicts of the episodes, once they are known.
void count_verdicts(const std::vector<Episode>& episodes, std::vector<Patch>& patches);

}  // namespace hydroscope
