// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/tool_motion.h"

namespace hydroscope {

Vec3 ToolMotion::at(double time) const {
  const auto place = [](const std::array<double, 4>& row) { return Vec3(row[1], row[2], row[3]); };
  if (rows.empty()) return Vec3::Zero();
  if (time <= rows.front()[0]) return place(rows.front());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (time > rows[i][0]) continue;
    const double share = (time - rows[i - 1][0]) / (rows[i][0] - rows[i - 1][0]);
    return place(rows[i - 1]) + share * (place(rows[i]) - place(rows[i - 1]));
  }
  return place(rows.back());
}

}  // namespace hydroscope
