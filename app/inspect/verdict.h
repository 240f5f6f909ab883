// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/inspect/episode.h"

namespace hydroscope {

/// The bounds of a verdict (docs/inspection.md).
struct VerdictBounds {
  double opening = 0.0;        ///< a gap above this counts as open: twice the touch tolerance [mm]
  double tension = 0.01;       ///< of the fluid's share: pulled for sure (release_tolerance of the scene)
  int chatter_toggles = 3;     ///< lets go, back, lets go: within kToggleWindow increments
  int window = kToggleWindow;  ///< increments within which coming back counts as taken back
};

/// Chatter: to and fro within the window. Physical: left by the tool's edge or with
/// the tool, or opened by more than the bound, or pulled for sure, alone or as a patch, and neither come back
/// nor been taken back just before: by more than the bound and than the facets' noise. Noise: all else.
/// `back`: increment in which it came back; none: it stayed away.
struct Judgement {
  Verdict verdict = Verdict::kPhysical;
  std::string reason;
};
Judgement judge_release(const ContactEvent& event, const std::optional<int>& back, const ReleaseFigures& f,
                        const VerdictBounds& bounds);

}  // namespace hydroscope
