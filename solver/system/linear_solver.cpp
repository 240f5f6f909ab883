// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/system/linear_solver.h"

#include <cholmod.h>
#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "solver/base/error.h"
#include "solver/system/unsymmetric_solver.h"

extern "C" void openblas_set_num_threads(int);

namespace hydroscope {

struct LinearSolver::Impl {
  cholmod_common common{};
  cholmod_sparse matrix{};
  std::vector<int> starts, rows;
  std::vector<double> values;
  cholmod_factor* supernodal = nullptr;
  cholmod_factor* simplicial = nullptr;
  bool use_simplicial = false;

  ~Impl() {
    cholmod_free_factor(&supernodal, &common);
    cholmod_free_factor(&simplicial, &common);
    cholmod_finish(&common);
  }

  cholmod_factor* analyse(int mode) {
    common.supernodal = mode;
    cholmod_factor* factor = cholmod_analyze(&matrix, &common);
    require(factor != nullptr, "CHOLMOD could not analyse the matrix");
    return factor;
  }

  Factorisation count_pivots() const {
    Factorisation result;
    const auto* start = static_cast<const int*>(simplicial->p);
    const auto* x = static_cast<const double*>(simplicial->x);
    double smallest = HUGE_VAL, largest = 0.0;
    for (std::size_t j = 0; j < simplicial->n; ++j) {
      const double d = x[start[j]];  // D stands first in each column of L
      if (d < 0.0) ++result.negative_pivots;
      smallest = std::min(smallest, std::abs(d));
      largest = std::max(largest, std::abs(d));
    }
    result.smallest_pivot = largest > 0.0 ? smallest / largest : 0.0;
    result.is_usable = smallest > 0.0 && std::isfinite(largest);
    return result;
  }
};

LinearSolver::LinearSolver(const BlockMatrix& pattern, bool is_unsymmetric)
    : impl_(std::make_unique<Impl>()) {
  Impl& s = *impl_;
  cholmod_start(&s.common);
  if (is_unsymmetric) {
    unsymmetric_ = std::make_unique<UnsymmetricSolver>(pattern);
    return;
  }
  s.common.print = 0;
  s.common.quick_return_if_not_posdef = 1;
  s.starts = pattern.column_starts();
  s.rows = pattern.rows();
  s.values.assign(s.rows.size(), 1.0);
  const auto n = static_cast<std::size_t>(pattern.size());
  s.matrix = cholmod_sparse{};
  s.matrix.nrow = s.matrix.ncol = n;
  s.matrix.nzmax = s.rows.size();
  s.matrix.p = s.starts.data();
  s.matrix.i = s.rows.data();
  s.matrix.x = s.values.data();
  s.matrix.stype = -1;
  s.matrix.itype = CHOLMOD_INT;
  s.matrix.xtype = CHOLMOD_REAL;
  s.matrix.dtype = CHOLMOD_DOUBLE;
  s.matrix.sorted = 1;
  s.matrix.packed = 1;
  s.supernodal = s.analyse(CHOLMOD_SUPERNODAL);
}

LinearSolver::~LinearSolver() = default;

Factorisation LinearSolver::factorise(const std::vector<double>& values) {
  if (unsymmetric_) return unsymmetric_->factorise(values);
  Impl& s = *impl_;
  s.values = values;
  s.matrix.x = s.values.data();
  s.use_simplicial = false;
  cholmod_factorize(&s.matrix, s.supernodal, &s.common);
  if (s.common.status == CHOLMOD_OK) {
    return {true, 0, 0.0, 1};
  }
  if (s.common.status < CHOLMOD_OK) throw EnvironmentError("out of memory in the matrix factorisation");
  if (s.simplicial == nullptr) s.simplicial = s.analyse(CHOLMOD_SIMPLICIAL);
  s.common.final_ll = 0;
  s.common.supernodal = CHOLMOD_SIMPLICIAL;
  cholmod_factorize(&s.matrix, s.simplicial, &s.common);
  s.use_simplicial = true;
  Factorisation result = s.count_pivots();
  result.is_usable = result.is_usable && s.common.status == CHOLMOD_OK;
  result.factorisations = 2;
  return result;
}

Vector LinearSolver::solve(const Vector& rhs) const {
  if (unsymmetric_) return unsymmetric_->solve(rhs);
  Impl& s = *impl_;
  Vector copy = rhs;
  cholmod_dense b{};
  b.nrow = b.nzmax = b.d = static_cast<std::size_t>(copy.size());
  b.ncol = 1;
  b.x = copy.data();
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, s.use_simplicial ? s.simplicial : s.supernodal, &b, &s.common);
  require(x != nullptr, "CHOLMOD could not solve");
  Vector result = Eigen::Map<const Vector>(static_cast<const double*>(x->x), copy.size());
  cholmod_free_dense(&x, &s.common);
  return result;
}

double LinearSolver::factor_entries() const {
  return unsymmetric_ ? unsymmetric_->factor_entries() : static_cast<double>(impl_->supernodal->xsize);
}

void fix_blas_threads(int threads) {
  openblas_set_num_threads(threads);
  // CHOLMOD opens parallel regions of four threads around loops of microseconds, whatever OMP_NUM_THREADS
  // says; waking them takes longer than the whole factorisation of a thin sheet.
  using SetLevels = void (*)(int);
  if (const auto set_levels = reinterpret_cast<SetLevels>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"))) {
    set_levels(threads > 1 ? 1 : 0);
  }
}

}  // namespace hydroscope
