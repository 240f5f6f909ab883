// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/system/linear_solver.h"

namespace hydroscope {

/// What is known about the matrix beyond its factor: springs added or taken away since (exactly, by
/// the Sherman-Morrison formula), and what the steps since have taught (inverse BFGS updates by the two-loop
/// recursion, Matthies & Strang 1979, Nocedal 1980). Each costs one solve instead of a factorisation.
class SecantUpdates {
 public:
  void clear();
  int n_steps() const { return static_cast<int>(steps_.size()); }
  int n_springs() const { return static_cast<int>(springs_.size()); }

  /// Adds stiffness * row row^T to the matrix and forgets the steps before. False, and nothing is
  /// done, when that would make it singular.
  bool add_spring(const LinearSolver& solver, const Vector& row, double stiffness);

  /// A step `delta` that has changed the out-of-balance force by -`gamma`. Left out when its curvature is not
  /// clearly positive: the inverse stays positive definite.
  void add_step(const Vector& delta, const Vector& gamma);

  /// About K^-1 rhs.
  Vector solve(const LinearSolver& solver, Vector rhs) const;

 private:
  struct Spring {
    Vector row, response;  ///< c and K^-1 c
    double weight;         ///< 1 / (1/k + c . K^-1 c)
  };
  struct Step {
    Vector delta, gamma;
    double curvature;  ///< 1 / (gamma . delta)
  };
  Vector solve_with_springs(const LinearSolver& solver, const Vector& rhs) const;
  std::vector<Spring> springs_;
  std::vector<Step> steps_;
};

}  // namespace hydroscope
