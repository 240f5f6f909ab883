// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/increment/edge_load.h"
#include "solver/increment/measures.h"
#include "solver/increment/release.h"

namespace hydroscope {

namespace {

template <typename Value>
double interpolate(const Quantity& q, Value value) {
  double sum = 0.0;
  for (std::size_t k = 0; k < q.nodes.size(); ++k)
    sum += q.weights[k] * value(static_cast<std::size_t>(q.nodes[k]));
  return sum;
}

/// Distance from the axis of a face of the wall [mm].
double calc_radius(const State& state, const std::string& face, std::size_t i) {
  const Configuration& c = state.configuration;
  const double side = face == "outer" ? 0.5 : (face == "inner" ? -0.5 : 0.0);
  const Vec3 x = c.x[i] + side * c.thickness[i] * c.triad[i].v;
  return std::hypot(x[0], x[1]);
}

/// Radius of the circle that fits the nodes best in the x-y plane (Kåsa's linear fit) [mm].
double fit_circle(const State& state, const std::vector<int>& nodes) {
  Vec3 centre = Vec3::Zero();
  for (const int i : nodes) centre += state.configuration.x[static_cast<std::size_t>(i)];
  centre /= static_cast<double>(nodes.size());
  Mat3 a = Mat3::Zero();
  Vec3 b = Vec3::Zero();
  for (const int i : nodes) {
    const Vec3 x = state.configuration.x[static_cast<std::size_t>(i)] - centre;
    const Vec3 row(2.0 * x[0], 2.0 * x[1], 1.0);
    a += row * row.transpose();
    b += row * (x[0] * x[0] + x[1] * x[1]);
  }
  const Vec3 s = a.ldlt().solve(b);
  return std::sqrt(std::max(0.0, s[2] + s[0] * s[0] + s[1] * s[1]));
}

double sum_contact_force(const Model& model, const State& state, const Quantity& q) {
  double sum = 0.0;
  const auto& contacts = state.contacts[static_cast<std::size_t>(q.tool)];
  for (const int i : q.nodes) sum += contacts[static_cast<std::size_t>(i)].normal_force;
  return sum / model.slice_width;
}

/// What pulls at an edge, per width: the reactions of its supports and the line loads on it [N/mm].
double sum_edge_force(const Model& model, const State& state, const Quantity& q) {
  Vec3 sum = Vec3::Zero();
  for (const int i : q.nodes) sum += state.reaction[static_cast<std::size_t>(i)];
  for (const EdgeLoad& load : model.edge_loads) {
    for (std::size_t k = 0; k < load.nodes.size(); ++k) {
      if (std::find(q.nodes.begin(), q.nodes.end(), load.nodes[k]) == q.nodes.end()) continue;
      sum += calc_edge_load(load, k, state.configuration, state.time);
    }
  }
  return sum.norm() / model.slice_width;
}

/// Bending moment per width at a Gauss point, of the stress along base vector g_1, positive when it
/// pulls at the outer face: the integral of sigma z dz over the wall [N].
double calc_bending_moment(const Model& model, const State& state, std::size_t element, std::size_t gauss) {
  const ThicknessRule& rule = model.law.rule;
  const auto n_z = static_cast<std::size_t>(rule.size());
  const LayerState* layers = &state.layers[(element * kGaussPoints + gauss) * n_z];
  double h = 0.0, sum = 0.0;
  for (const int i : model.quads[element])
    h += 0.25 * state.configuration.thickness[static_cast<std::size_t>(i)];
  for (std::size_t k = 0; k < n_z; ++k) {
    // The material frame stands at `angle` from g_1.
    const double c = std::cos(layers[k].angle), s = std::sin(layers[k].angle);
    const Vec3& sigma = layers[k].point.stress;
    const double along = c * c * sigma[0] + s * s * sigma[1] - 2.0 * c * s * sigma[2];
    sum += rule.weight[k] * rule.zeta[k] * along;
  }
  return 0.5 * h * h * sum;
}

double average_bending_moment(const Model& model, const State& state, const Quantity& q) {
  double sum = 0.0;
  for (const int e : q.elements) {
    for (std::size_t g = 0; g < kGaussPoints; ++g) {
      sum += calc_bending_moment(model, state, static_cast<std::size_t>(e), g);
    }
  }
  return sum / (kGaussPoints * static_cast<double>(q.elements.size()));
}

/// Highest smoothed pressure of any tool at a node [MPa].
double calc_contact_pressure(const Model& model, const State& state, std::size_t i) {
  double pressure = 0.0;
  for (const auto& contacts : state.contacts) {
    if (contacts[i].is_active()) {
      pressure = std::max(pressure, calc_smoothed_pressure(model, contacts, state.area, static_cast<int>(i)));
    }
  }
  return pressure;
}

}  // namespace

double evaluate_quantity(const Model& model, const State& state, const Quantity& q,
                         const std::vector<double>& before) {
  const std::string& kind = q.scene.kind;
  if (kind == "thickness") {
    return interpolate(q, [&](std::size_t i) { return state.wall[i]; });
  }
  if (kind == "radius") {
    return interpolate(q, [&](std::size_t i) { return calc_radius(state, q.scene.face, i); });
  }
  if (kind == "corner_radius") {  // from the outer face on the 45 degree line
    const double distance = interpolate(q, [&](std::size_t i) { return calc_radius(state, "outer", i); });
    return (std::numbers::sqrt2 * q.scene.half_width - distance) / (std::numbers::sqrt2 - 1.0);
  }
  if (kind == "contact_pressure") {
    return interpolate(q, [&](std::size_t i) { return calc_contact_pressure(model, state, i); });
  }
  if (kind == "contact_force") return sum_contact_force(model, state, q);
  if (kind == "bend_radius") return fit_circle(state, q.nodes);
  if (kind == "bending_moment") return average_bending_moment(model, state, q);
  if (kind == "edge_force") return sum_edge_force(model, state, q);
  if (kind == "volume") return state.volume;
  const auto value = [&](std::size_t k) { return before[static_cast<std::size_t>(q.of[k])]; };
  if (kind == "sum") {
    double sum = 0.0;
    for (std::size_t k = 0; k < q.of.size(); ++k) sum += q.scene.factors[k] * value(k);
    return sum;
  }
  if (kind == "ratio") return value(0) / value(1);
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace hydroscope
