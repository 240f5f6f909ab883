// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

// Tube T, plane strain, perfectly plastic. The yield stress is small, so that the limit is reached at a hoop
// strain of a few 1e-4: the growing radius takes less than 0.1 % of it.
const char* const kScene = R"(
[tube]
radius_mm = 30.0
thickness_mm = 1.5
length_mm = 2.0
section = "quarter"
extent = "slice"
elements_around = 48
[material]
youngs_modulus_MPa = 206e3
poisson = 0.3
hardening = "perfect"
yield_stress_MPa = 20.0
[load]
control = "volume"
volume_ratio = [[0.0, 1.0], [1.0, 1.0008]]
)";

double find_largest_pressure(const std::vector<std::string>& keys) {
  const History h = run_text(kScene, keys);
  EXPECT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  const auto p = h.column("pressure");
  return *std::max_element(p.begin(), p.end());
}

/// V7: a thick tube bears p_L = (2/sqrt3) sy ln(b/a). A plane-stress shell with the pressure on its
/// mid-surface bears (2/sqrt3) sy t/r, which is the same to (t/r)^2/12; with it on the inner face (2/sqrt3)
/// sy t/a, t/2r too much; with the mean stress through the wall in the yield function it is right again
/// (mechanics 3.3).
TEST(LimitPressure, DependsOnTheSurfaceThatCarriesTheFluid) {
  const double unit = 2.0 / std::sqrt(3.0) * 20.0, exact = unit * std::log(30.75 / 29.25);
  const double mid = find_largest_pressure({}),
               inner = find_largest_pressure({"load.pressure_surface=inner"}),
               corrected =
                   find_largest_pressure({"load.pressure_surface=inner", "shell.through_wall_stress=mean"});
  EXPECT_LT(relative_error(unit * 1.5 / 30.0, exact), 3e-4);
  EXPECT_LT(relative_error(mid, exact), 0.005);
  EXPECT_LT(relative_error(corrected, exact), 0.005);
  EXPECT_LT(relative_error(inner, unit * 1.5 / 29.25), 0.005);
  EXPECT_GT(inner, 1.02 * exact);
  RecordProperty("exact_MPa", std::to_string(exact));
  RecordProperty("mid_MPa", std::to_string(mid));
  RecordProperty("inner_MPa", std::to_string(inner));
  RecordProperty("inner_with_sigma33_MPa", std::to_string(corrected));
}

}  // namespace
}  // namespace hydroscope::verification
