// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/verification/run_scene.h"

namespace hydroscope::stability {

using verification::History;
using verification::relative_error;

/// Runs a scene of this folder with keys replaced as on the command line.
History run_gallery(const std::string& file, const std::vector<std::string>& assignments = {});

/// Smallest and largest value.
struct Range {
  double low = 0.0, high = 0.0;
  double width() const { return high - low; }
};

/// Of a quantity over the increments that end in (from, to] [s].
Range calc_range(const History& history, const std::string& quantity, double from, double to = 1e300);

/// Distance of a face of the wall from the z axis at each node [mm].
std::vector<double> calc_face_radii(const Snapshot& state, double side);

double calc_median_residual(const History& history);

/// Events of a kind over the whole run; of one cause, if given.
int count_events(const History& history, EventKind kind, const std::string& cause = "");

}  // namespace hydroscope::stability
