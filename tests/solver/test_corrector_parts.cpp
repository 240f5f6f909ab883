// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "solver/increment/work_search.h"
#include "solver/material/plane_stress.h"
#include "solver/system/secant_updates.h"

namespace hydroscope {
namespace {

/// One quadrilateral's worth of matrix: 20 degrees of freedom, positive definite.
struct SmallSystem {
  SmallSystem() : pattern(4, {{0, 1, 2, 3}}), solver(pattern), dense(Eigen::MatrixXd::Zero(20, 20)) {
    std::vector<ElementMatrix> elements(1, ElementMatrix::Zero());
    for (int i = 0; i < 20; ++i) {
      for (int j = 0; j < 20; ++j) elements[0](i, j) = std::cos(0.3 * i * j) + std::cos(0.3 * j * i);
    }
    elements[0] = (elements[0] * elements[0].transpose()).eval();
    elements[0].diagonal().array() += 3.0;
    pattern.assemble(elements, std::vector<NodeBlock>(4, NodeBlock::Zero()), 0, 4);
    dense = elements[0];
    solver.factorise(pattern.values());
    for (int i = 0; i < 20; ++i) rhs[i] = std::sin(1.0 + i);
  }
  BlockMatrix pattern;
  LinearSolver solver;
  Eigen::MatrixXd dense;
  Vector rhs = Vector::Zero(20);
};

// Springs that come and go are exact (Sherman-Morrison), steps satisfy the secant equation K delta = gamma.
TEST(SecantUpdates, SpringsAreExact) {
  const SmallSystem s;
  SecantUpdates updates;
  Vector first = Vector::Zero(20), second = first;
  first.segment<3>(0) = Vec3(0.2, -0.4, 1.0);
  second.segment<3>(10) = Vec3(1.0, 0.3, 0.0);
  ASSERT_TRUE(updates.add_spring(s.solver, first, 1e4));
  ASSERT_TRUE(updates.add_spring(s.solver, second, -1.0));
  const Eigen::MatrixXd k = s.dense + 1e4 * first * first.transpose() - 1.0 * second * second.transpose();
  const Vector wanted = k.llt().solve(s.rhs);
  EXPECT_LT((updates.solve(s.solver, s.rhs) - wanted).norm(), 1e-9 * wanted.norm());
  EXPECT_FALSE(updates.add_spring(s.solver, second, -1e9)) << "would no longer be definite";
}

TEST(SecantUpdates, StepsAreReproduced) {
  const SmallSystem s;
  SecantUpdates updates;
  const Vector delta = Vector::LinSpaced(20, 0.1, 1.0);
  Vector gamma = s.dense * delta;
  for (int i = 0; i < 20; i += 2) gamma[i] *= 1.7;
  updates.add_step(delta, gamma);
  EXPECT_LT((updates.solve(s.solver, gamma) - delta).norm(), 1e-9 * delta.norm());
  const Vector once = updates.solve(s.solver, s.rhs), other = Vector::LinSpaced(20, -1.0, 2.0);
  EXPECT_NEAR(other.dot(once), s.rhs.dot(updates.solve(s.solver, other)), 1e-9 * other.norm() * once.norm())
      << "the inverse stays symmetric";
  updates.add_step(delta, -gamma);
  EXPECT_EQ(updates.n_steps(), 1) << "negative curvature is left out";
}

// A work with a corner, soft before it and stiff behind: the full step overshoots tenfold.
TEST(WorkSearch, FindsTheZeroBehindACorner) {
  const auto work = [](double s) { return s < 0.1 ? 1.0 - s : 0.9 - 12.0 * (s - 0.1); };
  WorkSearch search(work(0.0));
  int looks = 0;
  while (!search.accepts(work(search.scale()))) ASSERT_LT(++looks, 8);
  EXPECT_GE(looks, 1);
  EXPECT_LE(std::abs(work(search.scale())), 0.5);
}

TEST(WorkSearch, TakesFullStepsThatDoNotOvershoot) {
  WorkSearch search(2.0);
  EXPECT_TRUE(search.accepts(1.5));
  EXPECT_EQ(search.scale(), 1.0);
}

SheetLaw make_law(double rounding) {
  SheetMaterial m;
  m.youngs_modulus = 206e3;
  m.poisson = 0.3;
  m.hardening.kind = Hardening::Kind::kSwift;
  m.hardening.k = 550.0;
  m.hardening.eps0 = 0.01;
  m.hardening.n = 0.2;
  m.yield_rounding = rounding;
  return SheetLaw(m);
}

// Uniaxial strain up to first yield and past it: outside the band of the onset both laws agree to the last
// digits, inside the rounded one lies below by at most a quarter of the band; its stiffness has no jump.
TEST(YieldRounding, ChangesNothingOutsideItsBand) {
  const double rounding = 0.01;
  const SheetLaw sharp = make_law(0.0), rounded = make_law(rounding);
  const double yield = sharp.material.hardening(0.0).stress;
  const double at_yield =
      yield / calc_equivalent_stress(sharp.yield_matrix, sharp.elasticity * Vec3(1, 0, 0));
  double largest = 0.0;
  for (const double share : {0.5, 0.98, 0.995, 1.0, 1.005, 1.02, 3.0}) {
    const Vec3 strain(share * at_yield, 0.0, 0.0);
    const StressUpdate a = update_stress(sharp, {}, strain), b = update_stress(rounded, {}, strain);
    const double difference = calc_equivalent_stress(sharp.yield_matrix, a.point.stress) -
                              calc_equivalent_stress(sharp.yield_matrix, b.point.stress);
    EXPECT_GE(difference, -1e-9 * yield);
    if (std::abs(share - 1.0) >= rounding) {
      EXPECT_NEAR(difference, 0.0, 1e-9 * yield) << share;
    } else {
      largest = std::max(largest, difference);
    }
  }
  EXPECT_GT(largest, 0.2 * rounding * yield);
  EXPECT_LT(largest, 0.2501 * rounding * yield);
}

}  // namespace
}  // namespace hydroscope
