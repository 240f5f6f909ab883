// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of friction: within the increment, one step behind it, or pseudo-stick alone (V23).
#include <gtest/gtest.h>

#include <cmath>

#include "model_texts.h"

namespace hydroscope {
namespace {

const Vec3 kNormal = Vec3(0.2, -0.4, 0.7).normalized();
const Vec3 kAlong = kNormal.cross(Vec3::UnitX()).normalized(), kAcross = kNormal.cross(kAlong);
constexpr double kStick = 1e4, kMu = 0.1, kPress = 300.0, kLimit = kMu * kPress;  // slips after 3e-3 mm
constexpr double kShortest = 1e-6;

// ---------------------------------------------------------------- the law by itself

/// While it sticks, the elastic trial counts whatever its size; while it slips, nothing changes but the
/// plane.
TEST(LaggingFriction, SticksElasticallyAndSlipsUnchanged) {
  const Vec3 start = 12.0 * kAcross, slide = 0.05 * kAlong + 0.3 * kNormal;
  const FrictionResult stuck = calc_lagging_friction(start, false, slide, kNormal, kStick);
  EXPECT_FALSE(stuck.is_slipping);
  EXPECT_LT((stuck.force - (start - kStick * 0.05 * kAlong)).norm(), 1e-10);  // 500 N, far above mu t_N
  EXPECT_LT((stuck.stiffness - kStick * (Mat3::Identity() - kNormal * kNormal.transpose())).norm(), 1e-9);
  const FrictionResult slipping = calc_lagging_friction(start, true, slide, kNormal, kStick);
  EXPECT_TRUE(slipping.is_slipping);
  EXPECT_LT((slipping.force - start).norm(), 1e-13);
  EXPECT_EQ(slipping.stiffness.norm(), 0.0);
}

/// (4.46) at the end of the increment, to the last digits, and (4.47): against the sliding, of the size mu
/// t_N.
TEST(LaggingFriction, RenewedAtTheCircleOnly) {
  const Vec3 slide = 0.01 * (0.6 * kAlong + 0.8 * kAcross) + 0.2 * kNormal;
  const auto renew = [&](const Vec3& force, bool slips, const Vec3& by, double press = kPress) {
    return renew_lagging_friction(force, slips, by, kNormal, press, kMu, kShortest);
  };
  const FrictionResult inside = renew(-kLimit * (1.0 - 1e-12) * kAlong, false, slide);
  EXPECT_FALSE(inside.is_slipping);
  EXPECT_EQ((inside.force + kLimit * (1.0 - 1e-12) * kAlong).norm(), 0.0);
  const FrictionResult outside = renew(-kLimit * (1.0 + 1e-12) * kAlong, false, slide);
  EXPECT_TRUE(outside.is_slipping);
  EXPECT_LT((outside.force + kLimit * (0.6 * kAlong + 0.8 * kAcross)).norm(), 1e-12 * kLimit);
  // Slipping, it follows direction and normal force.
  const FrictionResult pressed = renew(outside.force, true, slide, 2.0 * kPress);
  EXPECT_LT((pressed.force - 2.0 * outside.force).norm(), 1e-12 * kLimit);
  EXPECT_EQ(renew(outside.force, true, slide, -5.0).force.norm(), 0.0) << "nothing that pulls rubs";
  // Where it has hardly moved, the direction stays.
  EXPECT_LT(
      (renew(-kLimit * kAlong, true, 1e-7 * kAcross, 0.5 * kPress).force + 0.5 * kLimit * kAlong).norm(),
      1e-12 * kLimit);
  // Driven along its own friction force it has turned round: it sticks, with the force that it has.
  const FrictionResult turned = renew(-kLimit * kAlong, true, -slide);
  EXPECT_FALSE(turned.is_slipping);
  EXPECT_LT((turned.force + kLimit * kAlong).norm(), 1e-12 * kLimit);
}

/// A block that is pushed by steps of 1e-3 mm along and back: 10 N a step.
struct Block {
  void step(double by) {
    const Vec3 slide = by * kAlong;
    const FrictionResult now = calc_lagging_friction(force, slips, slide, kNormal, kStick);
    carried = now.force.dot(kAlong);
    const FrictionResult renewed =
        renew_lagging_friction(now.force, now.is_slipping, slide, kNormal, kPress, kMu, kShortest);
    force = renewed.force;
    slips = renewed.is_slipping;
    returned = calc_friction(returned, slide, kNormal, kPress, kMu, kStick).force;
  }
  Vec3 force = Vec3::Zero(), returned = Vec3::Zero();
  double carried = 0.0;  ///< within the increment, along the motion
  bool slips = false;
};

/// Stick, slip, turn, stick, slip the other way. One step behind, the force overshoots the circle by up to a
/// step before it is brought back, and after the turn pushes on for one increment; return mapping does
/// neither.
TEST(LaggingFriction, LagsByOneIncrementWhereReturnMappingDoesNot) {
  Block block;
  const auto expect = [&](double by, double carried, double after, double returned) {
    block.step(by);
    EXPECT_NEAR(block.carried, carried, 1e-9);
    EXPECT_NEAR(block.force.dot(kAlong), after, 1e-9);
    EXPECT_NEAR(block.returned.dot(kAlong), returned, 1e-9);
  };
  expect(0.9e-3, -9.0, -9.0, -9.0);
  expect(0.9e-3, -18.0, -18.0, -18.0);
  expect(0.9e-3, -27.0, -27.0, -27.0);
  EXPECT_FALSE(block.slips);
  expect(0.9e-3, -36.0, -30.0, -30.0);
  EXPECT_TRUE(block.slips);
  expect(5e-3, -30.0, -30.0, -30.0);
  expect(-0.9e-3, -30.0, -30.0, -21.0);
  EXPECT_FALSE(block.slips);
  expect(-0.9e-3, -21.0, -21.0, -12.0);
  for (int i = 0; i < 5; ++i) block.step(-0.9e-3);
  EXPECT_NEAR(block.force.dot(kAlong), 24.0, 1e-9);
  expect(-0.9e-3, 33.0, 30.0, 30.0);
  EXPECT_TRUE(block.slips);
  expect(-0.9e-3, 30.0, 30.0, 30.0);
}

// ---------------------------------------------------------------- a strip on a plane

/// A strip 4 mm long and 2 mm wide is pressed onto the plane y = 0 by 10 MPa, drawn by its end, held, drawn
/// back and on again. It is stiff against its friction. The end's nodes are held off the plane by their
/// support; the rest, 6 mm^2, carries 60 N and rubs with 6 N.
const std::string kStripScene = R"([strip]
thickness_mm = 1.5
width_mm = 2
start_mm = [0, 0.75]
lead_in_mm = 4
elements_lead_in = 2
)" + test::kElastic + R"([load]
pressure_MPa = [[0, 0], [0.5, 10], [9, 10]]
[edge.start]
hold = ["rotation"]
[edge.end]
hold = ["y", "rotation"]
move_x_mm = [[0, 0], [1, 0], [1.5, 3.6e-5], [2, 7.2e-4], [4, 0.02], [5, 0.02], [7, 0], [9, 0.02]]
[tool.plane]
shape = "plane"
direction = [0, 1, 0]
friction = 0.1
[contact]
wall_stiffness = 0
[increment]
largest = 0.02
initial_s = 0.1
tolerance = 1e-6
)";

/// One increment: sums over the nodes that rub.
struct Row {
  double time = 0.0;
  double force = 0.0;    ///< friction on the strip along x [N]
  double normal = 0.0;   ///< [N]
  double elastic = 0.0;  ///< -E_t times the sliding since 1 s, E_t = 0.1 E/h per area (4.45) [N]
  double excess = 0.0;   ///< largest |f| / (mu t_N) of a node
  IncrementReport report;
};

std::vector<Row> pull(const std::string& law, double until) {
  const Model model = test::make_model(kStripScene, {"contact.friction_law=" + law});
  State state = make_initial_state(model);
  Scratch scratch(model, 1);
  std::vector<Row> rows;
  std::vector<double> start(model.x0.size(), 0.0);
  while (state.time < until * (1.0 - 1e-12)) {
    Row row;
    row.report = advance(model, state, scratch);
    EXPECT_EQ(row.report.outcome, Outcome::kRunning) << row.report.message;
    if (row.report.outcome != Outcome::kRunning) break;
    row.time = state.time;
    for (std::size_t i = 0; i < start.size(); ++i) {
      const ContactPoint& c = state.contacts[0][i];
      if (c.held_row < 0) continue;
      const double area = std::abs(model.x0[i].x() - 2.0) < 1.0 ? 2.0 : 1.0;
      if (state.time <= 1.0) start[i] = c.position.x();
      row.force += c.friction.x();
      row.normal += c.normal_force;
      row.elastic -= 0.1 * 206e3 / 1.5 * area * (c.position.x() - start[i]);
      row.excess = std::max(row.excess, c.friction.norm() / (kMu * c.normal_force));
    }
    rows.push_back(row);
  }
  return rows;
}

/// The first increment that ends after `time`, or the `later`-th after it.
const Row& at(const std::vector<Row>& rows, double time, std::size_t later = 0) {
  std::size_t i = 0;
  while (i + 1 < rows.size() && rows[i].time <= time * (1.0 + 1e-12)) ++i;
  return rows.at(i + later);
}

/// Rises with E_t; on the circle at once and never beyond it; rests where it is while nothing moves; turns
/// within the increment that turns.
TEST(FrictionTreatment, ReturnMappingIsOnTheCircleWithinTheIncrement) {
  const auto rows = pull("return-mapping", 9.0);
  const Row &begin = at(rows, 0.999), &stuck = at(rows, 1.499);
  EXPECT_EQ(stuck.report.n_slip, 0);
  EXPECT_NEAR(stuck.force - begin.force, stuck.elastic - begin.elastic, 1e-4 * std::abs(stuck.elastic));
  for (const Row& row : rows) {
    EXPECT_LE(row.excess, 1.0 + 1e-4) << row.time;
    EXPECT_LE(row.report.residual, 1e-6);
    const bool goes_on = (row.time > 1.7 && row.time <= 4.0) || row.time > 7.0;
    const bool goes_back = row.time > 5.0 && row.time <= 7.0;
    if (goes_on || goes_back) {
      EXPECT_NEAR(row.force, (goes_back ? kMu : -kMu) * row.normal, 1e-3) << row.time;
    }
  }
  EXPECT_EQ(at(rows, 4.0).report.n_slip, 0) << "held: it sticks";
  EXPECT_NEAR(at(rows, 4.0).force, at(rows, 3.999).force, 6e-5);  // the tolerance times 60 N
}

/// (4.47), (4.48): who slips carries mu t_N of its own increment's end, exactly, but learns of it at that end
/// only. That it turns costs one increment in which the force still pushes it on, and one in which it sticks.
TEST(FrictionTreatment, OneStepBehindLags) {
  const auto rows = pull("one-step-behind", 9.0);
  double residual = 0.0;
  for (const Row& row : rows) {
    residual = std::max(residual, row.report.residual);
    if (row.time > 1.7 && row.time <= 4.0) {
      EXPECT_EQ(row.report.n_stick, 0);
      EXPECT_NEAR(row.force, -kMu * row.normal, 1e-9) << row.time;
    }
  }
  EXPECT_GT(residual, 1e-3) << "what (4.48) finds at the end of an increment is left for the next one";
  const Row &last = at(rows, 4.999), &turned = at(rows, 5.0), &after = at(rows, 5.0, 1);
  EXPECT_NEAR(turned.force, last.force, 1e-6) << "the old force, in the wrong direction";
  EXPECT_EQ(turned.report.n_slip, 0);
  EXPECT_NEAR(after.force, kMu * after.normal, 1e-9);
  EXPECT_EQ(after.report.n_stick, 0);
  EXPECT_NEAR(at(rows, 6.0).force, kMu * at(rows, 6.0).normal, 1e-9);
  EXPECT_NEAR(at(rows, 8.0).force, -kMu * at(rows, 8.0).normal, 1e-9);
}

/// (4.48) has the sign of (4.24): what the circle takes off a force against the motion is left as a force
/// along it. Everything else is solved for in explicit steps.
TEST(FrictionTreatment, WhatIsTakenOffPushesAlongTheMotion) {
  const Model model =
      test::make_model(kStripScene, {"contact.friction_law=one-step-behind", "increment.correction=algoneq",
                                     "increment.algoneq_passes=5", "increment.stop_at=[]"});
  State state = make_initial_state(model);
  Scratch scratch(model, 1);
  double pushes = 0.0;
  while (state.time < 2.0 * (1.0 - 1e-12)) {
    ASSERT_EQ(advance(model, state, scratch).outcome, Outcome::kRunning);
    if (state.time <= 1.5) continue;
    double sum = 0.0;
    for (const Eigen::Index i : {0, 1, 3, 4}) sum += state.unbalanced[kDofs * i];  // not the held end
    if (std::abs(sum) > std::abs(pushes)) pushes = sum;
  }
  EXPECT_GT(pushes, 0.5);
}

/// Pseudo-stick alone: the force follows the sliding for ever, far over the circle.
TEST(FrictionTreatment, StickNeverSlips) {
  const auto rows = pull("stick", 2.0);
  const Row& begin = at(rows, 0.999);
  for (const Row& row : rows) {
    EXPECT_EQ(row.report.n_slip, 0) << row.time;
    if (row.time <= 1.0) continue;
    EXPECT_NEAR(row.force - begin.force, row.elastic, 1e-4 * std::abs(row.elastic)) << row.time;
  }
  EXPECT_GT(rows.back().excess, 5.0);
}

}  // namespace
}  // namespace hydroscope
