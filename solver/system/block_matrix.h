// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "solver/shell/shell_element.h"

namespace hydroscope {

using NodeBlock = Eigen::Matrix<double, kDofs, kDofs>;
using NodeVector = Eigen::Matrix<double, kDofs, 1>;
using Vector = Eigen::VectorXd;

/// Symmetric sparse matrix of 5 x 5 node blocks; the lower block triangle is
/// kept in compressed columns (diagonal blocks whole). The pattern is that of
/// the mesh and never changes during a run, whatever touches or lets go.
class BlockMatrix {
 public:
  BlockMatrix(int n_nodes, const std::vector<std::array<int, 4>>& quads);

  int size() const { return kDofs * n_nodes_; }
  int n_nodes() const { return n_nodes_; }
  const std::vector<int>& column_starts() const { return column_starts_; }
  const std::vector<int>& rows() const { return rows_; }
  const std::vector<double>& values() const { return values_; }

  /// Sums element matrices (one a quad) and node blocks (one a node) into the
  /// columns of nodes [begin, end), always in the same order.
  void assemble(const std::vector<ElementMatrix>& elements, const std::vector<NodeBlock>& node_blocks,
                std::size_t begin, std::size_t end);

  /// y = K x with the whole symmetric matrix.
  Vector multiply(const Vector& x) const;

  /// Copy of the values with the rows and columns of the held degrees of
  /// freedom wiped and `diagonal` on their diagonal: the constraint (4.58)-(4.61)
  /// by elimination.
  void eliminate(const std::vector<char>& is_held, double diagonal, std::vector<double>& values) const;

  /// Copy of the values with `penalty` added on the diagonal of the held degrees of freedom (4.59).
  void penalise(const std::vector<char>& is_held, double penalty, std::vector<double>& values) const;

 private:
  struct Contribution {
    int element, row, column;  ///< local nodes of the element
    int block;                 ///< position in the column node's list
  };
  int n_nodes_;
  std::vector<std::vector<int>> neighbours_;              ///< nodes >= the column's node, ascending
  std::vector<std::vector<Contribution>> contributions_;  ///< of each column node
  std::vector<int> column_starts_, rows_;
  std::vector<double> values_;
};

}  // namespace hydroscope
