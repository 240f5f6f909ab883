// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/snapshot/snapshot.h"

namespace hydroscope {

struct ViewText {
  std::string heading;
  std::string quantity;  ///< with its unit
};
ViewText find_view_text(const std::string& view);

/// "t = 1.2500 s   p = 16.963 MPa   increment 42": on the picture and in the sidecar.
std::string make_time_label(const Snapshot& snapshot);

/// Four figures, no trailing zeros: 0.0025, 16.96, 1200.
std::string format_number(double value);

/// Smallest of 1, 2, 5 times a power of ten that is not below `step` (> 0).
double calc_round_step(double step);

std::string join(const std::vector<std::string>& words);

}  // namespace hydroscope
