// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/system/block_matrix.h"

#include <algorithm>
#include <set>

namespace hydroscope {

BlockMatrix::BlockMatrix(int n_nodes, const std::vector<std::array<int, 4>>& quads) : n_nodes_(n_nodes) {
  const auto n = static_cast<std::size_t>(n_nodes);
  std::vector<std::set<int>> lower(n);
  for (std::size_t i = 0; i < n; ++i) lower[i].insert(static_cast<int>(i));
  for (const auto& quad : quads) {
    for (const int a : quad) {
      for (const int b : quad) {
        if (a >= b) lower[static_cast<std::size_t>(b)].insert(a);
      }
    }
  }
  neighbours_.resize(n);
  contributions_.resize(n);
  column_starts_.assign(1, 0);
  for (std::size_t b = 0; b < n; ++b) {
    neighbours_[b].assign(lower[b].begin(), lower[b].end());
    for (int j = 0; j < kDofs; ++j) {
      for (const int a : neighbours_[b]) {
        for (int i = 0; i < kDofs; ++i) rows_.push_back(kDofs * a + i);
      }
      column_starts_.push_back(static_cast<int>(rows_.size()));
    }
  }
  values_.assign(rows_.size(), 0.0);
  for (std::size_t e = 0; e < quads.size(); ++e) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        const int a = quads[e][static_cast<std::size_t>(i)], b = quads[e][static_cast<std::size_t>(j)];
        if (a < b) continue;
        const auto& list = neighbours_[static_cast<std::size_t>(b)];
        const auto at = std::lower_bound(list.begin(), list.end(), a) - list.begin();
        contributions_[static_cast<std::size_t>(b)].push_back(
            {static_cast<int>(e), i, j, static_cast<int>(at)});
      }
    }
  }
}

void BlockMatrix::assemble(const std::vector<ElementMatrix>& elements,
                           const std::vector<NodeBlock>& node_blocks, std::size_t begin, std::size_t end) {
  for (std::size_t b = begin; b < end; ++b) {
    const auto height = static_cast<Eigen::Index>(kDofs * neighbours_[b].size());
    double* first = values_.data() + column_starts_[kDofs * b];
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, kDofs>> columns(first, height, kDofs);
    columns.setZero();
    columns.topRows<kDofs>() = node_blocks[b];
    for (const Contribution& c : contributions_[b]) {
      columns.middleRows<kDofs>(kDofs * c.block) +=
          elements[static_cast<std::size_t>(c.element)].block<kDofs, kDofs>(kDofs * c.row, kDofs * c.column);
    }
  }
}

Vector BlockMatrix::multiply(const Vector& x) const {
  Vector y = Vector::Zero(x.size());
  for (int j = 0; j < size(); ++j) {
    const int diagonal_end = kDofs * (j / kDofs + 1);
    for (int k = column_starts_[static_cast<std::size_t>(j)];
         k < column_starts_[static_cast<std::size_t>(j) + 1]; ++k) {
      const int i = rows_[static_cast<std::size_t>(k)];
      const double v = values_[static_cast<std::size_t>(k)];
      y[i] += v * x[j];
      if (i >= diagonal_end) y[j] += v * x[i];  // diagonal blocks are stored whole
    }
  }
  return y;
}

void BlockMatrix::eliminate(const std::vector<char>& is_held, double diagonal,
                            std::vector<double>& values) const {
  values = values_;
  for (int j = 0; j < size(); ++j) {
    const bool is_column_held = is_held[static_cast<std::size_t>(j)] != 0;
    for (int k = column_starts_[static_cast<std::size_t>(j)];
         k < column_starts_[static_cast<std::size_t>(j) + 1]; ++k) {
      const int i = rows_[static_cast<std::size_t>(k)];
      if (is_column_held || is_held[static_cast<std::size_t>(i)] != 0) {
        values[static_cast<std::size_t>(k)] = (i == j) ? diagonal : 0.0;
      }
    }
  }
}

void BlockMatrix::penalise(const std::vector<char>& is_held, double penalty,
                           std::vector<double>& values) const {
  values = values_;
  for (int j = 0; j < size(); ++j) {
    if (is_held[static_cast<std::size_t>(j)] == 0) continue;
    // The node's diagonal block stands first in the column.
    values[static_cast<std::size_t>(column_starts_[static_cast<std::size_t>(j)] + j % kDofs)] += penalty;
  }
}

}  // namespace hydroscope
