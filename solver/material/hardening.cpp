// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/material/hardening.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hydroscope {

namespace {

Hardening::Value interpolate(const std::vector<std::array<double, 2>>& table, double ep) {
  if (ep >= table.back()[0]) return {table.back()[1], 0.0};
  const auto upper = std::upper_bound(table.begin(), table.end(), ep,
                                      [](double value, const auto& row) { return value < row[0]; });
  if (upper == table.begin()) return {table.front()[1], 0.0};
  const auto& a = *(upper - 1);
  const auto& b = *upper;
  const double slope = (b[1] - a[1]) / (b[0] - a[0]);
  return {a[1] + slope * (ep - a[0]), slope};
}

}  // namespace

Hardening::Value Hardening::operator()(double ep) const {
  switch (kind) {
    case Kind::kElastic:
      return {std::numeric_limits<double>::infinity(), 0.0};
    case Kind::kPerfect:
      return {yield, 0.0};
    case Kind::kSwift: {
      const double stress = k * std::pow(eps0 + ep, n);
      return {stress, n * stress / (eps0 + ep)};
    }
    case Kind::kVoce: {
      const double decay = q * std::exp(-b * ep);
      return {yield + q - decay, b * decay};
    }
    case Kind::kTable:
      return interpolate(table, ep);
  }
  return {};
}

}  // namespace hydroscope
