// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

/// T_end / T_start over the nodes that touch, each with the angles that it has. The strip comes in at an
/// angle a and leaves at an angle b to the drum's tangent at the node: across it N = T1 sin a + T2 sin b,
/// along it T2 cos b = T1 cos a + mu N, hence T2 / T1 = (cos a + mu sin a) / (cos b - mu sin b). With
/// a = b = d/2 this is (1 + mu tan(d/2)) / (1 - mu tan(d/2)).
double calc_discrete_ratio(const Snapshot& s, double mu) {
  double ratio = 1.0;
  const std::size_t nodes = s.points.size() / 2;  // of one edge of the strip, from its start to its end
  for (std::size_t i = 1; i + 1 < nodes; ++i) {
    if (s.contact_state[i] == ContactClass::kFree) continue;
    const Vec3 in = (s.points[i] - s.points[i - 1]).normalized(),
               out = (s.points[i + 1] - s.points[i]).normalized();
    const Vec3& n = s.tool_normal[i];  // away from the drum
    const double sin_a = in.dot(n), sin_b = -out.dot(n);
    ratio *= (std::sqrt(1.0 - sin_a * sin_a) + mu * sin_a) / (std::sqrt(1.0 - sin_b * sin_b) - mu * sin_b);
  }
  return ratio;
}

TEST(Capstan, TensionsHaveTheDiscreteRatio) {
  for (const double mu : {0.1, 0.2}) {
    const History h = run_scene("capstan.toml", {"tool.drum.friction=" + std::to_string(mu)});
    ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
    const Snapshot& end = *h.states.back();
    // All that touches slides, and obeys Coulomb's law.
    for (std::size_t i = 0; i < end.points.size(); ++i) {
      if (end.contact_state[i] == ContactClass::kFree) continue;
      EXPECT_EQ(end.contact_state[i], ContactClass::kSlip) << "node " << i;
      const double normal = end.contact_force[i].dot(end.tool_normal[i]);
      const double friction = (end.contact_force[i] - normal * end.tool_normal[i]).norm();
      EXPECT_NEAR(friction, mu * normal, 1e-3 * mu * normal) << "node " << i;
    }
    const double ratio = h.column("force_ratio").back(), discrete = calc_discrete_ratio(end, mu),
                 smooth = std::exp(mu * std::numbers::pi / 2.0);
    EXPECT_LT(relative_error(ratio, discrete), 0.001);
    EXPECT_LT(relative_error(ratio, smooth), 0.002) << "18 nodes turn 90 degrees";
    const std::string at = "_mu_" + std::to_string(static_cast<int>(std::lround(100.0 * mu)));
    RecordProperty("force_ratio" + at, std::to_string(ratio) + " discrete " + std::to_string(discrete) +
                                           " smooth " + std::to_string(smooth));
  }
}

// V19 on coarse strips: with few nodes the discrete ratio is far from exp(mu theta), and it is the one to
// meet.
TEST(Capstan, CoarseStripsHaveTheirOwnRatios) {
  for (const double mu : {0.1, 0.2}) {
    for (const int elements : {3, 9}) {
      const History h = run_scene("capstan.toml", {"tool.drum.friction=" + std::to_string(mu),
                                                   "strip.elements_arc=" + std::to_string(elements),
                                                   "strip.thickness_mm=0.01", "tool.drum.radius_mm=20.005"});
      ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
      const double ratio = h.column("force_ratio").back(),
                   discrete = calc_discrete_ratio(*h.states.back(), mu);
      EXPECT_LT(relative_error(ratio, discrete), 0.001) << elements << " elements, mu " << mu;
      RecordProperty("mu_" + std::to_string(mu) + "_elements_" + std::to_string(elements),
                     std::to_string(ratio) + " discrete " + std::to_string(discrete));
    }
  }
}

// The loaded edge has no support along its pull: its force is the line load and what little holds it
// across. The drawn one's is the reaction. Without friction the strip's angles alone tell them apart.
TEST(Capstan, EdgeForceCountsLoadsAndReactions) {
  const History h = run_scene("capstan.toml", {"tool.drum.friction=0"});
  ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  EXPECT_NEAR(h.column("tension_start_N_per_mm").back(), 5.0, 1e-3);
  const double ratio = h.column("force_ratio").back(), discrete = calc_discrete_ratio(*h.states.back(), 0.0);
  EXPECT_LT(relative_error(ratio, discrete), 2e-4);
  RecordProperty("force_ratio", std::to_string(ratio) + " discrete " + std::to_string(discrete));
}

}  // namespace
}  // namespace hydroscope::verification
