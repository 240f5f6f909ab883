// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of out-of-balance forces, and what sets the size of increments.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model_texts.h"

namespace hydroscope {
namespace {

const std::string kMaterial = R"([material]
youngs_modulus_MPa = 193e3
hardening = "swift"
swift_K_MPa = 1400.0
swift_eps0 = 0.05
swift_n = 0.5
)";

/// Corner of a square die, an eighth in 12 elements.
const std::string kSquareDie = R"([tube]
radius_mm = 30
thickness_mm = 1.5
length_mm = 3
section = "octant"
extent = "slice"
elements_around = 12
)" + kMaterial + R"([load]
pressure_MPa = [[0, 0], [1, 60]]
[tool.die]
shape = "box"
half_width_mm = 30.75
half_height_mm = 30.75
corner_radius_mm = 9
)";

/// Tube T between held ends, elastic; loaded, then held for as long again.
const std::string kHeldTube = test::kTubeT + R"(length_mm = 24
extent = "half"
elements_around = 4
elements_along = 6
)" + test::kElastic + R"([load]
pressure_MPa = [[0, 0], [1, 60], [2, 60]]
[ends]
rotation = "held"
radial = "held"
[increment]
largest = 0.1
initial_s = 0.2
)";

struct Path {
  std::vector<IncrementReport> rows;
  State state;

  double median_residual() const {
    std::vector<double> all;
    for (const IncrementReport& r : rows) all.push_back(r.residual);
    std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
    return all[all.size() / 2];
  }
  int count(Limiter by) const {
    return static_cast<int>(std::count_if(rows.begin(), rows.end(),
                                          [&](const IncrementReport& r) { return r.limited_by == by; }));
  }
};

Path follow(const std::string& scene, const std::vector<std::string>& sets) {
  const Model model = test::make_model(scene, sets);
  Path path;
  path.state = make_initial_state(model);
  Scratch scratch(model, 1);
  while (path.state.time < model.end_time * (1.0 - 1e-12)) {
    path.rows.push_back(advance(model, path.state, scratch));
    const IncrementReport& report = path.rows.back();
    EXPECT_EQ(report.outcome, Outcome::kRunning) << report.message;
    if (report.outcome != Outcome::kRunning) break;
  }
  return path;
}

// ---------------------------------------------------------------- what is left out of balance

/// The medians over a run in explicit steps: what is left piles up, is carried over, is solved for once or
/// three times, is iterated away.
TEST(CorrectionTreatment, ResidualsComeInOrder) {
  const auto median = [](const std::vector<std::string>& sets) {
    return follow(kSquareDie, sets).median_residual();
  };
  const double none = median({"increment.correction=none"}),
               behind = median({"increment.correction=one-step-behind"}),
               once = median({"increment.correction=algoneq"}),
               thrice = median({"increment.correction=algoneq", "increment.algoneq_passes=3"}),
               newton = median({"increment.tolerance=1e-5"});
  EXPECT_GT(none, 10.0 * behind);
  EXPECT_GT(behind, 1.3 * once);
  EXPECT_GT(once, 100.0 * thrice);
  EXPECT_LT(newton, 1e-5);
}

/// Residuals [rel] of the increments in which the load rests, 1 s to 2 s, and of the one before them.
std::vector<double> hold(std::vector<std::string> sets) {
  sets.insert(sets.end(), {"increment.max_rotation_deg=0", "increment.max_strain=0"});
  std::vector<double> residuals;
  for (const IncrementReport& row : follow(kHeldTube, sets).rows) {
    if (row.time > 1.0 - 1e-12) residuals.push_back(row.residual);
  }
  EXPECT_GT(residuals.size(), 6U);
  return residuals;
}

/// Mechanics 4.1 with rho = 1 and nothing new (e = 0): r' = (1 - 1/R_safe) r. What is new by turning is of
/// the size of r^2, 1e-3 of r here.
TEST(CorrectionTreatment, OneStepBehindShrinksByItsFactor) {
  for (const double r_safe : {1.25, 2.0, 4.0}) {
    const auto r =
        hold({"increment.correction=one-step-behind", "increment.r_safe=" + std::to_string(r_safe)});
    for (std::size_t k = 0; k + 1 < 6; ++k) {
      EXPECT_NEAR(r[k + 1] / r[k], 1.0 - 1.0 / r_safe, 3e-3) << "R_safe " << r_safe << ", " << k;
    }
  }
}

/// The same while the load rises, with the e that `none` lets pile up: r' = (1 - 1/R_safe) r + e, forces as
/// residual times pressure.
TEST(CorrectionTreatment, OneStepBehindCarriesWhatIsNew) {
  const auto load = [](const std::string& correction) {
    const Path path = follow(kHeldTube, {"increment.correction=" + correction, "increment.max_rotation_deg=0",
                                         "increment.max_strain=0"});
    std::vector<double> force;
    for (const IncrementReport& row : path.rows) {
      if (row.time < 1.0 + 1e-12) force.push_back(row.residual * row.pressure);
    }
    return force;
  };
  const auto piled = load("none"), carried = load("one-step-behind");  // R_safe 2
  ASSERT_EQ(piled.size(), carried.size());
  ASSERT_GE(piled.size(), 5U);
  EXPECT_NEAR(carried[0], piled[0], 1e-9);
  for (std::size_t k = 1; k < piled.size(); ++k) {
    EXPECT_NEAR(carried[k], 0.5 * carried[k - 1] + piled[k] - piled[k - 1], 0.02 * carried[k]) << k;
  }
}

/// `none` leaves the residual where it is; ALGONEQ takes a Newton step an increment: its square is left.
TEST(CorrectionTreatment, NoneKeepsAndAlgoneqSolves) {
  const auto none = hold({"increment.correction=none"}), algoneq = hold({"increment.correction=algoneq"});
  EXPECT_GT(none[0], 1e-2);
  for (const double r : none) EXPECT_NEAR(r, none[0], 1e-3 * none[0]);
  EXPECT_LT(algoneq[0], 1e-6);
  EXPECT_LT(algoneq[1], 1e-10);
}

// ---------------------------------------------------------------- what sets the increment's size

/// An eighth of a tube of M2 that is blown between held ends, into its plastic range; no limits of r_min.
const std::string kFreeTube = R"([tube]
radius_mm = 30
thickness_mm = 1.5
length_mm = 24
section = "octant"
extent = "half"
elements_around = 3
elements_along = 6
)" + kMaterial + R"([ends]
rotation = "held"
radial = "held"
[load]
pressure_MPa = [[0, 0], [1, 27]]
[increment]
largest = 0.5
max_strain = 0
max_rotation_deg = 0
stop_at = []
)";

double compare(const Path& a, const Path& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.state.configuration.x.size(); ++i) {
    largest = std::max(largest, (a.state.configuration.x[i] - b.state.configuration.x[i]).norm());
  }
  return largest;
}

/// A tighter tolerance: shorter increments, said to be limited by it, and an end nearer to that of a fine
/// run. Of displacements of 0.6 mm; the fine run itself is good to 3e-4 mm.
TEST(CorrectionTreatment, ErrorControlKeepsTheError) {
  const Path fine = follow(kFreeTube, {"increment.tolerance=1e-8", "increment.largest=0.004"});
  const auto control = [](const std::string& tolerance) {
    return follow(kFreeTube, {"increment.correction=one-step-behind", "increment.control=error",
                              "increment.error_tolerance=" + tolerance});
  };
  const Path loose = control("1e-1"), middle = control("1e-2"), tight = control("1e-3");
  EXPECT_LT(loose.rows.size(), middle.rows.size());
  EXPECT_LT(middle.rows.size(), tight.rows.size());
  EXPECT_EQ(loose.count(Limiter::kError), 0);
  EXPECT_GT(tight.count(Limiter::kError), middle.count(Limiter::kError));
  EXPECT_GT(middle.count(Limiter::kError), 0);
  EXPECT_STREQ(to_string(Limiter::kError), "error-tolerance");
  EXPECT_GT(compare(loose, fine), 5.0 * compare(middle, fine));
  EXPECT_GT(compare(middle, fine), 5.0 * compare(tight, fine));
  EXPECT_LT(compare(tight, fine), 2e-3);
  // Iterated to balance, it is the path within the increment that counts; it is controlled alike.
  const Path newton = follow(kFreeTube, {"increment.control=error", "increment.error_tolerance=1e-3"});
  EXPECT_GT(newton.count(Limiter::kError), 0);
  EXPECT_LT(newton.count(Limiter::kError), static_cast<int>(newton.rows.size()));
  EXPECT_EQ(follow(kFreeTube, {"increment.tolerance=1e-3"}).count(Limiter::kError), 0);
}

/// Each limit names itself while it is small, and 0 is none at all.
TEST(CorrectionTreatment, ZeroSwitchesLimitsOff) {
  const struct {
    const char *key, *small;
    Limiter limiter;
  } limits[] = {{"max_strain", "0.002", Limiter::kStrain},
                {"max_rotation_deg", "0.3", Limiter::kRotation},
                {"max_slide", "0.004", Limiter::kSlide}};
  for (const auto& limit : limits) {
    const std::string key = std::string("increment.") + limit.key + "=";
    const Path small = follow(kSquareDie, {key + limit.small}), off = follow(kSquareDie, {key + "0"});
    EXPECT_GT(small.count(limit.limiter), 20) << limit.key;
    EXPECT_GT(small.rows.size(), off.rows.size() + 15) << limit.key;
    if (limit.limiter != Limiter::kStrain) {  // that name also stands for increments that may not grow
      EXPECT_EQ(off.count(limit.limiter), 0) << limit.key;
    }
  }
}

}  // namespace
}  // namespace hydroscope
