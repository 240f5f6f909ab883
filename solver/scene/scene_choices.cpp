// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/scene_choices.h"

namespace hydroscope {

void choose_explicit_limits(const GivenKeys& given, Scene& scene) {
  IncrementScene& increment = scene.increment;
  const bool iterates = increment.correction == "newton";
  // A rounded onset helps an iteration, but lets points at rest creep by every increment that there is.
  if ((!iterates || increment.control == "error") && !given.has("material.yield_rounding"))
    scene.material.yield_rounding = 0.0;
  if (iterates) return;
  if (!given.has("increment.max_strain")) increment.max_strain = 0.003;
  if (!given.has("increment.max_rotation_deg")) increment.max_rotation = 1.0;
  if (!given.has("increment.max_penetration")) increment.max_penetration = 0.01;
  if (!given.has("increment.stop_at")) increment.stop_at = {"yield", "release", "slip"};
}

std::set<std::string> list_user_words(const GivenKeys& given) {
  return given.list(given.is_override("accuracy"));
}

}  // namespace hydroscope
