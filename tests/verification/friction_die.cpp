// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/friction_die.h"

#include <chrono>
#include <cmath>

#include "tests/verification/run_scene.h"

namespace hydroscope::verification {

namespace {

constexpr double kR0 = 30.0, kT0 = 0.3;

History run_die(const FrictionCase& wanted) {
  std::vector<std::string> keys = {
      "tube.elements_around=" + std::to_string(wanted.elements),
      "tool.die.friction=" + std::to_string(wanted.friction),
      "material.youngs_modulus_MPa=" + std::to_string(wanted.metal.youngs_modulus),
      "material.swift_K_MPa=" + std::to_string(wanted.metal.k),
      "material.swift_eps0=" + std::to_string(wanted.metal.eps0),
      "material.swift_n=" + std::to_string(wanted.metal.n),
      "stop.quantity=rho_mm",
      "stop.below=" + std::to_string(wanted.last_rho),
  };
  keys.insert(keys.end(), wanted.settings.begin(), wanted.settings.end());
  return run_scene("square-die-thin.toml", keys);
}

/// Thickness along the wall: nodes of one edge of the slice, from the middle of the flat to the corner.
void compare_profile(const Snapshot& end, const FrictionWall& wall, FrictionComparison& c) {
  const CornerState& wanted = wall.nearest(c.end_rho);
  const std::size_t nodes = end.points.size() / 2;
  double x = 0.0;
  int touching = 0, sticking = 0;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (i > 0) x += (end.points[i] - end.points[i - 1]).norm();
    std::size_t k = 1;
    while (k + 1 < wanted.position.size() && wanted.position[k] < x) ++k;
    const double share = (x - wanted.position[k - 1]) / (wanted.position[k] - wanted.position[k - 1]);
    const double t = wanted.thickness[k - 1] + share * (wanted.thickness[k] - wanted.thickness[k - 1]);
    const double error = relative_error(end.thickness[i], t);
    if (error > c.profile_error) {
      c.profile_error = error;
      c.profile_place = x;
    }
    touching += end.contact_state[i] != ContactClass::kFree ? 1 : 0;
    sticking += end.contact_state[i] == ContactClass::kStick ? 1 : 0;
  }
  c.sticking_share = touching > 0 ? static_cast<double>(sticking) / touching : 0.0;
}

}  // namespace

FrictionCase make_friction_case(const std::string& material, double friction, int elements) {
  FrictionCase c{material, kM2, friction, 9.0, elements};
  if (material != "M1") return c;
  c.metal = kM1;
  c.last_rho = 1.01 * FrictionWall(kM1, {kR0, kT0, friction}, 9.0, 200, 400).last_radius();
  c.settings = {"load.control=volume", "load.volume_ratio=[[0, 1], [1, 1.25]]"};
  return c;
}

FrictionComparison compare_friction(const FrictionCase& wanted, const std::vector<double>& radii) {
  // 200 pieces and 400 steps: 800 and 1600 give the same figures to 1e-4 (FrictionWall.HasConverged).
  const FrictionWall wall(wanted.metal, {kR0, kT0, wanted.friction}, 9.0, 200, 400);
  const auto start = std::chrono::steady_clock::now();
  const History h = run_die(wanted);
  FrictionComparison c;
  c.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  c.increments = static_cast<int>(h.rows.size());
  if (h.summary.outcome != Outcome::kCompleted) c.message = h.summary.message;
  c.neck_rho = wall.last_radius();
  c.end_rho = h.column("rho_mm").back();
  for (const double rho : radii) {
    if (rho < wall.last_radius()) continue;
    const CornerState s = wall.at(rho);
    c.rows.push_back({rho, h.value_at("pressure", "rho_mm", rho), s.pressure,
                      h.value_at("t_corner_mm", "rho_mm", rho), s.corner_thickness});
  }
  compare_profile(*h.states.back(), wall, c);
  return c;
}

}  // namespace hydroscope::verification
