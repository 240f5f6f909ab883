// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/state.h"

namespace hydroscope {

/// Force of a line load on its k-th node at a time [N]: dead, and tension along the edge's outward tangent.
inline Vec3 calc_edge_load(const EdgeLoad& load, std::size_t k, const Configuration& configuration,
                           double time) {
  const Vec3& edge = configuration.x[static_cast<std::size_t>(load.nodes[k])];
  const Vec3& inside = configuration.x[static_cast<std::size_t>(load.inner_nodes[k])];
  const Vec3 dead(load.force_x(time), load.force_y(time), 0.0);
  return load.widths[k] * (dead + load.tension(time) * (edge - inside).normalized());
}

/// Moment of a line load on its k-th node at a time, on (alpha, beta) [N mm]: it turns the fibre about the
/// strip's width axis z, from x towards y, and keeps that axis whatever the fibre does.
inline Vec2 calc_edge_moment(const EdgeLoad& load, std::size_t k, const Configuration& configuration,
                             double time) {
  const Triad& triad = configuration.triad[static_cast<std::size_t>(load.nodes[k])];
  return load.widths[k] * load.moment(time) * Vec2(triad.v1.z(), triad.v2.z());
}

}  // namespace hydroscope
