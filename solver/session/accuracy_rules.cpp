// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/accuracy_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hydroscope {
namespace {

// Error of a quantity = constant * (element / least radius)^2.
constexpr double kShape = 0.3, kContact = 0.8, kEdge = 0.1;  // thickness and radii; contact; forces of edges
constexpr double kFilledShape = 0.1;                         // of a wall that fills the tool's own fillet
constexpr double kMoment = 32.0, kCoarseMoment = 0.6;        // the second linear, for coarse meshes
constexpr double kCoarsest = 0.5, kCoarsestStrip = 0.18;     // [rad]: coarser meshes lose the arc itself
constexpr double kEndLayer = 0.02;                           // error over (element * lambda)^2 at a held end

/// Flow stress after a typical strain of forming [MPa]; 0 of an elastic sheet.
double find_flow_stress(const MaterialScene& m) {
  constexpr double kStrain = 0.2;
  if (m.hardening == "swift") return m.swift_k * std::pow(m.swift_eps0 + kStrain, m.swift_n);
  if (m.hardening == "voce") return m.yield_stress + m.voce_q * (1.0 - std::exp(-m.voce_b * kStrain));
  if (m.hardening == "perfect") return m.yield_stress;
  if (m.hardening != "table") return 0.0;
  double stress = m.table.front()[1];
  for (const auto& [strain, value] : m.table) {
    if (strain <= kStrain) stress = value;
  }
  return stress;
}

/// Radius that the highest pressure can bend the wall to [mm]; 0 where it cannot be told.
double find_pressure_radius(const Scene& scene) {
  constexpr double kThinned = 0.85;
  const auto& values = scene.load.pressure.values;
  if (scene.load.control != "pressure" || values.empty()) return 0.0;
  const double highest = *std::max_element(values.begin(), values.end());
  if (highest <= 0.0) return 0.0;
  const double stress = 2.0 / std::numbers::sqrt3 * find_flow_stress(scene.material);
  return stress * kThinned * find_thickness(scene) / highest;
}

/// Of the sheet's mid-surface on the tool [mm].
double find_tool_radius(const ToolScene& tool, const MeshFacts* facts, double half_wall) {
  const double wall = tool.side == "outside" ? half_wall : -half_wall;
  if (tool.shape == "box") return tool.corner_radius + wall;
  if (tool.shape == "cylinder") return tool.radius + wall;
  if (tool.shape == "torus") return tool.minor_radius + half_wall;  // a ring, or the fillet between two tools
  if (tool.known_radius > 0.0) return tool.known_radius;
  return facts != nullptr ? facts->least_radius : std::numeric_limits<double>::infinity();
}

void add_demand(const Scene& scene, const QuantityScene& q, double shape, double& constant) {
  if (q.kind == "contact_force" || q.kind == "contact_pressure") constant = std::max(constant, kContact);
  if (q.kind == "edge_force") constant = std::max(constant, kEdge);
  if (q.kind != "edge_force" && q.kind != "sum" && q.kind != "ratio") constant = std::max(constant, shape);
  for (const std::string& name : q.of) add_demand(scene, scene.quantities.at(name), shape, constant);
}

}  // namespace

double find_thickness(const Scene& scene) {
  if (scene.sheet == "tube") return scene.tube.thickness;
  return scene.sheet == "strip" ? scene.strip.thickness : scene.mesh.thickness;
}

LeastRadius find_least_radius(const Scene& scene, const std::map<std::string, MeshFacts>& facts) {
  const bool is_tube = scene.sheet == "tube";
  LeastRadius least{is_tube ? scene.tube.radius : std::numeric_limits<double>::infinity(),
                    "of the tube itself"};
  if (!is_tube && scene.strip.arc_angle > 0.0) least = {scene.strip.arc_radius, "of the strip's own arc"};
  constexpr double kCaution = 0.8;
  const double free = find_pressure_radius(scene), floor = kCaution * free;
  for (const auto& [name, tool] : scene.tools) {
    const auto found = facts.find(name);
    const double radius =
        find_tool_radius(tool, found != facts.end() ? &found->second : nullptr, 0.5 * find_thickness(scene));
    if (radius < least.value) least = {radius, "on tool '" + name + "'", free > 0.0 && radius >= 0.95 * free};
  }
  if (is_tube && least.value < floor && least.value < scene.tube.radius)
    least = {std::min(floor, scene.tube.radius), "that the highest pressure can bend the wall to"};
  least.value = std::max(least.value, find_thickness(scene));
  return least;
}

bool asks_for_bending(const Scene& scene) {
  return std::any_of(scene.quantities.begin(), scene.quantities.end(), [](const auto& item) {
    return item.second.kind == "bending_moment" || item.second.kind == "bend_radius";
  });
}

bool asks_for_contact(const Scene& scene) {
  return std::any_of(scene.quantities.begin(), scene.quantities.end(), [](const auto& item) {
    return item.second.kind == "contact_force" || item.second.kind == "contact_pressure";
  });
}

double find_element_ratio(const Scene& scene, bool is_filled) {
  if (asks_for_bending(scene))
    return std::max(std::sqrt(scene.accuracy / kMoment), scene.accuracy / kCoarseMoment);
  constexpr double kFine = 0.005;  // below, what came before the fillet was full counts
  const double shape = is_filled && scene.accuracy >= kFine ? kFilledShape : kShape;
  double constant = scene.quantities.empty() ? shape : 0.0;
  for (const auto& [name, q] : scene.quantities) add_demand(scene, q, shape, constant);
  return std::min(std::sqrt(scene.accuracy / constant), scene.sheet == "strip" ? kCoarsestStrip : kCoarsest);
}

int count_graded_rows(double accuracy, double half_length, double radius, double thickness) {
  constexpr double kMean = 2.6;  // mean element over the one at the end, with sizes as 2 : 1.5 : 0.5
  constexpr int kFewest = 6;
  const double lambda = 1.285 / std::sqrt(radius * thickness);
  const double end = std::min(1.0, std::sqrt(accuracy / kEndLayer)) / lambda;
  return std::max(kFewest, static_cast<int>(std::ceil(half_length / (kMean * end))));
}

IncrementRule find_increment_rule(const Scene& scene) {
  IncrementRule rule;
  const bool has_contact = asks_for_contact(scene);
  rule.tolerance = std::clamp((has_contact ? 0.03 : 0.1) * scene.accuracy, 3e-5, 5e-3);
  if (scene.sheet == "tube" && scene.tube.section == "sector") rule.tolerance *= 0.1;  // all nodes err alike
  rule.largest = has_contact ? std::clamp(5.0 * scene.accuracy, 0.02, 0.1)
                             : std::clamp(10.0 * scene.accuracy, 0.05, 0.1);
  if (asks_for_bending(scene)) rule.largest = 0.01;
  rule.max_strain = std::clamp(1.5 * rule.largest, 0.03, 0.1);
  return rule;
}

ThicknessChoice find_thickness_points(const Scene& scene) {
  if (asks_for_bending(scene)) {
    const int points = scene.accuracy >= 0.02 ? 4 : (scene.accuracy >= 0.005 ? 6 : 10);
    return {points, "split_gauss", "bending asks for each half of the wall by itself"};
  }
  const int points = scene.accuracy >= 0.02 ? 3 : 5;
  return {points, "gauss", "a wall that is stretched more than bent"};
}

}  // namespace hydroscope
