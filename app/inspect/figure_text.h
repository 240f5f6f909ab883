// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hydroscope {

/// Four digits for people: "0.0005610", "-" when not known, "far" when infinite.
std::string format_figure(double number);

/// Columns side by side, two spaces apart; the first line is the head. Columns in
/// which every cell below the head is a number or "-" are aligned at their right.
std::string format_columns(const std::vector<std::vector<std::string>>& lines);

}  // namespace hydroscope
