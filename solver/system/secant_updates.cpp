// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/system/secant_updates.h"

namespace hydroscope {

void SecantUpdates::clear() {
  springs_.clear();
  steps_.clear();
}

Vector SecantUpdates::solve_with_springs(const LinearSolver& solver, const Vector& rhs) const {
  Vector x = solver.solve(rhs);
  for (const Spring& s : springs_) x -= s.weight * s.row.dot(x) * s.response;
  return x;
}

bool SecantUpdates::add_spring(const LinearSolver& solver, const Vector& row, double stiffness) {
  constexpr double kSingular = 1e-8;
  const Vector response = solve_with_springs(solver, row);
  const double compliance = row.dot(response);
  const double pivot = 1.0 + stiffness * compliance;  // of the bordered matrix; <= 0: no longer definite
  if (!(pivot > kSingular)) return false;
  steps_.clear();
  springs_.push_back({row, response, stiffness / pivot});
  return true;
}

void SecantUpdates::add_step(const Vector& delta, const Vector& gamma) {
  constexpr double kSmallest = 1e-10;  // cosine between step and change of force
  const double product = delta.dot(gamma);
  if (!(product > kSmallest * delta.norm() * gamma.norm())) return;
  steps_.push_back({delta, gamma, 1.0 / product});
}

Vector SecantUpdates::solve(const LinearSolver& solver, Vector rhs) const {
  std::vector<double> weights(steps_.size());
  for (std::size_t k = steps_.size(); k-- > 0;) {
    weights[k] = steps_[k].curvature * steps_[k].delta.dot(rhs);
    rhs -= weights[k] * steps_[k].gamma;
  }
  Vector x = solve_with_springs(solver, rhs);
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    x += (weights[k] - steps_[k].curvature * steps_[k].gamma.dot(x)) * steps_[k].delta;
  }
  return x;
}

}  // namespace hydroscope
