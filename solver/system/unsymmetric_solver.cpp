// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/system/unsymmetric_solver.h"

#include <umfpack.h>

#include <cmath>
#include <string>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

[[noreturn]] void fail(int status) {
  if (status == UMFPACK_ERROR_out_of_memory)
    throw EnvironmentError("out of memory in the matrix factorisation");
  throw ContractError("UMFPACK ended with status " + std::to_string(status));
}

}  // namespace

UnsymmetricSolver::UnsymmetricSolver(const BlockMatrix& pattern) {
  const auto n = static_cast<std::size_t>(pattern.size());
  const auto& starts = pattern.column_starts();
  const auto& rows = pattern.rows();
  std::vector<std::vector<std::array<int, 2>>> columns(n);  // (row, source)
  // What stands above the diagonal comes from columns further left: rows come out ascending.
  for (std::size_t j = 0; j < n; ++j) {
    const int block_end = kDofs * (static_cast<int>(j) / kDofs + 1);
    for (int k = starts[j]; k < starts[j + 1]; ++k) {
      const int i = rows[static_cast<std::size_t>(k)];
      columns[j].push_back({i, k});
      if (i >= block_end) columns[static_cast<std::size_t>(i)].push_back({static_cast<int>(j), k});
    }
  }
  starts_.assign(1, 0);
  for (const auto& column : columns) {
    for (const auto& [row, source] : column) {
      rows_.push_back(row);
      sources_.push_back(source);
    }
    starts_.push_back(static_cast<int>(rows_.size()));
  }
  values_.assign(rows_.size(), 1.0);
}

UnsymmetricSolver::~UnsymmetricSolver() {
  umfpack_di_free_numeric(&numeric_);
  umfpack_di_free_symbolic(&symbolic_);
}

Factorisation UnsymmetricSolver::factorise(const std::vector<double>& values) {
  for (std::size_t k = 0; k < values_.size(); ++k) values_[k] = values[static_cast<std::size_t>(sources_[k])];
  const int n = static_cast<int>(starts_.size()) - 1;
  double control[UMFPACK_CONTROL], info[UMFPACK_INFO];
  umfpack_di_defaults(control);
  control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
  if (symbolic_ == nullptr) {
    const int status =
        umfpack_di_symbolic(n, n, starts_.data(), rows_.data(), values_.data(), &symbolic_, control, info);
    if (status != UMFPACK_OK) fail(status);
  }
  umfpack_di_free_numeric(&numeric_);
  const int status =
      umfpack_di_numeric(starts_.data(), rows_.data(), values_.data(), symbolic_, &numeric_, control, info);
  Factorisation result;
  result.factorisations = 1;
  if (status == UMFPACK_WARNING_singular_matrix) return result;
  if (status != UMFPACK_OK) fail(status);
  result.smallest_pivot = info[UMFPACK_RCOND];
  double mantissa = 0.0, exponent = 0.0;
  umfpack_di_get_determinant(&mantissa, &exponent, numeric_, info);
  result.is_usable = std::isfinite(mantissa) && mantissa != 0.0;
  result.negative_pivots = mantissa < 0.0 ? 1 : 0;
  return result;
}

Vector UnsymmetricSolver::solve(const Vector& rhs) const {
  Vector x(rhs.size());
  const int status = umfpack_di_solve(UMFPACK_A, starts_.data(), rows_.data(), values_.data(), x.data(),
                                      rhs.data(), numeric_, nullptr, nullptr);
  if (status < 0) fail(status);
  return x;
}

double UnsymmetricSolver::factor_entries() const {
  int l = 0, u = 0, rows = 0, columns = 0, diagonal = 0;
  if (numeric_ != nullptr) umfpack_di_get_lunz(&l, &u, &rows, &columns, &diagonal, numeric_);
  return static_cast<double>(l) + static_cast<double>(u);
}

}  // namespace hydroscope
