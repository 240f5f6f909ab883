// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/stability/gallery.h"

#include <algorithm>
#include <limits>

namespace hydroscope::stability {

History run_gallery(const std::string& file, const std::vector<std::string>& assignments) {
  return verification::run_scene("../tests/stability/" + file, assignments);
}

Range calc_range(const History& history, const std::string& quantity, double from, double to) {
  const std::vector<double> values = history.column(quantity);
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (history.rows[i].time <= from || history.rows[i].time > to) continue;
    range = {std::min(range.low, values[i]), std::max(range.high, values[i])};
  }
  return range;
}

std::vector<double> calc_face_radii(const Snapshot& state, double side) {
  std::vector<double> radii;
  for (std::size_t i = 0; i < state.points.size(); ++i) {
    const Vec3 x = state.points[i] + 0.5 * side * state.thickness[i] * state.directors[i];
    radii.push_back(x.head<2>().norm());
  }
  return radii;
}

double calc_median_residual(const History& history) {
  std::vector<double> values;
  for (const IncrementReport& row : history.rows) values.push_back(row.residual);
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[values.size() / 2];
}

int count_events(const History& history, EventKind kind, const std::string& cause) {
  int count = 0;
  for (const IncrementReport& row : history.rows) {
    for (const ContactEvent& event : row.events) {
      if (event.kind == kind && (cause.empty() || event.cause == cause)) ++count;
    }
  }
  return count;
}

}  // namespace hydroscope::stability
