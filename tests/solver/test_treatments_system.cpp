// SPDX-License-Identifier: GPL-3.0-or-later
// How the equations are solved: constraints by elimination or penalty, symmetric or not.
#include <gtest/gtest.h>

#include <cmath>

#include "model_texts.h"
#include "solver/system/unsymmetric_solver.h"

namespace hydroscope {
namespace {

// ---------------------------------------------------------------- constraints (4.58)-(4.62)

/// Tube T with supports, an end that is fed, and a round die that holds its middle.
const std::string kPressedTube = test::kTubeT + R"(length_mm = 24
extent = "half"
elements_around = 5
elements_along = 6
)" + test::kElastic + R"([load]
pressure_MPa = [[0, 0], [1, 40], [2, 46]]
axial_feed_mm = [[0, 0], [1, 0], [2, 0.02]]
[ends]
axial = "feed"
rotation = "held"
radial = "held"
[tool.die]
shape = "cylinder"
radius_mm = 30.77
[contact]
wall_stiffness = 0
[increment]
largest = 0.2
initial_s = 0.2
tolerance = 1e-9
)";

/// One solve from the state at 1 s to 46 MPa and a fed end, with the constraints of `set`.
struct OneStep {
  Solution solution;
  Vector held;     ///< forces that hold it, in the nodes' bases [N]
  Vector contact;  ///< the same of the rows of contact alone
};

State make_pressed_state() {
  const Model model = test::make_model(kPressedTube);
  State state = make_initial_state(model);
  Scratch scratch(model, 1);
  while (state.time < 1.0) {
    const IncrementReport report = advance(model, state, scratch);
    if (report.outcome != Outcome::kRunning) throw std::runtime_error(report.message);
  }
  return state;
}

OneStep step_from(const State& state, const std::vector<std::string>& sets) {
  const Model model = test::make_model(kPressedTube, sets);
  Scratch scratch(model, 1);
  const Loads loads{2.0, 46.0};
  start_trial(state, scratch);
  evaluate(model, state, loads, {.freeze_thickness = true, .with_stiffness = true}, scratch);
  evaluate_contacts(model, state, loads, true, scratch);
  assemble_matrix(model, scratch);
  EXPECT_TRUE(factorise(model, scratch).is_usable);
  const Step step = make_step(loads, scratch);
  OneStep result;
  result.solution = solve(model, loads, step, false, 0.0, scratch);
  result.held = calc_held_forces(model, step, result.solution, scratch);
  result.contact = Vector::Zero(result.held.size());
  for (std::size_t i = 0; i < state.contacts[0].size(); ++i) {
    const ContactPoint& c = scratch.trial.contacts[0][i];
    const auto at = static_cast<Eigen::Index>(kDofs * i) + c.held_row;
    if (c.is_active() && c.held_row >= 0) result.contact[at] = result.held[at];
  }
  return result;
}

double compare(const Vector& value, const Vector& wanted) { return (value - wanted).norm() / wanted.norm(); }

TEST(ConstraintTreatment, PenaltyAndEliminationGiveTheSameReactions) {
  const State state = make_pressed_state();
  const OneStep wiped = step_from(state, {}),
                hard = step_from(state, {"contact.constraint=penalty"});  // 1e40 by default
  EXPECT_GT((wiped.contact.array() > 1.0).count(), 6) << "nodes that press [N]";
  EXPECT_NEAR(wiped.solution.q.head<3>().norm(), hard.solution.q.head<3>().norm(), 1e-12);
  EXPECT_LT(compare(hard.solution.q, wiped.solution.q), 1e-9);
  EXPECT_LT(compare(hard.contact, wiped.contact), 1e-9);
  EXPECT_LT(compare(hard.held, wiped.held), 1e-9);
  // (4.62): what gives way is the force over the penalty, far below rounding.
  EXPECT_LT(hard.solution.penetration.norm(), 1e-35);
  EXPECT_GT(hard.solution.penetration.norm(), 0.0);
}

/// A penalty as soft as E h gives way by a share of the order of one: that is what 1e40 is for. As the
/// elimination's is the exact limit, the difference falls with 1/alpha.
TEST(ConstraintTreatment, SoftPenaltyDoesNot) {
  const State state = make_pressed_state();
  const OneStep wiped = step_from(state, {});
  const auto calc_difference = [&](const std::string& alpha) {
    const OneStep soft =
        step_from(state, {"contact.constraint=penalty", "contact.penalty_N_per_mm=" + alpha});
    return compare(soft.contact, wiped.contact);
  };
  EXPECT_GT(calc_difference("3e5"), 0.05);
  const double at_9 = calc_difference("1e9"), at_10 = calc_difference("1e10");
  EXPECT_NEAR(at_9 / at_10, 10.0, 0.1);
}

/// Whole runs: the same path, whichever way the constraints enter.
TEST(ConstraintTreatment, RunsEndAlike) {
  const auto run = [](const std::vector<std::string>& sets) {
    const Model model = test::make_model(kPressedTube, sets);
    State state = make_initial_state(model);
    Scratch scratch(model, 1);
    const IncrementReport report = test::run_to_end(model, state, scratch);
    EXPECT_EQ(state.time, model.end_time) << report.message;
    return state;
  };
  const State wiped = run({}), penalised = run({"contact.constraint=penalty"});
  double difference = 0.0, reaction = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < wiped.reaction.size(); ++i) {
    difference = std::max(difference, (wiped.configuration.x[i] - penalised.configuration.x[i]).norm());
    reaction = std::max(reaction, (wiped.reaction[i] - penalised.reaction[i]).norm());
    largest = std::max(largest, wiped.reaction[i].norm());
  }
  EXPECT_LT(difference, 1e-10);  // of displacements of about 0.02 mm
  EXPECT_LT(reaction, 1e-8 * largest);
}

// ---------------------------------------------------------------- solvers

/// 2 x 2 quadrilaterals with node blocks of our own; `dense` is put together without the sparse matrix.
struct Grid {
  Grid(double asymmetry, double shift) : matrix(9, quads), dense(Eigen::MatrixXd::Zero(45, 45)) {
    std::vector<ElementMatrix> elements(4, ElementMatrix::Zero());
    std::vector<NodeBlock> blocks(9, NodeBlock::Zero());
    for (std::size_t e = 0; e < 4; ++e) {
      for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 20; ++j) elements[e](i, j) = std::cos(0.3 * i * j + 0.4 * static_cast<double>(e));
      }
      elements[e] = (elements[e] * elements[e].transpose()).eval();
      elements[e].diagonal().array() += 3.0;
      for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = 0; b < 4; ++b) {
          dense.block<5, 5>(5 * quads[e][a], 5 * quads[e][b]) +=
              elements[e].block<5, 5>(static_cast<Eigen::Index>(5 * a), static_cast<Eigen::Index>(5 * b));
        }
      }
    }
    for (int i = 0; i < 9; ++i) {
      NodeBlock& block = blocks[static_cast<std::size_t>(i)];
      for (int j = 0; j < 5; ++j) {
        for (int k = 0; k < 5; ++k) block(j, k) = asymmetry * std::sin(1.0 + i + 2.0 * j - 1.3 * k);
      }
      if (i == 4) block(2, 2) += shift;
      dense.block<5, 5>(5 * i, 5 * i) += block;
    }
    matrix.assemble(elements, blocks, 0, 9);
    for (int i = 0; i < 45; ++i) rhs[i] = std::sin(1.0 + 0.7 * i);
  }
  std::vector<std::array<int, 4>> quads{{{0, 1, 4, 3}}, {{1, 2, 5, 4}}, {{3, 4, 7, 6}}, {{4, 5, 8, 7}}};
  BlockMatrix matrix;
  Eigen::MatrixXd dense;
  Vector rhs = Vector::Zero(45);
};

TEST(UnsymmetricSolver, SolvesWithWholeDiagonalBlocks) {
  const Grid grid(2.0, 0.0);
  ASSERT_GT((grid.dense - grid.dense.transpose()).norm(), 1.0);
  LinearSolver solver(grid.matrix, true);
  ASSERT_TRUE(solver.is_unsymmetric());
  ASSERT_TRUE(solver.factorise(grid.matrix.values()).is_usable);
  const Vector x = solver.solve(grid.rhs);
  const double scale = grid.dense.norm() * x.norm() + grid.rhs.norm();
  EXPECT_LT((grid.dense * x - grid.rhs).norm(), 1e-14 * scale);
  EXPECT_LT((grid.matrix.multiply(x) - grid.rhs).norm(), 1e-12 * grid.rhs.norm());
  EXPECT_GT((grid.dense.transpose() * x - grid.rhs).norm(), 1e-3 * grid.rhs.norm()) << "not the transposed";
  // A second matrix in the same pattern: the first analysis serves.
  const Grid other(-3.0, 5.0);
  ASSERT_TRUE(solver.factorise(other.matrix.values()).is_usable);
  EXPECT_LT((other.dense * solver.solve(other.rhs) - other.rhs).norm(), 1e-12 * other.rhs.norm());
}

TEST(UnsymmetricSolver, AgreesWithCholmodOnSymmetricMatrices) {
  const Grid grid(0.0, 0.0);
  ASSERT_EQ((grid.dense - grid.dense.transpose()).norm(), 0.0);
  LinearSolver symmetric(grid.matrix), whole(grid.matrix, true);
  ASSERT_TRUE(symmetric.factorise(grid.matrix.values()).is_usable);
  ASSERT_TRUE(whole.factorise(grid.matrix.values()).is_usable);
  EXPECT_FALSE(symmetric.is_unsymmetric());
  EXPECT_LT(compare(whole.solve(grid.rhs), symmetric.solve(grid.rhs)), 1e-10);
}

/// Of the signs of the pivots only their product is known: one negative eigenvalue shows, two do not.
TEST(UnsymmetricSolver, NegativeDeterminantIsANegativePivot) {
  for (const double shift : {0.0, -1e4}) {
    const Grid grid(0.0, shift);
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(grid.dense).eigenvalues();
    const auto negative = static_cast<int>((values.array() < 0.0).count());
    ASSERT_EQ(negative, shift < 0.0 ? 1 : 0);
    LinearSolver symmetric(grid.matrix), whole(grid.matrix, true);
    EXPECT_EQ(symmetric.factorise(grid.matrix.values()).negative_pivots, negative);
    EXPECT_EQ(whole.factorise(grid.matrix.values()).negative_pivots, negative);
  }
}

TEST(UnsymmetricSolver, SingularMatrixIsNotUsable) {
  const Grid grid(2.0, 0.0);
  const std::vector<double> zeros(grid.matrix.values().size(), 0.0);
  LinearSolver solver(grid.matrix, true);
  ASSERT_TRUE(solver.factorise(grid.matrix.values()).is_usable);
  EXPECT_FALSE(solver.factorise(zeros).is_usable);
}

}  // namespace
}  // namespace hydroscope
