// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/evaluate.h"

#include <algorithm>
#include <cmath>

#include "solver/increment/edge_load.h"
#include "solver/loading/pressure.h"

namespace hydroscope {

namespace {

/// d x_s / d (u, alpha, beta) of the point X + offset V.
Eigen::Matrix<double, 3, kDofs> calc_point_map(const Triad& t, double offset) {
  Eigen::Matrix<double, 3, kDofs> map;
  map << Mat3::Identity(), -offset * t.v2, offset * t.v1;
  return map;
}

/// Load of unit pressure on the chosen surface; p times its stiffness is taken off `stiffness`, if given.
ElementVector add_pressure(const Model& model, const ElementNodes& nodes, double pressure,
                           ElementMatrix* stiffness) {
  std::array<Vec3, 4> x;
  std::array<Eigen::Matrix<double, 3, kDofs>, 4> map;
  std::array<double, 4> offset{};
  for (std::size_t a = 0; a < 4; ++a) {
    offset[a] = model.use_inner_surface ? -0.5 * nodes.thickness[a] : 0.0;
    x[a] = nodes.x[a] + offset[a] * nodes.triad[a].v;
    map[a] = calc_point_map(nodes.triad[a], offset[a]);
  }
  const auto load = calc_pressure_load(x);
  ElementVector f;
  for (std::size_t a = 0; a < 4; ++a) {
    f.segment<kDofs>(static_cast<Eigen::Index>(kDofs * a)) = map[a].transpose() * load[a];
  }
  if (stiffness == nullptr || pressure == 0.0 || !model.use_load_stiffness) return f;
  const auto k = calc_pressure_stiffness(x);
  for (std::size_t a = 0; a < 4; ++a) {
    const auto ia = static_cast<Eigen::Index>(kDofs * a);
    for (std::size_t b = 0; b < 4; ++b) {
      const auto ib = static_cast<Eigen::Index>(kDofs * b);
      if (model.use_inner_surface) {
        stiffness->block<kDofs, kDofs>(ia, ib) -= pressure * (map[a].transpose() * k[a][b] * map[b]);
      } else {
        stiffness->block<3, 3>(ia, ib) -= pressure * k[a][b];
      }
    }
    const double turn = pressure * offset[a] * nodes.triad[a].v.dot(load[a]);
    stiffness->block<2, 2>(ia + 3, ia + 3).diagonal().array() += turn;
  }
  return f;
}

/// Adds up element contributions node by node, always in the same order.
void sum_over_nodes(const Scratch& s, Trial& trial, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end; ++i) {
    NodeVector internal = NodeVector::Zero(), load = NodeVector::Zero();
    double area = 0.0, volume = 0.0;
    for (const auto& [e, a] : s.node_elements[i]) {
      const auto element = static_cast<std::size_t>(e);
      const ElementResponse& r = s.responses[element];
      internal += r.force.segment<kDofs>(kDofs * a);
      load += s.pressure_loads[element].segment<kDofs>(kDofs * a);
      area += r.area[static_cast<std::size_t>(a)];
      volume += r.volume[static_cast<std::size_t>(a)];
    }
    const auto at = static_cast<Eigen::Index>(kDofs * i);
    trial.internal.segment<kDofs>(at) = internal;
    trial.pressure_load.segment<kDofs>(at) = load;
    trial.area[i] = area;
    trial.volume[i] = volume;
  }
}

}  // namespace

Scratch::Scratch(const Model& model, int threads)
    : pool(threads),
      matrix(model.n_nodes(), model.quads),
      solver(matrix, model.curvature == Curvature::kFull) {
  const auto n = static_cast<std::size_t>(model.n_nodes()), n_e = model.quads.size();
  element_matrices.resize(n_e);
  responses.resize(n_e);
  pressure_loads.resize(n_e);
  node_blocks.assign(n, NodeBlock::Zero());
  bases.resize(n);
  is_held.assign(n * kDofs, 0);
  node_elements.resize(n);
  for (std::size_t e = 0; e < n_e; ++e) {
    for (int a = 0; a < 4; ++a) {
      const auto node = static_cast<std::size_t>(model.quads[e][static_cast<std::size_t>(a)]);
      node_elements[node].push_back({static_cast<int>(e), a});
    }
  }
  const auto size = static_cast<Eigen::Index>(kDofs * n);
  for (Vector* v :
       {&trial.internal, &trial.pressure_load, &trial.other_load, &trial.friction, &trial.normal_reaction}) {
    *v = Vector::Zero(size);
  }
  trial.area.assign(n, 0.0);
  trial.volume.assign(n, 0.0);
  trial.wall.assign(n, model.thickness);
}

void evaluate_elements(const Model& model, const State& state, const Loads& loads,
                       const EvaluationSettings& settings, Scratch& s) {
  const PhaseTimer timer(s.times.assemble);
  Trial& trial = s.trial;
  trial.layers.resize(state.layers.size());
  trial.gauss.resize(state.gauss.size());
  const auto n_l = static_cast<std::size_t>(kGaussPoints * model.law.rule.size());
  s.pool.for_ranges(model.quads.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const ElementNodes nodes = gather_nodes(model, trial.configuration, e);
      ElementMatrix* stiffness = settings.with_stiffness ? &s.element_matrices[e] : nullptr;
      ElementSettings element;
      element.assume_flow = settings.assume_flow;
      for (std::size_t a = 0; a < 4; ++a) {
        const auto i = static_cast<std::size_t>(model.quads[e][a]);
        element.sigma33.start[a] = state.sigma33[i];
        element.sigma33.end[a] = trial.sigma33[i];
      }
      s.responses[e] = evaluate_element(model.law, gather_nodes(model, state.configuration, e), nodes,
                                        {std::span(state.layers).subspan(e * n_l, n_l),
                                         std::span(state.gauss).subspan(e * kGaussPoints, kGaussPoints)},
                                        element,
                                        {std::span(trial.layers).subspan(e * n_l, n_l),
                                         std::span(trial.gauss).subspan(e * kGaussPoints, kGaussPoints)},
                                        stiffness);
      s.pressure_loads[e] = add_pressure(model, nodes, loads.pressure, stiffness);
    }
  });
  s.pool.for_ranges(static_cast<std::size_t>(model.n_nodes()),
                    [&](std::size_t begin, std::size_t end) { sum_over_nodes(s, trial, begin, end); });
  trial.strain_increment = trial.plastic_increment = 0.0;
  trial.elastic_share = 1.0;
  for (std::size_t e = 0; e < s.responses.size(); ++e) {
    if (s.responses[e].strain_increment > trial.strain_increment) {
      trial.strain_increment = s.responses[e].strain_increment;
      trial.strain_at = static_cast<int>(e);
    }
    if (s.responses[e].elastic_share < trial.elastic_share) {
      trial.elastic_share = s.responses[e].elastic_share;
      trial.yield_at = static_cast<int>(e);
    }
    trial.plastic_increment = std::max(trial.plastic_increment, s.responses[e].plastic_increment);
  }
}

std::vector<double> calc_nodal_areas(const Model& model, const Configuration& configuration) {
  std::vector<double> areas(configuration.x.size(), 0.0);
  for (std::size_t e = 0; e < model.quads.size(); ++e) {
    const auto& quad = model.quads[e];
    for (int g = 0; g < kGaussPoints; ++g) {
      const Vec2 at = gauss_point(g);
      const ShapeFunctions s = calc_shape_functions(at[0], at[1]);
      Vec3 g1 = Vec3::Zero(), g2 = Vec3::Zero();
      for (std::size_t a = 0; a < 4; ++a) {
        const Vec3& x = configuration.x[static_cast<std::size_t>(quad[a])];
        g1 += s.n1[a] * x;
        g2 += s.n2[a] * x;
      }
      const double area = g1.cross(g2).norm();
      for (std::size_t a = 0; a < 4; ++a) areas[static_cast<std::size_t>(quad[a])] += s.n[a] * area;
    }
  }
  return areas;
}

void smooth_over_wall(const Model& model, double length, std::vector<double>& values) {
  // One pass (node to element to node) spreads by half an element's length squared.
  const double ratio = length / model.element_size;
  const int passes = std::min(30, static_cast<int>(std::lround(2.0 * ratio * ratio)));
  std::vector<double> sum(values.size()), count(values.size());
  for (int pass = 0; pass < passes; ++pass) {
    std::fill(sum.begin(), sum.end(), 0.0);
    std::fill(count.begin(), count.end(), 0.0);
    for (const auto& quad : model.quads) {
      double mean = 0.0;
      for (const int i : quad) mean += 0.25 * values[static_cast<std::size_t>(i)];
      for (const int i : quad) {
        sum[static_cast<std::size_t>(i)] += mean;
        count[static_cast<std::size_t>(i)] += 1.0;
      }
    }
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = sum[i] / count[i];
  }
}

void update_thickness(const Model& model, Trial& trial) {
  for (std::size_t i = 0; i < trial.wall.size(); ++i) trial.wall[i] = trial.volume[i] / trial.area[i];
  trial.configuration.thickness = trial.wall;
  smooth_over_wall(model, 0.5 * model.thickness, trial.configuration.thickness);
}

void evaluate_edge_loads(const Model& model, const Loads& loads, Trial& trial) {
  trial.other_load.setZero();
  for (const EdgeLoad& edge : model.edge_loads) {
    for (std::size_t k = 0; k < edge.nodes.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(kDofs * edge.nodes[k]);
      trial.other_load.segment<3>(at) += calc_edge_load(edge, k, trial.configuration, loads.time);
      trial.other_load.segment<2>(at + 3) += calc_edge_moment(edge, k, trial.configuration, loads.time);
    }
  }
}

void evaluate_through_wall_stress(const Model& model, const State& state, const Loads& loads, Trial& trial) {
  trial.sigma33.assign(state.sigma33.size(), 0.0);
  if (!model.use_through_wall_stress) return;
  const double share =
      state.last_dt > 0.0 ? std::clamp((loads.time - state.time) / state.last_dt, 0.0, 1.0) : 0.0;
  for (std::size_t i = 0; i < trial.sigma33.size(); ++i) {
    const double applied = -2.0 * state.sigma33[i] - state.pressure;
    trial.sigma33[i] = -0.5 * (loads.pressure + applied + share * (state.outer_pressure[i] - applied));
  }
}

void assemble_matrix(const Model& model, Scratch& s) {
  const PhaseTimer timer(s.times.assemble);
  s.pool.for_ranges(model.quads.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      ElementMatrix& k = s.element_matrices[e];
      for (std::size_t a = 0; a < 4; ++a) {
        const NodeBasis& basis = s.bases[static_cast<std::size_t>(model.quads[e][a])];
        if (basis.is_identity()) continue;
        const auto at = static_cast<Eigen::Index>(kDofs * a);
        k.middleRows<kDofs>(at) = (basis.transform().transpose() * k.middleRows<kDofs>(at)).eval();
        k.middleCols<kDofs>(at) = (k.middleCols<kDofs>(at) * basis.transform()).eval();
      }
    }
  });
  s.pool.for_ranges(static_cast<std::size_t>(model.n_nodes()), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (s.bases[i].is_identity()) continue;
      const NodeBasis& basis = s.bases[i];
      s.node_blocks[i] = (basis.transform().transpose() * s.node_blocks[i] * basis.transform()).eval();
      for (int k = 0; k < basis.n_held(); ++k) {
        if (!basis.is_eliminated(k)) s.node_blocks[i](k, k) += basis.stiffness(k);  // (4.59)
      }
    }
    s.matrix.assemble(s.element_matrices, s.node_blocks, begin, end);
  });
}

}  // namespace hydroscope
