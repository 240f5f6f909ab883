// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
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
  /// row depends on those already there (then it is left out). A finite
  /// `stiffness` alpha [N/mm] makes it a spring alpha (value - C q) on the
  /// diagonal (4.58)-(4.62); infinite (the default) it is eliminated.
  int add_row(const NodeVector& row, double value,
              double stiffness = std::numeric_limits<double>::infinity());
  /// Builds T; call after the last add_row().
  void finish();

  bool is_identity() const { return n_held_ == 0; }
  int n_held() const { return n_held_; }
  bool is_eliminated(int i) const { return std::isinf(stiffness_[static_cast<std::size_t>(i)]); }
  double stiffness(int i) const { return stiffness_[static_cast<std::size_t>(i)]; }
  double value(int i) const { return values_[static_cast<std::size_t>(i)]; }
  NodeVector row(int i) const { return rows_.col(i); }
  const NodeBlock& transform() const { return transform_; }
  /// q_local = T^-1 q: the rows of C above the null space's.
  NodeVector to_local_displacement(const NodeVector& q) const {
    if (n_held_ == 0) return q;
    NodeVector local = transform_.transpose() * q;
    for (int k = 0; k < n_held_; ++k) local[k] = rows_.col(k).dot(q);
    return local;
  }

 private:
  int n_held_ = 0;
  Eigen::Matrix<double, kDofs, kDofs> rows_ =
      Eigen::Matrix<double, kDofs, kDofs>::Zero();  ///< columns are rows of C
  Eigen::Matrix<double, kDofs, kDofs> orthonormal_ =
      Eigen::Matrix<double, kDofs, kDofs>::Zero();  ///< Gram-Schmidt of them
  std::array<double, kDofs> values_{}, stiffness_{};
  NodeBlock transform_;
};

}  // namespace hydroscope
