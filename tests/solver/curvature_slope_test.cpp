// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/solver/curvature_slope.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hydroscope {
namespace {

constexpr double kNormalForce = 200.0;  // [N]; t_N / R = 20 N/mm beside springs of 1000 N/mm
constexpr double kOffset = 0.75;        // [mm]
// The first slide is about 0.2 mm, a tenth of a facet; the last 1e-4 mm, where the second-order rest is
// 2e-7 N, ten digits above rounding.
constexpr double kFirstForce = 200.0;
constexpr int kSteps = 12;

enum class Rest { transported, balanced };

double calc_slope(const std::vector<SlopeRow>& rows, TangentialRest SlopeRow::*treatment, Rest rest) {
  std::vector<double> slide, value;
  for (const SlopeRow& row : rows) {
    const TangentialRest& r = row.*treatment;
    EXPECT_TRUE(r.in_one_facet);
    slide.push_back(r.slide);
    value.push_back(rest == Rest::transported ? r.transported : r.balanced);
  }
  return fit_slope(slide, value);
}

class CurvatureSlope : public ::testing::TestWithParam<std::size_t> {
 protected:
  SlopeCase tool_ = make_slope_cases().at(GetParam());
  SpringNode node_ = make_spring_node(*tool_.tool, tool_.at, kOffset, kNormalForce);
};

/// With K_C the force is turned with the normal as far as first order goes: what is left falls with the
/// square of the step. Without it the whole turn is left.
TEST_P(CurvatureSlope, TangentialRestFallsWithTheSquareOfTheStep) {
  const auto rows = measure_slopes(*tool_.tool, node_, kFirstForce, kSteps);
  EXPECT_NEAR(calc_slope(rows, &SlopeRow::full, Rest::transported), 2.0, 0.1);
  EXPECT_NEAR(calc_slope(rows, &SlopeRow::full, Rest::balanced), 2.0, 0.1);
  EXPECT_NEAR(calc_slope(rows, &SlopeRow::symmetric, Rest::transported), 2.0, 0.1);
  EXPECT_NEAR(calc_slope(rows, &SlopeRow::none, Rest::transported), 1.0, 0.1);
  EXPECT_NEAR(calc_slope(rows, &SlopeRow::none, Rest::balanced), 1.0, 0.1);
}

/// What the symmetric part leaves out of the step's own balance: nothing where dn/dx is symmetric; on
/// averaged normals a first-order rest, but a small part of what no curvature at all leaves.
TEST_P(CurvatureSlope, SymmetricPartLeavesLittleInTheBalance) {
  const auto rows = measure_slopes(*tool_.tool, node_, kFirstForce, kSteps);
  if (tool_.is_symmetric) {
    EXPECT_NEAR(calc_slope(rows, &SlopeRow::symmetric, Rest::balanced), 2.0, 0.1);
  }
  EXPECT_LT(rows.back().symmetric.balanced, 0.1 * rows.back().none.balanced);
}

/// calc_contact_stiffness() with the whole, unsymmetric K_C is minus the derivative of J^T t_N n, rotation
/// rows and columns too. Steps of 1e-5 mm: truncation 1e-12, rounding 1e-11.
TEST_P(CurvatureSlope, WholeStiffnessMatchesDifferences) {
  using NodeForce = Eigen::Matrix<double, kDofs, 1>;
  const auto force = [&](const SpringNode& n) {
    return NodeForce(n.slave.calc_map().transpose() *
                     (kNormalForce * find_foot(*tool_.tool, n.point()).normal));
  };
  const auto k = calc_contact_stiffness(node_.slave, find_foot(*tool_.tool, node_.point()), kNormalForce, {},
                                        true, false);
  Eigen::Matrix<double, kDofs, kDofs> difference;
  constexpr double kStep = 1e-5;
  for (int j = 0; j < kDofs; ++j) {
    const NodeForce q = kStep * NodeForce::Unit(j);
    difference.col(j) = -(force(node_.moved(q)) - force(node_.moved(-q))) / (2 * kStep);
  }
  // dn/dx along n is left out (4.32), as the gap is held; moves along n are no part of the comparison.
  const NodeForce row = calc_gap_row(node_.slave, find_foot(*tool_.tool, node_.point()).normal).normalized();
  const Eigen::Matrix<double, kDofs, kDofs> held =
      Eigen::Matrix<double, kDofs, kDofs>::Identity() - row * row.transpose();
  EXPECT_LT(((k - difference) * held).norm(), 1e-6 * k.norm());
  EXPECT_GT(difference.bottomRows<2>().norm(), 0.01 * difference.norm()) << "the fibre's rows are no zeros";
  if (!tool_.is_symmetric) {
    EXPECT_GT((k - k.transpose()).norm(), 1e-4 * k.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Tools, CurvatureSlope, ::testing::Range(std::size_t{0}, make_slope_cases().size()),
                         [](const auto& tool) {
                           std::string name = make_slope_cases().at(tool.param).name;
                           for (char& c : name) c = c == ' ' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace hydroscope
