// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "render/chart/line_chart.h"

namespace hydroscope {

struct AxisTick {
  double value = 0.0;
  std::string label;  ///< empty: a small tick between
};

/// From values to the unit interval, linearly or by the logarithm.
class AxisScale {
 public:
  /// Ends that `axis` leaves open come from `values`, with room at both ends.
  AxisScale(const ChartAxis& axis, const std::vector<double>& values);

  /// Whether a value has a place: finite, and above zero on a logarithmic axis.
  bool takes(double value) const;
  double to_unit(double value) const;  ///< 0 at the low end, 1 at the high end
  double low() const { return low_; }
  double high() const { return high_; }
  /// About `count` labelled ticks, small ones between them on a logarithmic axis.
  std::vector<AxisTick> find_ticks(int count) const;

 private:
  std::vector<AxisTick> find_log_ticks(int count) const;
  std::vector<AxisTick> find_linear_ticks(int count) const;

  bool is_log_;
  double low_, high_;
};

}  // namespace hydroscope
