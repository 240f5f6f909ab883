// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/stability/gallery.h"

namespace hydroscope::stability {
namespace {

// Explicit steps without correction make the noise of the facets large. A rule that lets go whatever pulls
// opens and closes nodes all the time, and the die never gets to hold the wall: its corner stays round. With
// thresholds and patches the same steps hold. Newton's iteration with them is the default.
// Where such a run ends is chance: two meshes are counted together.
TEST(StabilityRelease, SignRuleChattersOnFacets) {
  int naive = 0, rule = 0;
  for (const char* elements : {"20", "30"}) {
    const std::vector<std::string> steps = {"increment.correction=none", "increment.smallest=3e-4",
                                            "tube.elements_around=" + std::string(elements)};
    std::vector<std::string> sign = steps;
    sign.emplace_back("contact.release=fluid");
    const History held = run_gallery("facet-noise.toml", steps);
    EXPECT_EQ(held.summary.outcome, Outcome::kCompleted) << held.summary.message;
    rule += count_events(held, EventKind::kRetouch);
    const History loose = run_gallery("facet-noise.toml", sign);
    naive += count_events(loose, EventKind::kRetouch);
    const History sound = run_gallery("facet-noise.toml", {steps.back()});
    ASSERT_EQ(sound.summary.outcome, Outcome::kCompleted) << sound.summary.message;
    EXPECT_EQ(count_events(sound, EventKind::kRetouch), 0) << elements;
    const std::string end = loose.summary.message + "; r45 " + std::to_string(loose.column("r45_mm").back()) +
                            " " + std::to_string(held.column("r45_mm").back()) + " " +
                            std::to_string(sound.column("r45_mm").back());
    RecordProperty("end_" + std::string(elements), end);
  }
  EXPECT_GT(naive, 500);
  EXPECT_LT(rule, 100);
  RecordProperty("retouches", std::to_string(naive) + " " + std::to_string(rule));
}

// V9: n . f_int = t_N - p A is a pull on every node in the hollow. With the fluid subtracted all touch once
// and leave together.
TEST(StabilityRelease, FluidMustBeSubtracted) {
  const History naive = run_gallery("backed-wall.toml", {"contact.release=sign"});
  EXPECT_NE(naive.summary.outcome, Outcome::kCompleted);
  EXPECT_LT(naive.summary.time, 1.0) << "it should not get to the top of the pressure";

  const History sound = run_gallery("backed-wall.toml");
  ASSERT_EQ(sound.summary.outcome, Outcome::kCompleted) << sound.summary.message;
  const int nodes = static_cast<int>(sound.states.back()->points.size());
  EXPECT_EQ(count_events(sound, EventKind::kTouch), nodes);
  EXPECT_EQ(count_events(sound, EventKind::kDetach), nodes);
  EXPECT_EQ(count_events(sound, EventKind::kRetouch), 0);
  // 30 MPa of fluid less the 16.963 MPa that the wall itself bears.
  EXPECT_LT(relative_error(sound.value_at("contact_pressure_MPa", "time", 1.0), 30.0 - 16.963), 0.02);
  EXPECT_NEAR(sound.column("r_mm").back(), 31.94554, 0.005);
  RecordProperty("end_of_naive",
                 std::to_string(naive.rows.back().pressure) + " MPa: " + naive.summary.message);
  RecordProperty("contact_pressure", std::to_string(sound.value_at("contact_pressure_MPa", "time", 1.0)));
}

}  // namespace
}  // namespace hydroscope::stability
