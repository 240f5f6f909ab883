// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/view_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/contact_life.h"
#include "render/view_text.h"
#include "solver/base/error.h"

namespace hydroscope {

std::vector<double> calc_field(const std::string& view, const Snapshot& snapshot) {
  if (view == "thickness") return snapshot.thickness;
  if (view == "plastic-strain") return snapshot.plastic_strain;
  if (view == "contact-pressure") return snapshot.contact_pressure;
  if (view == "gap") return snapshot.gap;
  if (view == "detachment") return calc_contact_life(snapshot).age;
  if (view == "release-margin") return calc_contact_life(snapshot).margin;
  throw InputError("view '" + view + "' is unknown; there are " + join(view_names()));
}

const std::vector<std::string>& view_names() {
  static const std::vector<std::string> names{"contact-map",    "tool-normals",     "slip", "thickness",
                                              "plastic-strain", "contact-pressure", "gap",  "detachment",
                                              "chatter",        "release-margin"};
  return names;
}

bool is_view_of_detachment(const std::string& view) {
  return view == "detachment" || view == "chatter" || view == "release-margin";
}

ClassCounts count_classes(const Snapshot& snapshot) {
  ClassCounts counts;
  for (ContactClass contact_class : snapshot.contact_state)
    ++counts.nodes[static_cast<std::size_t>(contact_class)];
  return counts;
}

std::vector<std::string> range_names(const std::string& view) {
  if (view == "contact-map" || view == "tool-normals" || view == "chatter") return {};
  if (view == "slip") return {"slip", "slip-increment"};
  return {view};
}

Range calc_range(const std::string& name, const Snapshot& snapshot) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto include = [&range](double value) {
    if (!std::isfinite(value)) return;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  };
  if (name == "slip" || name == "slip-increment") {
    include(0.0);
    for (const Vec3& v : name == "slip" ? snapshot.slip : snapshot.slip_increment) include(v.norm());
  } else {
    if (name == "detachment") include(0.0);
    for (double value : calc_field(name, snapshot)) include(value);
  }
  // Letting go in the middle of the map; from one reference force on all are equally safe.
  if (name == "release-margin" && range.low <= range.high) {
    const double most = std::min(1.0, std::max(-range.low, range.high));
    range = {-most, most};
  }
  return range;
}

int count_without_value(const std::string& view, const Snapshot& snapshot) {
  const std::vector<double> field = calc_field(view, snapshot);
  return static_cast<int>(
      std::count_if(field.begin(), field.end(), [](double v) { return !std::isfinite(v); }));
}

Range calc_round_range(const Range& range) {
  if (!(range.low <= range.high)) return {0.0, 1.0};
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (size == 0.0) return {0.0, 1.0};
  double low = range.low, high = range.high;
  if (high - low < 1e-6 * size) {  // one value all over: a band around it, zero stays the end
    low -= low == 0.0 ? 0.0 : 1e-3 * size;
    high += high == 0.0 ? 0.0 : 1e-3 * size;
  }
  const double step = calc_round_step((high - low) / 10.0);
  // A value that is a multiple up to rounding must not open another step.
  return {step * std::floor(low / step + 1e-9), step * std::ceil(high / step - 1e-9)};
}

}  // namespace hydroscope
