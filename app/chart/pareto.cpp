// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hydroscope {
namespace {

bool is_finite(const CostPoint& p) { return std::isfinite(p.cost) && std::isfinite(p.error); }

bool beats(const CostPoint& a, const CostPoint& b) {
  return a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

}  // namespace

std::vector<std::size_t> find_pareto_front(const std::vector<CostPoint>& points) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i])) continue;
    const bool is_beaten = std::any_of(points.begin(), points.end(), [&](const CostPoint& other) {
      return is_finite(other) && beats(other, points[i]);
    });
    if (!is_beaten) front.push_back(i);
  }
  std::stable_sort(front.begin(), front.end(),
                   [&](std::size_t a, std::size_t b) { return points[a].cost < points[b].cost; });
  return front;
}

bool is_better(const CostPoint& a, const CostPoint& b, double share) {
  return is_finite(a) && is_finite(b) && a.cost * (1.0 + share) < b.cost && a.error * (1.0 + share) < b.error;
}

double fit_slope(const std::vector<double>& x, const std::vector<double>& y) {
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (!(x[i] > 0.0) || !(y[i] > 0.0) || !std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    const double a = std::log(x[i]), b = std::log(y[i]);
    n += 1.0;
    sx += a;
    sy += b;
    sxx += a * a;
    sxy += a * b;
  }
  const double spread = n * sxx - sx * sx;
  return n >= 2.0 && spread > 1e-12 * n * n ? (n * sxy - sx * sy) / spread
                                            : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace hydroscope
