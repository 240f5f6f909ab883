// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/system/linear_solver.h"

namespace hydroscope {

/// Sparse L U of a matrix whose off-diagonal node blocks are symmetric and whose diagonal ones need not be:
/// UMFPACK (Davis 2004) behind one class.
class UnsymmetricSolver {
 public:
  explicit UnsymmetricSolver(const BlockMatrix& pattern);
  ~UnsymmetricSolver();
  UnsymmetricSolver(const UnsymmetricSolver&) = delete;
  UnsymmetricSolver& operator=(const UnsymmetricSolver&) = delete;

  /// `values` in the pattern's order (lower block triangle, diagonal blocks whole). `negative_pivots` is 1
  /// when the determinant is negative, else 0.
  Factorisation factorise(const std::vector<double>& values);
  Vector solve(const Vector& rhs) const;
  double factor_entries() const;

 private:
  std::vector<int> starts_, rows_, sources_;  ///< whole pattern, and where each entry's value stands
  std::vector<double> values_;
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
};

}  // namespace hydroscope
