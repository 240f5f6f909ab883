// SPDX-License-Identifier: GPL-3.0-or-later
// When a node lets go of a tool: the full rule, or the sign of a force.
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "model_texts.h"

namespace hydroscope {
namespace {

/// A quarter of a tube blown into a round die and unloaded (V9), M1. In the die the strain rests and with it
/// the tension N = s t: the die takes p - N/r.
const std::string kRoundDie = R"([tube]
radius_mm = 30
thickness_mm = 1.5
length_mm = 4
section = "quarter"
extent = "slice"
elements_around = 9
[material]
youngs_modulus_MPa = 206e3
hardening = "swift"
swift_K_MPa = 550.0
swift_eps0 = 0.01
swift_n = 0.2
[load]
pressure_MPa = [[0, 0], [1, 30], [2, 0]]
[tool.die]
shape = "cylinder"
radius_mm = 32.703915
)";

constexpr std::size_t kNodes = 20;
/// Pressure at which the wall touches, and at which the die's force is spent again (V9), with chords of 10
/// degrees 0.1 % higher [MPa].
constexpr double kTouch = 16.9631;

struct Life {
  std::vector<IncrementReport> rows;
  std::vector<ContactEvent> let_go;
  std::vector<double> pressure_before;  ///< of the increments in which nodes let go [MPa]
  State state;
};

/// From `state` on, or from the start, to `until` [s] or for one increment.
Life live(const std::vector<std::string>& sets, double until, const State* start = nullptr) {
  const Model model = test::make_model(kRoundDie, sets);
  Life life;
  life.state = start != nullptr ? *start : make_initial_state(model);
  Scratch scratch(model, 1);
  do {
    const double before = life.state.pressure;
    life.rows.push_back(advance(model, life.state, scratch));
    const IncrementReport& report = life.rows.back();
    EXPECT_EQ(report.outcome, Outcome::kRunning) << report.message;
    if (report.outcome != Outcome::kRunning) break;
    for (const ContactEvent& e : report.events) {
      if (e.kind != EventKind::kDetach) continue;
      life.let_go.push_back(e);
      life.pressure_before.push_back(before);
    }
  } while (life.state.time < until * (1.0 - 1e-12));
  return life;
}

/// All pressed nodes have n . f_int = t_N - p A = -(N/r) A (mechanics 9.2): the sign of the internal force
/// lets them go at once, deep in the die, whatever the die's force is.
TEST(ReleaseTreatment, SignLetsPressedNodesGo) {
  const State pressed = live({}, 1.0).state;
  ASSERT_NEAR(pressed.pressure, 30.0, 1e-9);
  const Life next = live({"contact.release=sign"}, 0.0, &pressed);
  ASSERT_EQ(next.rows.size(), 1U);
  ASSERT_EQ(next.let_go.size(), kNodes);
  const double pressure = next.rows[0].pressure;
  EXPECT_GT(pressure, 28.0);
  for (const ContactEvent& e : next.let_go) {
    const double area = pressed.area[static_cast<std::size_t>(e.node)];
    EXPECT_EQ(e.cause, "sign rule");
    EXPECT_NEAR(e.force_before, (30.0 - kTouch) * area, 0.01 * (30.0 - kTouch) * area) << "pressed";
    EXPECT_NEAR(e.force_after, -kTouch * area, 0.01 * kTouch * area) << "n . f_int";
    EXPECT_NEAR(e.patch_pressure, pressure - kTouch, 0.03 * (pressure - kTouch));
    EXPECT_EQ(e.threshold, 0.0);
  }
  EXPECT_EQ(next.rows[0].n_contact, 0);
}

/// With the fluid subtracted, and by the full rule, nothing lets go before the force is spent; then all do.
TEST(ReleaseTreatment, FluidAndFullWaitForTheTouchPressure) {
  for (const std::string rule : {"fluid", "full"}) {
    const Life life = live({"contact.release=" + rule}, 2.0);
    ASSERT_EQ(life.let_go.size(), kNodes) << rule;
    for (std::size_t i = 0; i < kNodes; ++i) {
      const ContactEvent& e = life.let_go[i];
      EXPECT_GT(life.pressure_before[i], 0.998 * kTouch);
      EXPECT_GT(e.force_before, 0.0);
      EXPECT_LT(e.force_after, -e.threshold);
      EXPECT_LT(e.patch_pressure, 0.0);
      EXPECT_EQ(e.cause, rule == "full" ? "unloading" : "sign rule");
    }
  }
}

/// What tells these two from each other: a pull of half a per cent of the fluid's share is noise to the full
/// rule (1 %), and enough for the sign. Its threshold is that share of p A.
TEST(ReleaseTreatment, SmallPullIsNoiseToTheFullRuleOnly) {
  const std::vector<std::string> path = {"load.pressure_MPa=[[0, 0], [1, 30], [2, 16.9]]"};
  const auto with = [&](const std::string& rule, const std::string& tolerance) {
    std::vector<std::string> sets = path;
    sets.push_back("contact.release=" + rule);
    sets.push_back("contact.release_tolerance=" + tolerance);
    return live(sets, 2.0);
  };
  const Life full = with("full", "0.01");
  EXPECT_EQ(full.let_go.size(), 0U);
  EXPECT_EQ(full.rows.back().n_contact, static_cast<int>(kNodes));
  for (const ContactPoint& c : full.state.contacts[0]) {
    EXPECT_LT(c.normal_force, 0.0) << "it does pull";
  }
  const Life fluid = with("fluid", "0.01");
  ASSERT_EQ(fluid.let_go.size(), kNodes);
  EXPECT_EQ(fluid.let_go[0].threshold, 0.0);
  const Life fine = with("full", "0.001");
  ASSERT_EQ(fine.let_go.size(), kNodes);
  for (const ContactEvent& e : fine.let_go) {
    const double share = 16.9 * full.state.area[static_cast<std::size_t>(e.node)];
    EXPECT_NEAR(e.threshold, 0.001 * share, 0.02 * 0.001 * share);
    EXPECT_LT(e.force_after, -e.threshold);
  }
}

// Letting go waits where the corrector needs many passes, but not for long: on the hat-like die no node
// stands under a tension as large as the fluid's share for more than two increments in a row.
TEST(ReleaseTreatment, NobodyHangsOnTheDieForLong) {
  const Model model = build_model(read_scene("scenes/hat-die.toml"));
  Scratch scratch(model, 1);
  State state = make_initial_state(model);
  std::map<std::pair<std::size_t, std::size_t>, int> hanging;  // increments in a row, by tool and node
  int longest = 0;
  while (advance(model, state, scratch).outcome == Outcome::kRunning && state.time < model.end_time) {
    for (std::size_t t = 0; t < state.contacts.size(); ++t) {
      for (std::size_t i = 0; i < model.x0.size(); ++i) {
        const ContactPoint& point = state.contacts[t][i];
        const bool hangs = point.is_active() && point.normal_force < -2.0 * state.pressure * state.area[i];
        int& count = hanging[{t, i}];
        count = hangs ? count + 1 : 0;
        longest = std::max(longest, count);
      }
    }
  }
  EXPECT_GT(longest, 0);
  EXPECT_LE(longest, 2);
}

}  // namespace
}  // namespace hydroscope
