// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "solver/shell/shell_element.h"
#include "solver/system/block_matrix.h"
#include "solver/system/linear_solver.h"

namespace hydroscope {
namespace {

constexpr double kYoung = 1e6, kPoisson = 0.25, kThickness = 1e-3, kArea = 0.24 * 0.12;

/// MacNeal & Harder's patch (V1): five distorted elements, four free nodes inside. `tilt` places it in
/// space, so that nothing rests on the world's axes.
struct Patch {
  std::vector<Vec2> at{{0, 0},       {0.24, 0},    {0.24, 0.12}, {0, 0.12},
                       {0.04, 0.02}, {0.18, 0.03}, {0.16, 0.08}, {0.08, 0.08}};
  std::vector<std::array<int, 4>> quads{{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}};
  Mat3 tilt = Eigen::AngleAxisd(0.9, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  ShellLaw law;
  std::vector<std::vector<LayerState>> layers;
  std::vector<std::vector<GaussState>> gauss;

  Patch() {
    SheetMaterial m;
    m.youngs_modulus = kYoung;
    m.poisson = kPoisson;
    law = {SheetLaw(m), make_thickness_rule("gauss", 3)};
    for (std::size_t e = 0; e < quads.size(); ++e) {
      layers.emplace_back(static_cast<std::size_t>(kGaussPoints * law.rule.size()));
      gauss.emplace_back(kGaussPoints);
      initialise_element(nodes(e), tilt.col(0), law.rule, {layers[e], gauss[e]});
    }
  }

  /// Nodes of an element moved by `q` (small: rotations about two axes add up).
  ElementNodes nodes(std::size_t e, const Vector& q = Vector::Zero(40)) const {
    ElementNodes n;
    for (std::size_t a = 0; a < 4; ++a) {
      const auto i = static_cast<std::size_t>(quads[e][a]);
      const auto k = static_cast<Eigen::Index>(kDofs * i);
      const Mat3 turn = (Eigen::AngleAxisd(q[k + 3], tilt.col(0)) * Eigen::AngleAxisd(q[k + 4], tilt.col(1)))
                            .toRotationMatrix();
      n.x[a] = tilt * Vec3(at[i][0], at[i][1], 0.0) + q.segment<3>(k);
      n.triad[a] = {turn * tilt.col(0), turn * tilt.col(1), turn * tilt.col(2)};
      n.thickness[a] = kThickness;
    }
    return n;
  }

  /// Solves with the outer nodes given by `exact`, through the sparse system.
  Vector solve(const Vector& exact, double& energy) const {
    BlockMatrix matrix(8, quads);
    std::vector<ElementMatrix> stiffness(quads.size());
    for (std::size_t e = 0; e < quads.size(); ++e) {
      auto l = layers[e];
      auto g = gauss[e];
      evaluate_element(law, nodes(e), nodes(e), {layers[e], gauss[e]}, {}, {l, g}, &stiffness[e]);
    }
    matrix.assemble(stiffness, std::vector<NodeBlock>(8, NodeBlock::Zero()), 0, 8);
    std::vector<char> is_held(40, 0);
    Vector prescribed = Vector::Zero(40);
    for (std::size_t k = 0; k < 20; ++k) is_held[k] = 1;
    prescribed.head<20>() = exact.head<20>();
    constexpr double kDiagonal = kYoung * kThickness;
    std::vector<double> values;
    matrix.eliminate(is_held, kDiagonal, values);
    LinearSolver solver(matrix);
    const Factorisation f = solver.factorise(values);
    EXPECT_TRUE(f.is_usable);
    EXPECT_EQ(f.negative_pivots, 0);
    Vector rhs = -matrix.multiply(prescribed);
    rhs.head<20>() = kDiagonal * prescribed.head<20>();
    const Vector q = solver.solve(rhs);
    energy = q.dot(matrix.multiply(q));
    return q;
  }

  /// Stress 11, 22, 12 of every point of the state reached by `q`, and the layer's zeta.
  template <class Check>
  void for_each_stress(const Vector& q, const Check& check) const {
    for (std::size_t e = 0; e < quads.size(); ++e) {
      auto l = layers[e];
      auto g = gauss[e];
      evaluate_element(law, nodes(e), nodes(e, q), {layers[e], gauss[e]}, {}, {l, g}, nullptr);
      for (std::size_t k = 0; k < l.size(); ++k) {
        check(l[k].point.stress, law.rule.zeta[k % law.rule.zeta.size()]);
      }
    }
  }
};

/// Largest distance of the free nodes' displacements and rotations from `exact`.
double calc_error(const Vector& q, const Vector& exact, const std::vector<int>& components) {
  double error = 0.0, size = 0.0;
  for (int node = 4; node < 8; ++node) {
    for (const int k : components) {
      error = std::max(error, std::abs(q[kDofs * node + k] - exact[kDofs * node + k]));
      size = std::max(size, std::abs(exact[kDofs * node + k]));
    }
  }
  return error / size;
}

/// Constant membrane strain: u = 1e-3 (x + y/2), v = 1e-3 (y + x/2).
TEST(PatchTest, Membrane) {
  const Patch patch;
  Vector exact = Vector::Zero(40);
  for (std::size_t i = 0; i < 8; ++i) {
    const double x = patch.at[i][0], y = patch.at[i][1];
    exact.segment<3>(static_cast<Eigen::Index>(kDofs * i)) =
        patch.tilt * Vec3(1e-3 * (x + 0.5 * y), 1e-3 * (y + 0.5 * x), 0.0);
  }
  double energy = 0.0;
  const Vector q = patch.solve(exact, energy);
  EXPECT_LT(calc_error(q, exact, {0, 1, 2}), 1e-9);
  // sigma : epsilon = 1333.33 (1e-3 + 1e-3) + 400 1e-3
  EXPECT_NEAR(energy, (4e3 / 3 * 2e-3 + 400 * 1e-3) * kArea * kThickness, 1e-9 * 3e-3 * kArea);
  // Small enough for second order (1e-3 of the strain), large enough for rounding (1e-15 of one).
  constexpr double kScale = 1e-5;
  patch.for_each_stress(kScale * q, [=](const Vec3& stress, double) {
    EXPECT_LT((stress / kScale - Vec3(4e3 / 3, 4e3 / 3, 400)).norm(), 1e-6 * 1900);
  });
}

/// Constant curvature: w = 1e-3 (x^2 + x y + y^2) / 2, fibres normal to it. The wall is 1/240 of the
/// patch: locking would show as a factor, not as a digit.
TEST(PatchTest, Bending) {
  const Patch patch;
  Vector exact = Vector::Zero(40);
  for (std::size_t i = 0; i < 8; ++i) {
    const auto k = static_cast<Eigen::Index>(kDofs * i);
    const double x = patch.at[i][0], y = patch.at[i][1];
    exact.segment<3>(k) = 0.5e-3 * (x * x + x * y + y * y) * patch.tilt.col(2);
    exact[k + 3] = 1e-3 * (y + 0.5 * x);  // dV = -alpha V2 + beta V1 = -grad w
    exact[k + 4] = -1e-3 * (x + 0.5 * y);
  }
  double energy = 0.0;
  const Vector q = patch.solve(exact, energy);
  EXPECT_LT(calc_error(q, exact, {0, 1, 2}), 1e-9);
  EXPECT_LT(calc_error(q, exact, {3, 4}), 1e-9);
  const double moment = kYoung * std::pow(kThickness, 3) / (12 * (1 - kPoisson)) * 1e-3;
  EXPECT_NEAR(moment, 1.1111e-7, 1e-11);
  EXPECT_NEAR(energy, (2 * moment + 0.3 * moment) * 1e-3 * kArea, 1e-9 * 2.3 * moment * 1e-3 * kArea);
  // Rotations of 2e-8 against strains of 5e-11: second order 1e-5, rounding 2e-6.
  constexpr double kScale = 1e-4;
  patch.for_each_stress(kScale * q, [=](const Vec3& stress, double zeta) {
    EXPECT_LT((stress / kScale + zeta * Vec3(2.0 / 3, 2.0 / 3, 0.2)).norm(), 1e-4);
  });
}

// ---------------------------------------------------------------- sparse system

/// 3 x 2 quads with element and node matrices that have nothing special about them.
struct Sample {
  static constexpr int kNodes = 12, kSize = kDofs * kNodes;
  std::vector<std::array<int, 4>> quads;
  std::vector<ElementMatrix> elements;
  std::vector<NodeBlock> blocks;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(kSize, kSize);

  /// `shift` on the diagonal: large is positive definite, small indefinite.
  explicit Sample(double shift) {
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 3; ++i) quads.push_back({4 * j + i, 4 * j + i + 1, 4 * j + i + 5, 4 * j + i + 4});
    }
    double seed = 0.0;
    const auto any = [&](double) {
      seed += 1.37;
      return std::sin(seed) + 0.2 * std::cos(seed * seed);
    };
    for (const auto& quad : quads) {
      const ElementMatrix half = ElementMatrix::Zero().unaryExpr(any);
      elements.push_back(half + half.transpose());
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
          dense.block<5, 5>(kDofs * quad[static_cast<std::size_t>(a)],
                            kDofs * quad[static_cast<std::size_t>(b)]) +=
              elements.back().block<5, 5>(kDofs * a, kDofs * b);
        }
      }
    }
    for (int i = 0; i < kNodes; ++i) {
      const NodeBlock half = NodeBlock::Zero().unaryExpr(any);
      blocks.push_back(half + half.transpose() + shift * NodeBlock::Identity());
      dense.block<5, 5>(kDofs * i, kDofs * i) += blocks.back();
    }
  }
};

TEST(BlockMatrix, HoldsTheAssembledMatrix) {
  const Sample sample(0.0);
  BlockMatrix matrix(Sample::kNodes, sample.quads);
  matrix.assemble(sample.elements, sample.blocks, 0, 5);  // in two parts, as threads do
  matrix.assemble(sample.elements, sample.blocks, 5, Sample::kNodes);
  for (int j = 0; j < Sample::kSize; ++j) {
    EXPECT_LT((matrix.multiply(Vector::Unit(Sample::kSize, j)) - sample.dense.col(j)).norm(), 1e-13);
  }
}

/// Signs of the pivots are those of the eigenvalues (Sylvester), and the solution is one.
TEST(LinearSolver, CountsNegativePivotsAndSolves) {
  for (const double shift : {200.0, 8.0, 0.0, -8.0}) {
    const Sample sample(shift);
    BlockMatrix matrix(Sample::kNodes, sample.quads);
    matrix.assemble(sample.elements, sample.blocks, 0, Sample::kNodes);
    LinearSolver solver(matrix);
    const std::vector<char> is_held(Sample::kSize, 0);
    std::vector<double> values;
    matrix.eliminate(is_held, 1.0, values);
    const Factorisation f = solver.factorise(values);
    const Eigen::VectorXd eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(sample.dense).eigenvalues();
    const auto negative = static_cast<int>((eigenvalues.array() < 0.0).count());
    EXPECT_TRUE(f.is_usable);
    EXPECT_EQ(f.negative_pivots, negative);
    EXPECT_EQ(f.factorisations, negative > 0 ? 2 : 1);
    const Vector rhs = Vector::LinSpaced(Sample::kSize, -1.0, 2.0);
    // Unpivoted L D L^T of an indefinite matrix may lose digits, but not many here.
    EXPECT_LT((sample.dense * solver.solve(rhs) - rhs).norm(), 1e-9 * rhs.norm()) << "shift " << shift;
  }
}

/// Definite, indefinite and definite again with one solver: nothing is left over from the last matrix.
TEST(LinearSolver, ForgetsTheLastMatrix) {
  const Sample good(200.0), bad(0.0);
  BlockMatrix matrix(Sample::kNodes, good.quads);
  LinearSolver solver(matrix);
  const Vector rhs = Vector::LinSpaced(Sample::kSize, -1.0, 2.0);
  const std::vector<char> is_held(Sample::kSize, 0);
  for (const Sample* sample : {&good, &bad, &good, &bad}) {
    matrix.assemble(sample->elements, sample->blocks, 0, Sample::kNodes);
    std::vector<double> values;
    matrix.eliminate(is_held, 1.0, values);
    EXPECT_EQ(solver.factorise(values).negative_pivots > 0, sample == &bad);
    EXPECT_LT((sample->dense * solver.solve(rhs) - rhs).norm(), 1e-9 * rhs.norm());
  }
}

TEST(LinearSolver, SaysWhenTheMatrixIsSingular) {
  const Sample sample(200.0);
  BlockMatrix matrix(Sample::kNodes, sample.quads);
  LinearSolver solver(matrix);
  matrix.assemble(sample.elements, sample.blocks, 0, Sample::kNodes);
  std::vector<char> is_held(Sample::kSize, 0);
  is_held[17] = 1;
  std::vector<double> values;
  matrix.eliminate(is_held, 0.0, values);  // a row of nothing
  EXPECT_FALSE(solver.factorise(values).is_usable);
}

/// Elimination gives the solution of the reduced system, and the residual of the held rows is the reaction.
TEST(LinearSolver, EliminationMatchesTheReducedSystem) {
  const Sample sample(200.0);
  BlockMatrix matrix(Sample::kNodes, sample.quads);
  matrix.assemble(sample.elements, sample.blocks, 0, Sample::kNodes);
  std::vector<char> is_held(Sample::kSize, 0);
  std::vector<int> free;
  for (int k = 0; k < Sample::kSize; ++k) {
    is_held[static_cast<std::size_t>(k)] = k % 7 == 3 ? 1 : 0;
    if (k % 7 != 3) free.push_back(k);
  }
  std::vector<double> values;
  constexpr double kDiagonal = 123.0;
  matrix.eliminate(is_held, kDiagonal, values);
  LinearSolver solver(matrix);
  ASSERT_TRUE(solver.factorise(values).is_usable);
  const Vector load = Vector::LinSpaced(Sample::kSize, -1.0, 2.0);
  Vector prescribed = Vector::Zero(Sample::kSize);
  for (int k = 3; k < Sample::kSize; k += 7) prescribed[k] = 0.01 * k;
  Vector rhs = load - matrix.multiply(prescribed);
  for (int k = 3; k < Sample::kSize; k += 7) rhs[k] = kDiagonal * prescribed[k];
  const Vector x = solver.solve(rhs);
  for (int k = 3; k < Sample::kSize; k += 7) EXPECT_NEAR(x[k], prescribed[k], 1e-15);
  const Vector imbalance = sample.dense * x - load;
  for (const int k : free) EXPECT_NEAR(imbalance[k], 0.0, 1e-12);
}

}  // namespace
}  // namespace hydroscope
