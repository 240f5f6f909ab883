// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

// Tube of mid radius 30 and wall 1.5, M1, between two rigid rings. The reference is an axisymmetric
// membrane of the same law (logarithmic strain, J2, Swift; 80 graded elements per half, converged to
// 1e-4), solved apart from this program. A shell bends near the rings over a length of
// 1/lambda = 5 mm; the centre does not feel it.
struct Point {
  double displacement, pressure, thickness;  // thickness 0: not in the reference
};

void compare(const char* length, const std::vector<std::string>& assignments,
             const std::vector<Point>& points) {
  std::vector<std::string> all = assignments;
  all.push_back("load.volume_ratio=[[0, 1], [1, 1.5]]");
  const History h = run_scene("free-bulge.toml", all);
  EXPECT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  for (const Point& point : points) {
    const double p = h.value_at("pressure", "r_centre_mm", 30.0 + point.displacement);
    const double t = h.value_at("t_centre_mm", "r_centre_mm", 30.0 + point.displacement);
    EXPECT_LT(relative_error(p, point.pressure), 0.01) << "L " << length << " u " << point.displacement;
    const std::string at = std::string("_L") + length + "_u" + std::to_string(point.displacement);
    ::testing::Test::RecordProperty("p" + at, std::to_string(p));
    ::testing::Test::RecordProperty("t" + at, std::to_string(t));
    if (point.thickness == 0.0) continue;
    EXPECT_LT(relative_error(t, point.thickness), 0.01) << "L " << length << " u " << point.displacement;
  }
}

TEST(FreeBulge, LongTubeFollowsTheMembrane) {
  compare("120", {},
          {{2.0, 17.103, 1.40650}, {4.0, 17.619, 1.32007}, {6.0, 17.511, 1.23994}, {9.0, 16.952, 1.12902}});
}

TEST(FreeBulge, ShortTubeFollowsTheMembrane) {
  compare("90", {"tube.length_mm=90", "tube.grading_along=[[0, 2], [20, 1.5], [45, 0.5]]"},
          {{2.0, 17.314, 0.0},
           {3.0, 17.864, 1.36015},
           {5.0, 18.271, 1.27314},
           {6.0, 18.301, 1.23126},
           {9.0, 18.056, 1.11117}});
}

}  // namespace
}  // namespace hydroscope::verification
