// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/system/node_basis.h"

namespace hydroscope {

int NodeBasis::add_row(const NodeVector& row, double value, double stiffness) {
  constexpr double kDependent = 0.05;  // sine of the smallest angle to the rows already there
  if (n_held_ == kDofs) return -1;
  const double size = row.norm();
  NodeVector rest = row / size;
  for (int pass = 0; pass < 2; ++pass) {
    for (int i = 0; i < n_held_; ++i) rest -= orthonormal_.col(i).dot(rest) * orthonormal_.col(i);
  }
  const double independent = rest.norm();
  if (!(independent > kDependent)) return -1;
  orthonormal_.col(n_held_) = rest / independent;
  rows_.col(n_held_) = row;
  values_[static_cast<std::size_t>(n_held_)] = value;
  stiffness_[static_cast<std::size_t>(n_held_)] = stiffness;
  return n_held_++;
}

void NodeBasis::finish() {
  if (n_held_ == 0) return;
  const Eigen::MatrixXd c = rows_.leftCols(n_held_);  // C^T
  transform_.leftCols(n_held_) = c * (c.transpose() * c).inverse();
  // Complete the orthonormal set with the unit vectors that fit best: continuous and cheap.
  int filled = n_held_;
  while (filled < kDofs) {
    NodeVector best = NodeVector::Zero();
    double best_norm = -1.0;
    for (int k = 0; k < kDofs; ++k) {
      NodeVector e = NodeVector::Unit(k);
      for (int pass = 0; pass < 2; ++pass) {
        for (int i = 0; i < filled; ++i) e -= orthonormal_.col(i).dot(e) * orthonormal_.col(i);
      }
      if (e.norm() > best_norm) {
        best_norm = e.norm();
        best = e;
      }
    }
    orthonormal_.col(filled) = best / best_norm;
    transform_.col(filled) = orthonormal_.col(filled);
    ++filled;
  }
}

}  // namespace hydroscope
