// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/stability/gallery.h"

namespace hydroscope::stability {
namespace {

// All slides from 0.1 mm after each turn on. The strip is not limp: bending costs up to 0.6 % on the way on.
TEST(StabilityReversal, TensionTurnsWithTheSlidingAndStaysThere) {
  const double forward = std::exp(0.2 * std::numbers::pi / 2.0);
  const History h = run_gallery("reversal.toml");
  ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  const Range on = calc_range(h, "force_ratio", 0.35, 1.0), back = calc_range(h, "force_ratio", 1.1, 2.0),
              again = calc_range(h, "force_ratio", 2.1, 3.0);
  for (const Range* r : {&on, &again}) {
    EXPECT_GT(r->low, 0.99 * forward);
    EXPECT_LT(r->high, 1.01 * forward);
  }
  EXPECT_GT(back.low, 0.99 / forward);
  EXPECT_LT(back.high, 1.01 / forward);
  RecordProperty("ratios", std::to_string(on.low) + " to " + std::to_string(on.high) + ", " +
                               std::to_string(back.low) + " to " + std::to_string(back.high) + ", " +
                               std::to_string(again.low) + " to " + std::to_string(again.high));
}

}  // namespace
}  // namespace hydroscope::stability
