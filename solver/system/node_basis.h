// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/system/block_matrix.h"

namespace hydroscope {

/// Local degrees of freedom of a node: q = T q_local, of which the first
/// `n_held` are prescribed. For rows C of linear constraints C q = c,
/// T = [C^+, Z] with Z an orthonormal basis of the null space of C: the
/// generalisation of the rotation (4.52)-(4.57) to contact points off the
/// mid-surface, symmetry planes and several tools at one node.
/// The force conjugate to a held degree of freedom is the constraint's reaction.
class NodeBasis {
 public:
  NodeBasis() { transform_.setIdentity(); }

  /// Adds C q = value. Returns its index among the held ones, or -1 when the
  /// row depends on those already there (then it is left out).
  int add_row(const NodeVector& row, double value);
  /// Builds T; call after the last add_row().
  void finish();

  bool is_identity() const { return n_held_ == 0; }
  int n_held() const { return n_held_; }
  double value(int i) const { return values_[static_cast<std::size_t>(i)]; }
  const NodeBlock& transform() const { return transform_; }

 private:
  int n_held_ = 0;
  Eigen::Matrix<double, kDofs, kDofs> rows_ = Eigen::Matrix<double, kDofs, kDofs>::Zero();        ///< columns are rows of C
  Eigen::Matrix<double, kDofs, kDofs> orthonormal_ = Eigen::Matrix<double, kDofs, kDofs>::Zero(); ///< Gram-Schmidt of them
  std::array<double, kDofs> values_{};
  NodeBlock transform_;
};

}  // namespace hydroscope
