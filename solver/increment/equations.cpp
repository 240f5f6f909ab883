// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/equations.h"

#include <cmath>

#include "solver/increment/contact_step.h"
#include "solver/increment/evaluate.h"
#include "solver/loading/pressure.h"

namespace hydroscope {

namespace {

/// Local components of a world vector: T^T r.
Vector to_local(const Scratch& s, const Vector& world) {
  Vector local = world;
  for (std::size_t i = 0; i < s.bases.size(); ++i) {
    if (s.bases[i].is_identity()) continue;
    const auto at = static_cast<Eigen::Index>(kDofs * i);
    local.segment<kDofs>(at) = s.bases[i].transform().transpose() * world.segment<kDofs>(at);
  }
  return local;
}

Vector to_world(const Scratch& s, const Vector& local) {
  Vector world = local;
  for (std::size_t i = 0; i < s.bases.size(); ++i) {
    if (s.bases[i].is_identity()) continue;
    const auto at = static_cast<Eigen::Index>(kDofs * i);
    world.segment<kDofs>(at) = s.bases[i].transform() * local.segment<kDofs>(at);
  }
  return world;
}

double calc_diagonal(const Model& model) { return model.law.sheet.material.youngs_modulus * model.thickness; }

/// What is left of a held row: nothing when eliminated, else the residual with the spring's force.
double calc_spring_force(const NodeBasis& basis, int k, double residual) {
  return basis.is_eliminated(k) ? 0.0 : residual + basis.stiffness(k) * basis.value(k);
}

double calc_force_norm(const Vector& v) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < v.size(); i += kDofs) sum += v.segment<3>(i).squaredNorm();
  return std::sqrt(sum);
}

}  // namespace

void start_trial(const State& state, Scratch& s) {
  s.trial.configuration = state.configuration;
  s.trial.contacts = state.contacts;
  for (auto& contacts : s.trial.contacts) {
    for (ContactPoint& c : contacts) c.anchor = c.position;
  }
}

void evaluate(const Model& model, const State& state, const Loads& loads, const EvaluationSettings& settings,
              Scratch& s) {
  evaluate_through_wall_stress(model, state, loads, s.trial);
  evaluate_elements(model, state, loads, settings.assume_flow, s);
  evaluate_edge_loads(model, loads, s.trial);
  if (!settings.freeze_thickness) update_thickness(model, s.trial);
  search_contacts(model, loads, s);
}

Imbalance calc_imbalance(const Model& model, const Loads& loads, const Scratch& s) {
  const Vector residual = s.trial.calc_residual(loads);
  const Vector local = to_local(s, residual);
  double sum = 0.0;
  for (std::size_t i = 0; i < s.bases.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(kDofs * i);
    NodeVector r = local.segment<kDofs>(at);
    for (int k = 0; k < s.bases[i].n_held(); ++k) r[k] = calc_spring_force(s.bases[i], k, r[k]);
    if (s.bases[i].is_identity()) r.tail<2>() /= model.thickness;
    sum += r.squaredNorm();
  }
  double reactions = 0.0;
  for (const Vec3& r : calc_reactions(model, loads, s)) reactions += r.squaredNorm();
  const double reference =
      std::max({std::abs(loads.pressure) * calc_force_norm(s.trial.pressure_load),
                calc_force_norm(s.trial.other_load), calc_force_norm(s.trial.normal_reaction),
                std::sqrt(reactions), 1e-9 * calc_diagonal(model) * model.thickness});
  return {std::sqrt(sum) / reference, reference};
}

Factorisation factorise(const Model& model, Scratch& s) {
  const PhaseTimer timer(s.times.factorise);
  for (std::size_t i = 0; i < s.bases.size(); ++i) {
    for (int k = 0; k < kDofs; ++k) {
      s.is_held[kDofs * i + static_cast<std::size_t>(k)] =
          (k < s.bases[i].n_held() && s.bases[i].is_eliminated(k)) ? 1 : 0;
    }
  }
  s.matrix.eliminate(s.is_held, calc_diagonal(model), s.values);
  s.last_factorisation = s.solver.factorise(s.values);
  s.factorisations += s.last_factorisation.factorisations;
  return s.last_factorisation;
}

Solution solve(const Model& model, const Loads& loads, bool use_volume, double volume_gap, Scratch& s) {
  const PhaseTimer timer(s.times.solve);
  const double diagonal = calc_diagonal(model);
  Vector prescribed = Vector::Zero(s.matrix.size()), springs = prescribed;
  for (std::size_t i = 0; i < s.bases.size(); ++i) {
    for (int k = 0; k < s.bases[i].n_held(); ++k) {
      const auto at = static_cast<Eigen::Index>(kDofs * i) + k;
      const double value = s.bases[i].value(k);
      (s.bases[i].is_eliminated(k) ? prescribed[at] : springs[at]) =
          s.bases[i].is_eliminated(k) ? value : s.bases[i].stiffness(k) * value;
    }
  }
  Vector rhs = to_local(s, s.trial.calc_residual(loads)) + springs - s.matrix.multiply(prescribed);  // (4.58)
  Vector load = to_local(s, s.trial.pressure_load);
  for (Eigen::Index j = 0; j < rhs.size(); ++j) {
    if (s.is_held[static_cast<std::size_t>(j)] == 0) continue;
    rhs[j] = diagonal * prescribed[j];
    load[j] = 0.0;
  }
  Solution solution;
  solution.q = to_world(s, s.solver.solve(rhs));
  if (!use_volume) return solution;
  const Vector per_pressure = to_world(s, s.solver.solve(load));  // mechanics 3.4
  solution.compliance = s.trial.pressure_load.dot(per_pressure);
  solution.pressure_change = (volume_gap - s.trial.pressure_load.dot(solution.q)) / solution.compliance;
  solution.q += solution.pressure_change * per_pressure;
  return solution;
}

double calc_volume(const Model& model, const State& state, const Scratch& s) {
  double swept = 0.0;
  const auto surface = [&](const Configuration& c, std::size_t i) -> Vec3 {
    return c.x[i] - (model.use_inner_surface ? 0.5 * c.thickness[i] : 0.0) * c.triad[i].v;
  };
  for (const auto& quad : model.quads) {
    std::array<Vec3, 4> middle, step;
    for (std::size_t a = 0; a < 4; ++a) {
      const auto i = static_cast<std::size_t>(quad[a]);
      const Vec3 from = surface(state.configuration, i), to = surface(s.trial.configuration, i);
      middle[a] = 0.5 * (from + to);
      step[a] = to - from;
    }
    const auto load = calc_pressure_load(middle);
    for (std::size_t a = 0; a < 4; ++a) swept += load[a].dot(step[a]);
  }
  return state.volume + swept;
}

std::vector<Vec3> calc_reactions(const Model& model, const Loads& loads, const Scratch& s) {
  std::vector<Vec3> reactions(model.x0.size(), Vec3::Zero());
  const Vector residual = s.trial.calc_residual(loads) + s.trial.normal_reaction;
  for (std::size_t i = 0; i < reactions.size(); ++i) {
    if (!model.supports[i].empty()) {
      reactions[i] = -residual.segment<3>(static_cast<Eigen::Index>(kDofs * i));
    }
  }
  return reactions;
}

}  // namespace hydroscope
