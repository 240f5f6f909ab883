// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "solver/system/node_basis.h"

namespace hydroscope {
namespace {

NodeVector make_row(double a, double b, double c, double d, double e) {
  NodeVector row;
  row << a, b, c, d, e;
  return row;
}

TEST(NodeBasis, WithoutRowsIsTheIdentity) {
  NodeBasis basis;
  basis.finish();
  EXPECT_TRUE(basis.is_identity());
  EXPECT_EQ(basis.n_held(), 0);
  EXPECT_EQ(basis.transform(), NodeBlock(NodeBlock::Identity()));
}

/// C T = [I, 0]: the first local degrees of freedom are the rows' values, the others leave them alone.
TEST(NodeBasis, HeldOnesAreTheRows) {
  const std::vector<NodeVector> rows{make_row(0.6, 0.8, 0, 0.75, -0.1), make_row(0, 0.1, 2.0, 0, 0.4),
                                     make_row(0, 0, 0, 1, 0)};
  for (std::size_t n = 1; n <= rows.size(); ++n) {
    NodeBasis basis;
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_EQ(basis.add_row(rows[k], 0.1 * static_cast<double>(k)), static_cast<int>(k));
    }
    basis.finish();
    ASSERT_EQ(basis.n_held(), static_cast<int>(n));
    for (std::size_t k = 0; k < n; ++k) {
      const auto unit = NodeVector(NodeVector::Unit(static_cast<Eigen::Index>(k)));
      EXPECT_LT((basis.transform().transpose() * rows[k] - unit).norm(), 1e-14);
      EXPECT_EQ(basis.value(static_cast<int>(k)), 0.1 * static_cast<double>(k));
    }
    // What is free is orthonormal, so that the matrix keeps its scale.
    for (int i = basis.n_held(); i < kDofs; ++i) {
      for (int j = basis.n_held(); j < kDofs; ++j) {
        EXPECT_NEAR(basis.transform().col(i).dot(basis.transform().col(j)), i == j ? 1.0 : 0.0, 1e-14);
      }
    }
    EXPECT_GT(std::abs(basis.transform().determinant()), 0.1);
  }
}

TEST(NodeBasis, LeavesOutDependentRows) {
  NodeBasis basis;
  const NodeVector a = make_row(1, 0, 0, 0, 0.5), b = make_row(0, 1, 0, 0.2, 0);
  EXPECT_EQ(basis.add_row(a, 1.0), 0);
  EXPECT_EQ(basis.add_row(-3.0 * a, 7.0), -1);
  EXPECT_EQ(basis.add_row(b, 2.0), 1);
  EXPECT_EQ(basis.add_row(0.3 * a + 0.4 * b, 7.0), -1);
  EXPECT_EQ(basis.add_row(NodeVector::Unit(2), 0.0), 2);
  EXPECT_EQ(basis.add_row(NodeVector::Unit(3), 0.0), 3);
  EXPECT_EQ(basis.add_row(NodeVector::Unit(4), 0.0), 4);
  EXPECT_EQ(basis.add_row(make_row(1, 1, 1, 1, 1), 0.0), -1);  // none left
  basis.finish();
  EXPECT_EQ(basis.n_held(), kDofs);
  EXPECT_EQ(basis.value(1), 2.0);
}

TEST(NodeBasis, KnowsSpringsFromEliminatedRows) {
  NodeBasis basis;
  basis.add_row(NodeVector::Unit(0), 0.0);
  basis.add_row(NodeVector::Unit(1), 0.01, 1e5);
  basis.finish();
  EXPECT_TRUE(basis.is_eliminated(0));
  EXPECT_FALSE(basis.is_eliminated(1));
  EXPECT_EQ(basis.stiffness(1), 1e5);
}

/// The force conjugate to a held degree of freedom is the constraint's reaction: a force along C^T comes
/// back as its multiplier, and does nothing to what is free.
TEST(NodeBasis, ReactionsAreMultipliers) {
  NodeBasis basis;
  const NodeVector a = make_row(0.6, 0.8, 0, 0.75, -0.1), b = make_row(0, 0.1, 2.0, 0, 0.4);
  basis.add_row(a, 0.0);
  basis.add_row(b, 0.0);
  basis.finish();
  const NodeVector local = basis.transform().transpose() * (3.0 * a - 5.0 * b);
  EXPECT_LT((local - make_row(3, -5, 0, 0, 0)).norm(), 1e-13);
}

}  // namespace
}  // namespace hydroscope
