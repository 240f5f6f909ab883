// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model_texts.h"

namespace hydroscope {
namespace {

/// Sze, Liu & Lo (2004): b = 1, h = 0.1, E = 1.2e6, nu = 0, clamped at the start. With nu = 0
/// the strip's plane strain is the beam.
std::string make_cantilever(int length, int elements, const std::string& more) {
  return "[strip]\nthickness_mm = 0.1\nwidth_mm = 1\nlead_in_mm = " + std::to_string(length) +
         "\nelements_lead_in = " + std::to_string(elements) +
         "\n[material]\nyoungs_modulus_MPa = 1.2e6\npoisson = 0\n"
         "[edge.start]\nhold = [\"x\", \"y\", \"rotation\"]\n" +
         more;
}

/// Displacement of the loaded end.
Vec3 calc_tip(const Model& model, const State& state) {
  std::size_t tip = 0;
  for (std::size_t i = 0; i < model.x0.size(); ++i) {
    if (model.x0[i][0] > model.x0[tip][0]) tip = i;
  }
  return state.configuration.x[tip] - model.x0[tip];
}

/// V26, an end shear of PL^2/EI = 4; and at half of it. Rotations go past 60 degrees. Seen: 0.15 %
/// and 0.12 % with 40 elements; the reference itself has four digits.
TEST(LargeRotation, CantileverUnderEndShear) {
  struct Case {
    double force, along, across;
  };
  for (const Case& c : {Case{2.0, -1.604, 4.933}, Case{4.0, -3.286, 6.698}}) {
    const Model model = test::make_model(make_cantilever(
        10, 40, "[edge.end]\nforce_y_N_per_mm = [[0, 0], [1, " + std::to_string(c.force) + "]]\n"));
    State state = make_initial_state(model);
    Scratch scratch(model, 1);
    const IncrementReport report = test::run_to_end(model, state, scratch);
    ASSERT_EQ(state.time, model.end_time) << report.message;
    const Vec3 u = calc_tip(model, state);
    EXPECT_NEAR(u[1], c.across, 0.005 * c.across);
    EXPECT_NEAR(u[0], c.along, 0.005 * std::abs(c.along));
  }
}

/// V26, roll-up: a moment on the end bends L = 12 into a full circle. Each node holds phi = M L/(E I)
/// all along the path; errors are shares of L.
TEST(LargeRotation, StripRollsUpUnderEndMoment) {
  constexpr double kLength = 12.0, kStiffness = 100.0;                // E b h^3/12
  const double full = 2.0 * std::numbers::pi * kStiffness / kLength;  // 50 pi/3
  for (const double sense : {1.0, -1.0}) {
    const Model model = test::make_model(
        make_cantilever(12, 60,
                        "[edge.end]\nmoment_N = [[0, 0], [1, " + std::to_string(sense * full) +
                            "]]\n[quantity.pull]\nkind = \"edge_force\"\nedge = \"end\"\n"));
    State state = make_initial_state(model);
    Scratch scratch(model, 1);
    double worst = 0.0;
    IncrementReport report;
    while (state.time < model.end_time * (1.0 - 1e-12)) {
      report = advance(model, state, scratch);
      ASSERT_EQ(report.outcome, Outcome::kRunning) << report.message;
      const double phi = state.time * full * kLength / kStiffness;
      const Vec3 u = calc_tip(model, state) / kLength;
      worst = std::max({worst, std::abs(u[0] - (std::sin(phi) / phi - 1.0)),
                        std::abs(sense * u[1] - (1.0 - std::cos(phi)) / phi)});
      EXPECT_LT(report.quantities.at(0), 1e-3 * full / kLength) << "a moment is no force";
    }
    EXPECT_LT(worst, 0.005);
    RecordProperty(sense > 0.0 ? "largest_error" : "largest_error_downwards", std::to_string(worst));
    RecordProperty("increments", state.increment);
    RecordProperty("factorisations", scratch.factorisations);
  }
}

}  // namespace
}  // namespace hydroscope
