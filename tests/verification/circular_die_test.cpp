// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/verification/plane_strain_ring.h"
#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

// Tube of mid radius 30 and wall 1.5, M1, blown into a frictionless round die and unloaded, plane
// strain. The wall touches when its mid radius is 32: eth = ln(32/30). In the die the strain rests,
// so the tension N = s_th t rests too and the die takes p - N/r. Falling back to N/r, all nodes let
// go; then the wall is elastic in plane strain: dr/r = -(1 - nu^2) s_th / E to first order.
class CircularDie : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    history_ = new History(run_scene("circular-die.toml", {"quantity.force_N_per_mm.kind=contact_force",
                                                           "quantity.force_N_per_mm.tool=die"}));
  }
  static void TearDownTestSuite() { delete history_; }
  static double calc_touch_pressure() {
    const double strain = std::log(32.0 / 30.0);
    const WallState s = PlaneStrainWall(kM1, 0.1).at(strain);
    return s.hoop_stress * 1.5 * std::exp(-s.thinning) / 32.0;
  }
  static History* history_;
};
History* CircularDie::history_ = nullptr;

TEST_F(CircularDie, TouchesAtTheRingsPressure) {
  ASSERT_EQ(history_->summary.outcome, Outcome::kCompleted) << history_->summary.message;
  EXPECT_LT(relative_error(calc_touch_pressure(), 16.9631), 2e-5);
  const auto& rows = history_->rows;
  const auto p = history_->column("pressure"), f = history_->column("force_N_per_mm");
  std::size_t first = 0;
  while (first + 1 < rows.size() && rows[first].n_contact == 0) ++first;
  ASSERT_LT(first + 1, rows.size()) << "never touched";
  for (const ContactEvent& event : rows[first].events) EXPECT_EQ(event.kind, EventKind::kTouch);
  EXPECT_EQ(rows[first].events.size(), 92u) << "all at once";
  // The increment of touching ends a little beyond it: the die's force, drawn back to zero, says where.
  const double touch = p[first] - f[first] * (p[first + 1] - p[first]) / (f[first + 1] - f[first]);
  EXPECT_LT(relative_error(touch, calc_touch_pressure()), 0.002);
  RecordProperty("touch_pressure_MPa", std::to_string(touch));
}

TEST_F(CircularDie, DieTakesThePressureBeyondTouch) {
  const auto p = history_->column("pressure"), c = history_->column("contact_pressure_MPa");
  int compared = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double wanted = p[i] - calc_touch_pressure();
    if (wanted < 2.0) continue;  // below, 0.2 % of the touch pressure is more than 1 % of the difference
    EXPECT_NEAR(c[i], wanted, 0.01 * wanted) << "at " << p[i] << " MPa";
    ++compared;
  }
  EXPECT_GT(compared, 10);
  const auto highest = static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin());
  RecordProperty("contact_pressure_at_30_MPa", std::to_string(c[highest]));
}

TEST_F(CircularDie, AllNodesLetGoTogetherAndOnce) {
  std::map<int, int> touches, releases;
  int increments_with_release = 0;
  double pressure_before = 0.0;
  for (const IncrementReport& row : history_->rows) {
    bool any = false;
    for (const ContactEvent& event : row.events) {
      if (event.kind == EventKind::kTouch || event.kind == EventKind::kRetouch) ++touches[event.node];
      if (event.kind == EventKind::kDetach) {
        ++releases[event.node];
        any = true;
      }
    }
    if (any) {
      ++increments_with_release;
      // Somewhere between the two ends of this increment the patch's force passed zero.
      EXPECT_LT(row.pressure, 1.005 * calc_touch_pressure());
      EXPECT_GT(pressure_before, 0.995 * calc_touch_pressure());
      EXPECT_EQ(row.n_contact, 0);
      RecordProperty("pressure_before_release_MPa", std::to_string(pressure_before));
      RecordProperty("pressure_after_release_MPa", std::to_string(row.pressure));
    }
    pressure_before = row.pressure;
  }
  EXPECT_EQ(increments_with_release, 1);
  EXPECT_EQ(releases.size(), 92u);  // two rows of 46 nodes
  for (const auto& [node, count] : touches) EXPECT_EQ(count, 1) << "node " << node;
  for (const auto& [node, count] : releases) EXPECT_EQ(count, 1) << "node " << node;
}

TEST_F(CircularDie, PatchForceFallsToZeroAtTheTouchPressure) {
  const auto p = history_->column("pressure"), f = history_->column("force_N_per_mm");
  const auto turn = static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin());
  std::size_t last = turn;
  while (last + 1 < p.size() && f[last + 1] > 0.0) ++last;
  ASSERT_GT(last, turn + 1);
  const double zero = p[last] - f[last] * (p[last] - p[last - 1]) / (f[last] - f[last - 1]);
  EXPECT_LT(relative_error(zero, calc_touch_pressure()), 0.005);
  RecordProperty("force_crosses_zero_at_MPa", std::to_string(zero));
}

TEST_F(CircularDie, SpringsBackElastically) {
  EXPECT_NEAR(history_->column("pressure").back(), 0.0, 1e-9);
  EXPECT_NEAR(history_->column("r_mid_mm").back(), 31.94554, 0.002);
  RecordProperty("free_radius_mm", std::to_string(history_->column("r_mid_mm").back()));
}

}  // namespace
}  // namespace hydroscope::verification
