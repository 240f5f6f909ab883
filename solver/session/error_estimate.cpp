// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/error_estimate.h"

#include <algorithm>
#include <cmath>

namespace hydroscope {

double QuantityHistory::at(double time, std::size_t quantity) const {
  const std::size_t n = times.size();
  const auto next = static_cast<std::size_t>(
      std::lower_bound(times.begin(), times.end(), time * (1.0 - 1e-12)) - times.begin());
  const std::size_t i = std::min(next, n - 1);
  if (std::abs(times[i] - time) <= 1e-9 * std::abs(time) || i == 0) return values[i][quantity];
  const std::size_t last = std::min(n, i + 2), first = last >= 4 ? last - 4 : 0;
  double sum = 0.0;
  for (std::size_t j = first; j < last; ++j) {
    double weight = 1.0;
    for (std::size_t k = first; k < last; ++k) {
      if (k != j) weight *= (time - times[k]) / (times[j] - times[k]);
    }
    sum += weight * values[j][quantity];
  }
  return sum;
}

std::vector<bool> list_rising(const std::vector<std::string>& names, const std::vector<std::string>& kinds) {
  std::vector<bool> rising;
  for (std::size_t k = 0; k < names.size(); ++k) {
    rising.push_back(kinds[k] == "contact_pressure" || kinds[k] == "contact_force" ||
                     kinds[k] == "bending_moment" || kinds[k] == "edge_force");
  }
  return rising;
}

ErrorEstimate compare_histories(const QuantityHistory& run, const QuantityHistory& companion,
                                const std::vector<std::string>& names, const std::vector<bool>& is_rising,
                                std::vector<double> times, double share) {
  ErrorEstimate estimate;
  if (run.times.empty() || companion.times.empty()) {
    estimate.trouble = "there is nothing to compare";
    return estimate;
  }
  const double end = std::min(run.times.back(), companion.times.back());
  times.erase(std::remove_if(times.begin(), times.end(),
                             [&](double t) { return t <= 0.0 || t >= end * (1.0 - 1e-9); }),
              times.end());
  times.push_back(end);
  for (std::size_t q = 0; q < names.size(); ++q) {
    double largest = 0.0;
    for (const double t : times) largest = std::max(largest, std::abs(run.at(t, q)));
    QuantityError worst;
    for (const double t : times) {
      const double value = run.at(t, q), error = share * std::abs(value - companion.at(t, q));
      const double scale = is_rising[q] ? largest : std::abs(value);
      const QuantityError here{names[q], t, value, error, scale > 0.0 ? error / scale : 0.0};
      if (worst.name.empty() || here.relative >= worst.relative) worst = here;
    }
    estimate.errors.push_back(worst);
    estimate.worst = std::max(estimate.worst, worst.relative);
  }
  return estimate;
}

}  // namespace hydroscope
