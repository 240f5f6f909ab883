// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hydroscope {

/// One quantity of a run at one time, and how wrong it may be.
struct QuantityError {
  std::string name;
  double time = 0.0;      ///< [s]
  double value = 0.0;     ///< of the run
  double error = 0.0;     ///< in the quantity's unit
  double relative = 0.0;  ///< of the quantity; of a force, pressure or moment, of its largest value looked at
};

/// What the comparison of a run with its companion says.
struct ErrorEstimate {
  std::vector<QuantityError>
      errors;           ///< of each quantity the worst: at the end, and where a path of the scene turns
  double worst = 0.0;   ///< largest `relative`
  std::string trouble;  ///< why there is no estimate, or less than one; empty when all is well
  int factorisations = 0, degrees_of_freedom = 0;  ///< of the companion
  double wall = 0.0;                               ///< of the companion [s]
};

/// Quantities over process time.
struct QuantityHistory {
  std::vector<double> times;                ///< [s]
  std::vector<std::vector<double>> values;  ///< one row a time
  /// Cubic through the four nearest times.
  double at(double time, std::size_t quantity) const;
};

/// Whether errors of a quantity are taken against its largest value: it starts from nothing, or ends there.
/// In the order of `names`.
std::vector<bool> list_rising(const std::vector<std::string>& names, const std::vector<std::string>& kinds);

/// Compares at the common end and at those of `times` before it. `share` of the difference is the error: with
/// errors of order q and steps twice as large it is 1 / (2^q - 1).
ErrorEstimate compare_histories(const QuantityHistory& run, const QuantityHistory& companion,
                                const std::vector<std::string>& names, const std::vector<bool>& is_rising,
                                std::vector<double> times, double share);

}  // namespace hydroscope
