// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hydroscope {

/// Number of single-character edits (insert, delete, replace, swap of
/// neighbours) that turn `a` into `b`, upper and lower case taken as equal.
int calc_edit_distance(const std::string& a, const std::string& b);

/// The name in `known` that the writer of `given` most likely meant; empty when
/// nothing is near. A name that differs by its unit only (`thickness_m`,
/// `pressure_bar`, `length`) counts as near however long the unit is.
std::string find_nearest_name(const std::string& given, const std::vector<std::string>& known);

/// The key without its unit: `thickness` for `thickness_mm`.
std::string strip_unit(const std::string& key);

}  // namespace hydroscope
