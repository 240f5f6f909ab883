// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/equations.h"

#include <cmath>

#include "solver/increment/contact_step.h"
#include "solver/increment/evaluate.h"
#include "solver/loading/pressure.h"

namespace hydroscope {

namespace {

/// Local components of a world vector: T^T r.
Vector to_local(const std::vector<NodeBasis>& bases, const Vector& world) {
  Vector local = world;
  for (std::size_t i = 0; i < bases.size(); ++i) {
    if (bases[i].is_identity()) continue;
    const auto at = static_cast<Eigen::Index>(kDofs * i);
    local.segment<kDofs>(at) = bases[i].transform().transpose() * world.segment<kDofs>(at);
  }
  return local;
}

Vector to_world(const std::vector<NodeBasis>& bases, const Vector& local) {
  Vector world = local;
  for (std::size_t i = 0; i < bases.size(); ++i) {
    if (bases[i].is_identity()) continue;
    const auto at = static_cast<Eigen::Index>(kDofs * i);
    world.segment<kDofs>(at) = bases[i].transform() * local.segment<kDofs>(at);
  }
  return world;
}

Vector without_held(Vector local, const Scratch& s) {
  for (Eigen::Index j = 0; j < local.size(); ++j) {
    if (s.is_held[static_cast<std::size_t>(j)] != 0) local[j] = 0.0;
  }
  return local;
}

double calc_diagonal(const Model& model) { return model.law.sheet.material.youngs_modulus * model.thickness; }

/// What is left of a held row: nothing when eliminated, else the residual with the spring's force.
double calc_spring_force(const NodeBasis& basis, int k, double residual) {
  return basis.is_eliminated(k) ? 0.0 : residual + basis.stiffness(k) * basis.value(k);
}

/// Out-of-balance force in the local bases, without the reactions of what is held.
Vector calc_rest(const Loads& loads, const Scratch& s) {
  Vector local = to_local(s.bases, s.trial.calc_residual(loads));
  for (std::size_t i = 0; i < s.bases.size(); ++i) {
    for (int k = 0; k < s.bases[i].n_held(); ++k) {
      double& r = local[static_cast<Eigen::Index>(kDofs * i) + k];
      r = calc_spring_force(s.bases[i], k, r);
    }
  }
  return local;
}

/// The same in the bases of the factorised matrix; nothing on what is eliminated.
Vector calc_factor_force(const Loads& loads, const Scratch& s) {
  return without_held(to_local(s.factor_bases, calc_unbalanced(loads, s)), s);
}

/// Prescribed values in the order of the local degrees of freedom.
Vector gather_prescribed(const Scratch& s) {
  Vector prescribed = Vector::Zero(s.matrix.size());
  for (std::size_t i = 0; i < s.bases.size(); ++i) {
    for (int k = 0; k < s.bases[i].n_held(); ++k) {
      if (!s.bases[i].is_eliminated(k)) continue;
      prescribed[static_cast<Eigen::Index>(kDofs * i) + k] = s.bases[i].value(k);
    }
  }
  return prescribed;
}

/// K q = force with q given where it is held: by elimination, or by a penalty whose small displacement
/// `penetration` carries the reaction (4.58)-(4.62).
Vector solve_constrained(const Model& model, const Vector& force, const Vector& prescribed, Scratch& s,
                         Vector* penetration) {
  const Vector rest = force - s.matrix.multiply(prescribed);
  if (!model.use_penalty) {
    return s.secant.solve(s.solver, without_held(rest, s) + calc_diagonal(model) * prescribed);
  }
  const Vector x = s.secant.solve(s.solver, rest);
  if (penetration != nullptr) *penetration = x - without_held(x, s);
  return x + prescribed;
}

double calc_force_norm(const Vector& v) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < v.size(); i += kDofs) sum += v.segment<3>(i).squaredNorm();
  return std::sqrt(sum);
}

/// Moments on edges as couples of forces from end to end of the strip [N]. Over the wall's thickness, as
/// residuals count, they would be large beside all forces that bend a long strip.
double calc_moment_load(const Model& model, const Loads& loads) {
  double sum = 0.0;
  for (const EdgeLoad& edge : model.edge_loads) {
    for (const double width : edge.widths) sum += std::pow(width * edge.moment(loads.time) / edge.lever, 2);
  }
  return std::sqrt(sum);
}

}  // namespace

Vector calc_unbalanced(const Loads& loads, const Scratch& s) {
  Vector force = s.trial.calc_residual(loads);
  for (std::size_t i = 0; i < s.bases.size(); ++i) {
    const NodeBasis& basis = s.bases[i];
    for (int k = 0; k < basis.n_held(); ++k) {
      if (basis.is_eliminated(k)) continue;
      force.segment<kDofs>(static_cast<Eigen::Index>(kDofs * i)) +=
          basis.stiffness(k) * basis.value(k) * basis.row(k);
    }
  }
  return force;
}

void start_trial(const State& state, Scratch& s) {
  s.trial.configuration = state.configuration;
  s.trial.contacts = state.contacts;
  for (auto& contacts : s.trial.contacts) {
    for (ContactPoint& c : contacts) {
      c.anchor = c.position;
      c.release = {};
    }
  }
}

void evaluate(const Model& model, const State& state, const Loads& loads, const EvaluationSettings& settings,
              Scratch& s) {
  evaluate_through_wall_stress(model, state, loads, s.trial);
  evaluate_elements(model, state, loads, settings, s);
  evaluate_edge_loads(model, loads, s.trial);
  if (!settings.freeze_thickness) update_thickness(model, s.trial);
  search_contacts(model, loads, s);
}

Imbalance calc_imbalance(const Model& model, const Loads& loads, const Scratch& s) {
  const Vector rest = calc_rest(loads, s);
  double sum = 0.0;
  for (std::size_t i = 0; i < s.bases.size(); ++i) {
    NodeVector r = rest.segment<kDofs>(static_cast<Eigen::Index>(kDofs * i));
    if (s.bases[i].is_identity()) r.tail<2>() /= model.thickness;
    sum += r.squaredNorm();
  }
  double reactions = 0.0;
  for (const Vec3& r : calc_reactions(model, loads, s)) reactions += r.squaredNorm();
  const double reference = std::max({std::abs(loads.pressure) * calc_force_norm(s.trial.pressure_load),
                                     calc_force_norm(s.trial.other_load), calc_moment_load(model, loads),
                                     calc_force_norm(s.trial.normal_reaction), std::sqrt(reactions),
                                     1e-7 * calc_diagonal(model) * model.thickness});
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
  s.factor_bases = s.bases;
  s.secant.clear();
  if (model.use_penalty) {
    s.matrix.penalise(s.is_held, model.contact.penalty, s.values);
  } else {
    s.matrix.eliminate(s.is_held, calc_diagonal(model), s.values);
  }
  s.last_factorisation = s.solver.factorise(s.values);
  s.factorisations += s.last_factorisation.factorisations;
  return s.last_factorisation;
}

double calc_work(const Loads& loads, const Vector& q, const Scratch& s) {
  const Vector rest = calc_rest(loads, s);
  double work = 0.0;
  for (std::size_t i = 0; i < s.bases.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(kDofs * i);
    work += s.bases[i].to_local_displacement(q.segment<kDofs>(at)).dot(rest.segment<kDofs>(at));
  }
  return work;
}

Step make_step(const Loads& loads, const Scratch& s) {
  return {calc_unbalanced(loads, s), gather_prescribed(s)};
}

Solution solve(const Model& model, const Loads& loads, const Step& step, bool use_volume, double volume_gap,
               Scratch& s) {
  const PhaseTimer timer(s.times.solve);
  const Vector force = to_local(s.factor_bases, step.force);
  Solution solution;
  solution.force = without_held(force, s);
  solution.local = solve_constrained(model, force, step.prescribed, s, &solution.penetration);
  solution.q = to_world(s.factor_bases, solution.local);
  if (use_volume) {
    const Vector load = to_local(s.factor_bases, s.trial.pressure_load);
    const Vector per_pressure =
        to_world(s.factor_bases,
                 solve_constrained(model, load, Vector::Zero(load.size()), s, nullptr));  // mechanics 3.4
    solution.compliance = s.trial.pressure_load.dot(per_pressure);
    solution.pressure_change = (volume_gap - s.trial.pressure_load.dot(solution.q)) / solution.compliance;
    solution.q += solution.pressure_change * per_pressure;
  }
  solution.work = calc_work(loads, solution.q, s);
  return solution;
}

Vector calc_held_forces(const Model& model, const Step& step, const Solution& solution, const Scratch& s) {
  Vector forces;
  if (model.use_penalty) {
    forces = -model.contact.penalty * solution.penetration;  // (4.62)
  } else {
    forces = s.matrix.multiply(solution.local) - to_local(s.factor_bases, step.force);
  }
  return forces - without_held(forces, s);
}

bool learn_springs(const std::vector<SpringChange>& changes, Scratch& s) {
  const PhaseTimer timer(s.times.solve);
  for (const SpringChange& change : changes) {
    Vector row = Vector::Zero(s.matrix.size());
    const auto at = static_cast<Eigen::Index>(kDofs * change.node);
    row.segment<kDofs>(at) =
        s.factor_bases[static_cast<std::size_t>(change.node)].transform().transpose() * change.row;
    if (!s.secant.add_spring(s.solver, without_held(row, s), change.stiffness)) return false;
  }
  return true;
}

void learn_step(const Solution& solution, double scale, const Loads& loads, Scratch& s) {
  Vector step = solution.q;
  for (std::size_t i = 0; i < s.factor_bases.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(kDofs * i);
    step.segment<kDofs>(at) = s.factor_bases[i].to_local_displacement(solution.q.segment<kDofs>(at));
  }
  const Vector load = without_held(to_local(s.factor_bases, s.trial.pressure_load), s);
  s.secant.add_step(scale * without_held(step, s),
                    solution.force + scale * solution.pressure_change * load - calc_factor_force(loads, s));
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
