// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>

#include "render/shape/sheet_shape.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

void check_size(const char* what, std::size_t size, std::size_t wanted) {
  if (size != wanted)
    throw ContractError("snapshot: " + std::string(what) + " has " + std::to_string(size) + " entries for " +
                        std::to_string(wanted));
}

}  // namespace

void check_snapshot(const Snapshot& snapshot) {
  if (snapshot.model == nullptr) throw ContractError("snapshot: without model");
  const std::size_t nodes = snapshot.points.size();
  check_size("directors", snapshot.directors.size(), nodes);
  check_size("thickness", snapshot.thickness.size(), nodes);
  check_size("plastic_strain", snapshot.plastic_strain.size(), nodes);
  check_size("contact_state", snapshot.contact_state.size(), nodes);
  check_size("gap", snapshot.gap.size(), nodes);
  check_size("contact_pressure", snapshot.contact_pressure.size(), nodes);
  check_size("contact_force", snapshot.contact_force.size(), nodes);
  check_size("tool_normal", snapshot.tool_normal.size(), nodes);
  check_size("slip", snapshot.slip.size(), nodes);
  check_size("slip_increment", snapshot.slip_increment.size(), nodes);
  if (!snapshot.toggles.empty()) {
    check_size("toggles", snapshot.toggles.size(), nodes);
    check_size("let_go_time", snapshot.let_go_time.size(), nodes);
    check_size("release_reference", snapshot.release_reference.size(), nodes);
    check_size("release_threshold", snapshot.release_threshold.size(), nodes);
  }
  check_size("tool_translation", snapshot.tool_translation.size(), snapshot.model->tools.size());
  for (const auto& quad : snapshot.model->quads)
    for (int node : quad)
      if (node < 0 || static_cast<std::size_t>(node) >= nodes)
        throw ContractError("snapshot: a quad names node " + std::to_string(node) + " of " +
                            std::to_string(nodes));
  for (std::size_t node = 0; node < nodes; ++node) {
    const bool is_finite = snapshot.points[node].allFinite() && snapshot.directors[node].allFinite() &&
                           std::isfinite(snapshot.thickness[node]) && snapshot.slip[node].allFinite() &&
                           snapshot.slip_increment[node].allFinite();
    if (!is_finite)
      throw ContractError("snapshot of increment " + std::to_string(snapshot.increment) + ": node " +
                          std::to_string(node) +
                          " has a place, director, thickness or slip that is not a number");
    if (static_cast<int>(snapshot.contact_state[node]) > 3)
      throw ContractError("snapshot: unknown contact class at node " + std::to_string(node));
  }
}

}  // namespace hydroscope
