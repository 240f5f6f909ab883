// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/scene.h"

#include <algorithm>

namespace hydroscope {

double Scene::end_time() const {
  double end = 0.0;
  const auto reach = [&end](const Path& path) { end = std::max(end, path.end_time()); };
  // The path of the control that is not in use drives nothing, so it does not prolong the run.
  reach(load.control == "volume" ? load.volume_ratio : load.pressure);
  reach(load.axial_feed);
  for (const auto& [which, edge] : edges) {
    reach(edge.move_x);
    reach(edge.move_y);
    reach(edge.force_x);
    reach(edge.force_y);
    reach(edge.tension);
    reach(edge.moment);
  }
  for (const auto& [name, tool] : tools) {
    if (!tool.motion.empty()) end = std::max(end, tool.motion.back()[0]);
  }
  return end;
}

}  // namespace hydroscope
