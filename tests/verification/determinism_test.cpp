// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

TEST(Determinism, HistoryIsTheSameBitForBitForOneAndTwoThreads) {
  const std::vector<std::string> coarse = {"tube.elements_around=10", "tube.elements_along=8",
                                           "tool.die.friction=0.1", "load.pressure_MPa=[[0, 0], [1, 20]]"};
  const History one = run_scene("job-b-3d.toml", coarse, 1);
  const History two = run_scene("job-b-3d.toml", coarse, 2);
  ASSERT_GT(one.rows.size(), 10u);
  ASSERT_GT(one.rows.back().n_contact, 0);
  ASSERT_EQ(one.rows.size(), two.rows.size());
  for (std::size_t i = 0; i < one.rows.size(); ++i) {
    const IncrementReport &a = one.rows[i], &b = two.rows[i];
    EXPECT_EQ(a.time, b.time);  // exactly: not within a few units in the last place
    EXPECT_EQ(a.pressure, b.pressure);
    EXPECT_EQ(a.residual, b.residual);
    EXPECT_EQ(a.thickness_min, b.thickness_min);
    EXPECT_EQ(a.thickness_max, b.thickness_max);
    EXPECT_EQ(a.quantities, b.quantities);
    EXPECT_EQ(a.iterations, b.iterations);
    EXPECT_EQ(a.n_stick, b.n_stick);
    EXPECT_EQ(a.events.size(), b.events.size());
  }
}

}  // namespace
}  // namespace hydroscope::verification
