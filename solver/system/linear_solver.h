// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "solver/system/block_matrix.h"

namespace hydroscope {

class UnsymmetricSolver;

/// Result of a numeric factorisation.
struct Factorisation {
  bool is_usable = false;       ///< false: exactly singular
  int negative_pivots = 0;      ///< of D in L D L^T (method section 6)
  double smallest_pivot = 0.0;  ///< in absolute value, relative to the largest
  int factorisations = 0;       ///< 1, or 2 when the supernodal one had to stop
};

/// Sparse symmetric direct solver: one symbolic analysis, then supernodal
/// L L^T while the matrix is positive definite; when that stops at a pivot <= 0,
/// simplicial L D L^T of the same matrix, whose signs are counted. CHOLMOD
/// (Chen, Davis, Hager & Rajamanickam 2008) behind one class.
///
/// With `is_unsymmetric` the diagonal node blocks count whole (K_C is unsymmetric), and UMFPACK (Davis
/// 2004) factorises; of the signs of its pivots only their product is known.
class LinearSolver {
 public:
  explicit LinearSolver(const BlockMatrix& pattern, bool is_unsymmetric = false);
  ~LinearSolver();
  LinearSolver(const LinearSolver&) = delete;
  LinearSolver& operator=(const LinearSolver&) = delete;

  /// Factorises the matrix with the pattern's structure and these values.
  Factorisation factorise(const std::vector<double>& values);
  /// Solves for one right-hand side; factorise() must have been usable.
  Vector solve(const Vector& rhs) const;
  /// Entries of the supernodal factor.
  double factor_entries() const;
  bool is_unsymmetric() const { return unsymmetric_ != nullptr; }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::unique_ptr<UnsymmetricSolver> unsymmetric_;
};

/// BLAS threads are fixed for the whole program, whatever --threads says, so
/// that sums are always taken in the same order; CHOLMOD's own parallel regions are switched off with one
/// thread (on the calling thread).
void fix_blas_threads(int threads);

}  // namespace hydroscope
