// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/solver/model_texts.h"

namespace hydroscope {
namespace {

const std::string kOctant = R"([tube]
radius_mm = 30
thickness_mm = 1.5
length_mm = 2
section = "octant"
extent = "slice"
elements_around = 6
)" + test::kElastic + R"([load]
pressure_MPa = [[0.0, 0.0], [1.0, 1.0]]
)";

/// A fibre that has left its symmetry plane is brought back, not farther away, on the inclined plane too.
TEST(Symmetry, FibresReturnToTheirPlane) {
  const Model model = test::make_model(kOctant);
  State state = make_initial_state(model);
  Scratch scratch(model, 1);
  constexpr std::size_t kOnDiagonal = 6;
  const Vec3 across = Vec3(-1, 1, 0).normalized();
  Triad& t = state.configuration.triad[kOnDiagonal];
  const Mat3 tilt = Eigen::AngleAxisd(1e-4, Vec3::UnitZ()).toRotationMatrix();
  t = {tilt * t.v1, tilt * t.v2, tilt * t.v};
  ASSERT_GT(std::abs(t.v.dot(across)), 9e-5);
  const IncrementReport report = advance(model, state, scratch);
  ASSERT_GT(report.increment, 0) << report.message;
  // One Newton pass on a rotation of 1e-4 leaves its square.
  EXPECT_LT(std::abs(state.configuration.triad[kOnDiagonal].v.dot(across)), 1e-8);
}

/// Mirror planes look away from the part, so that tools can be cut at them.
TEST(Symmetry, MirrorsPointOutOfTheModelledPart) {
  const Model model = test::make_model(kOctant);
  ASSERT_EQ(model.mirrors.size(), 3U);
  for (const Plane& plane : model.mirrors) {
    for (const Vec3& x : model.x0) EXPECT_LE(plane.normal.dot(x - plane.point), 1e-9);
  }
}

}  // namespace
}  // namespace hydroscope
