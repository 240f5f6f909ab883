// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/stability/gallery.h"

namespace hydroscope::stability {
namespace {

/// How far the wall falls back from a crest, walking from the centre to the end over z < `reach` [mm]; the
/// way down to the clamped end does not count: a valley needs a crest on both sides.
double calc_deepest_valley(const Snapshot& state, double reach) {
  std::vector<std::pair<double, double>> profile;  // z and r
  for (const Vec3& x : state.points) {
    if (x[2] < reach) profile.emplace_back(x[2], x.head<2>().norm());
  }
  std::sort(profile.begin(), profile.end());
  double deepest = 0.0;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    double before = 0.0, behind = 0.0;
    for (std::size_t j = 0; j < profile.size(); ++j) {
      double& side = j < i ? before : behind;
      side = std::max(side, profile[j].second);
    }
    deepest = std::max(deepest, std::min(before, behind) - profile[i].second);
  }
  return deepest;
}

// The same feed of 6 mm. At 2 MPa, a quarter of what makes the wall yield, it folds near the clamped end; at
// 8 to 12 MPa the wall lies against its die and the feed becomes thickness.
TEST(StabilityWrinkling, FeedWithoutPressureFolds) {
  const History naive =
      run_gallery("wrinkling.toml", {"load.pressure_MPa=[[0.0, 0.0], [0.1, 2.0], [1.0, 2.0]]"});
  ASSERT_EQ(naive.summary.outcome, Outcome::kCompleted) << naive.summary.message;
  const History sound = run_gallery("wrinkling.toml");
  ASSERT_EQ(sound.summary.outcome, Outcome::kCompleted) << sound.summary.message;
  const double fold = calc_deepest_valley(*naive.states.back(), 50.0),
               rest = calc_deepest_valley(*sound.states.back(), 50.0);
  EXPECT_GT(fold, 2.0);
  EXPECT_LT(rest, 0.1);
  RecordProperty("valley", std::to_string(fold) + " " + std::to_string(rest));
}

}  // namespace
}  // namespace hydroscope::stability
