// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/obstacle_course.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hydroscope::verification {
namespace {

/// The mesh at which a shell's displacement is within 1 % of its reference (seen: docs/verification.md).
struct Mesh {
  const char* name;
  int elements;  ///< a side
};

class ObstacleCourse : public ::testing::TestWithParam<Mesh> {};

/// Within 1 %, and settling: each halving of the elements changes the displacement by less than 0.7 of what
/// the one before did. (A second-order element would have 0.25; the corners under point loads settle slower.)
TEST_P(ObstacleCourse, ConvergesToItsReference) {
  const Obstacle& obstacle = find_obstacle(GetParam().name);
  const int n = GetParam().elements;
  const double coarse = obstacle.solve(n / 4), middle = obstacle.solve(n / 2), fine = obstacle.solve(n);
  EXPECT_NEAR(fine / obstacle.reference, 1.0, 0.01);
  EXPECT_LT(std::abs(fine - middle), 0.7 * std::abs(middle - coarse));
  RecordProperty("ratio", std::to_string(fine / obstacle.reference));
}

INSTANTIATE_TEST_SUITE_P(V2, ObstacleCourse,
                         ::testing::Values(Mesh{"scordelis_lo", 32}, Mesh{"pinched_cylinder", 48},
                                           Mesh{"hemisphere", 32}, Mesh{"hemisphere_with_hole", 64},
                                           Mesh{"twisted_beam_in_plane", 8},
                                           Mesh{"twisted_beam_out_of_plane", 8}),
                         [](const auto& obstacle) { return std::string(obstacle.param.name); });

}  // namespace
}  // namespace hydroscope::verification
