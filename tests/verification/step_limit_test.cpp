// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verification/plane_strain_ring.h"
#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

int count_limited(const History& h, Limiter by) {
  return static_cast<int>(std::count_if(h.rows.begin(), h.rows.end(),
                                        [&](const IncrementReport& row) { return row.limited_by == by; }));
}

const IncrementReport* find_limited(const History& h, Limiter by) {
  const auto row = std::find_if(h.rows.begin(), h.rows.end(),
                                [&](const IncrementReport& r) { return r.limited_by == by; });
  return row == h.rows.end() ? nullptr : &*row;
}

// r1: the tube of circular-die (M1, R 30, t 1.5) begins to yield in plane strain at
// s_th = s_y / sqrt(1 - nu + nu^2), s_y = 550 0.01^0.2; the inner layers, nearer to the axis by t/2, a little
// before the mean p = s_th t / R.
TEST(StepLimit, EndsAnIncrementAtFirstYield) {
  const History h =
      run_scene("circular-die.toml", {"increment.stop_at=[\"yield\"]", "stop.quantity=radius_mm",
                                      "stop.above=30.2", "quantity.radius_mm.kind=radius"});
  const IncrementReport* row = find_limited(h, Limiter::kYield);
  ASSERT_NE(row, nullptr) << h.summary.message;
  const double hoop = 550.0 * std::pow(0.01, 0.2) / std::sqrt(1.0 - 0.3 + 0.09);
  const double inner =
      1.0 + 0.906 * 1.5 / (2.0 * 30.0);  // strain of the innermost of five layers over the mean
  EXPECT_NEAR(row->pressure, hoop * 1.5 / 30.0 / inner, 0.01 * hoop * 1.5 / 30.0);
  EXPECT_GE(row->limited_at, 0);
}

// r5: unloading stops where the die's force is spent, and not up to a whole increment (1.2 MPa) later.
TEST(StepLimit, EndsAnIncrementWhereContactIsSpent) {
  const History h = run_scene("circular-die.toml", {"increment.stop_at=[\"release\"]"});
  const IncrementReport* row = find_limited(h, Limiter::kRelease);
  ASSERT_NE(row, nullptr) << h.summary.message;
  const WallState s = PlaneStrainWall(kM1, 0.1).at(std::log(32.0 / 30.0));
  const double touch = s.hoop_stress * 1.5 * std::exp(-s.thinning) / 32.0;
  EXPECT_LT(relative_error(row->pressure, touch), 0.005);
}

// r6: with friction the first sticking nodes leave the slip circle; without the event nothing is limited by
// it.
TEST(StepLimit, EndsAnIncrementAtTheSlipCircle) {
  const std::vector<std::string> short_path = {"tool.die.friction=0.1", "load.pressure_MPa=[[0, 0], [1, 6]]"};
  std::vector<std::string> with = short_path;
  with.push_back("increment.stop_at=[\"slip\"]");
  EXPECT_GT(count_limited(run_scene("square-die-thin.toml", with), Limiter::kStickToSlip), 0);
  EXPECT_EQ(count_limited(run_scene("square-die-thin.toml", short_path), Limiter::kStickToSlip), 0);
}

}  // namespace
}  // namespace hydroscope::verification
