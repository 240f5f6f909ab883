// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace hydroscope {

struct CostPoint {
  double cost = 0.0, error = 0.0;
};

/// Indices of the points that no other beats in both, cheapest first: another point is better when
/// it is not worse in either and better in one. Points that are not finite never count; of equal
/// points all do.
std::vector<std::size_t> find_pareto_front(const std::vector<CostPoint>& points);

/// Whether `a` is both cheaper and more accurate than `b` by more than `share` (0.1: 10 %).
bool is_better(const CostPoint& a, const CostPoint& b, double share);

/// Slope of log(y) over log(x) by least squares; nan with fewer than two points above zero.
double fit_slope(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace hydroscope
