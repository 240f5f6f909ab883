// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/generators/die_meshes.h"
#include "scenes/generators/stl_file.h"
#include "tests/temporary_folder.h"
#include "tests/verification/plane_strain_ring.h"
#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

constexpr double kThickness = 1.5, kRadius = 30.0;  // of the mid-surface on the punch, 29.25 + t/2
constexpr double kPushed = 1.0;                     // [s]: the punch turns back
constexpr double kWrapped = 0.12;                   // share of the strip that surely lies on the punch then
constexpr double kFreeFrom = 0.18, kFreeTo = 0.2;   // share that is surely free, with fine elements
constexpr int kParts = 6;                           // of which the profile is taken

/// Moment per width of a plate bent to a curvature without tension, plane strain: the stress
/// of a fibre at z is that of the plane-strain wall at the strain kappa z; M = 2 int_0^{t/2} s z dz.
double calc_moment(double curvature) {
  constexpr int kSlices = 2000;  // midpoint rule, exact to 1e-6 but for the kink at first yield
  const PlaneStrainWall wall(kM1, 1.01 * curvature * 0.5 * kThickness);
  double sum = 0.0;
  for (int i = 0; i < kSlices; ++i) {
    const double z = 0.5 * kThickness * (i + 0.5) / kSlices;
    sum += wall.at(curvature * z).hoop_stress * z;
  }
  return 2.0 * sum * 0.5 * kThickness / kSlices;
}

/// Unloading is elastic: the curvature falls by M over the stiffness E t^3 / (12 (1 - nu^2)).
double calc_free_radius(double curvature) {
  const double stiffness =
      kM1.youngs_modulus * std::pow(kThickness, 3) / (12.0 * (1.0 - kM1.poisson * kM1.poisson));
  return 1.0 / (curvature - calc_moment(curvature) / stiffness);
}

std::string part(int k) { return "part" + std::to_string(k); }

/// Moment and radius of each part of the wrapped strip beside the scene's own.
std::vector<std::string> make_profile() {
  std::vector<std::string> keys;
  for (int k = 0; k < kParts; ++k) {
    const std::string range = ".position_range=[" + std::to_string(kWrapped * k / kParts) + "," +
                              std::to_string(kWrapped * (k + 1) / kParts) + "]";
    for (const std::string kind : {"bending_moment", "bend_radius"}) {
      const std::string name = "quantity." + kind + part(k);
      keys.push_back(name + ".kind=" + kind);
      keys.push_back(name + range);
    }
  }
  keys.push_back("quantity.free_N.kind=bending_moment");
  keys.push_back("quantity.free_N.position_range=[" + std::to_string(kFreeFrom) + "," +
                 std::to_string(kFreeTo) + "]");
  keys.push_back("states.number=13");  // one each 0.1 s
  return keys;
}

double at_end_of_stroke(const History& h, const std::string& name) {
  return h.state_at(kPushed).quantities.at(name);
}

void expect_even_wrap(const History& h) {
  const double wanted = calc_moment(1.0 / kRadius);
  EXPECT_LT(relative_error(at_end_of_stroke(h, "moment_N"), wanted), 0.01);
  EXPECT_LT(relative_error(at_end_of_stroke(h, "radius_mm"), kRadius), 0.001);
  std::string profile;
  for (int k = 0; k < kParts; ++k) {
    const double moment = at_end_of_stroke(h, "bending_moment" + part(k)),
                 radius = at_end_of_stroke(h, "bend_radius" + part(k));
    EXPECT_LT(relative_error(moment, wanted), 0.01) << part(k);
    EXPECT_LT(relative_error(radius, kRadius), 0.01) << part(k);
    profile += std::to_string(moment) + " at " + std::to_string(radius) + " mm, ";
  }
  ::testing::Test::RecordProperty("moment_profile_N", profile + "wanted " + std::to_string(wanted));
  ::testing::Test::RecordProperty("moment_N", std::to_string(at_end_of_stroke(h, "moment_N")));
}

void expect_springback(const History& h) {
  const double wanted = calc_free_radius(1.0 / kRadius), radius = h.column("radius_mm").back();
  EXPECT_EQ(h.rows.back().n_contact, 0);
  EXPECT_NEAR(h.column("moment_N").back(), 0.0, 1e-3);
  EXPECT_LT(relative_error(radius, wanted), 0.02);
  for (int k = 0; k < kParts; ++k) {
    EXPECT_LT(relative_error(h.column("bend_radius" + part(k)).back(), wanted), 0.02) << part(k);
  }
  ::testing::Test::RecordProperty("free_radius_mm",
                                  std::to_string(radius) + " wanted " + std::to_string(wanted));
}

/// What the layers' stresses say must be what the support's force does with its lever. It is vertical,
/// as the support slides; beyond the last node on the punch nothing else acts.
void expect_balance(const History& h) {
  const Snapshot& state = h.state_at(kPushed);
  const auto place = [](double share) { return static_cast<std::size_t>(std::lround(share * 400)); };
  const std::size_t first = place(kFreeFrom), last = place(kFreeTo);  // 120 mm, fine nodes each 0.3 mm
  double middle = 0.0;
  for (std::size_t i = first; i <= last; ++i) {
    EXPECT_EQ(state.contact_state[i], ContactClass::kFree);
    middle += state.points[i].x() / static_cast<double>(last - first + 1);
  }
  const double lever = state.points[state.points.size() / 2 - 1].x() - middle;
  const double wanted = lever * state.quantities.at("support_N_per_mm");
  // The corrector's tolerance is 1e-3 of the reference force.
  EXPECT_LT(relative_error(state.quantities.at("free_N"), wanted), 1e-3);
  ::testing::Test::RecordProperty(
      "free_moment_N", std::to_string(state.quantities.at("free_N")) + " wanted " + std::to_string(wanted));
}

TEST(PunchBend, WrapsEvenlyAndSpringsBack) {
  const History h = run_scene("punch-bend.toml", make_profile());
  ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  expect_even_wrap(h);
  expect_balance(h);
  expect_springback(h);
}

TEST(PunchBend, MeshedPunchBendsAsTheExactOne) {
  const TemporaryFolder folder;
  write_file(folder / "punch.stl", make_binary_stl(make_punch({}), "punch"));
  std::vector<std::string> keys = make_profile();
  keys.push_back("tool.punch.file=" + folder / "punch.stl");
  const History meshed = run_scene("punch-bend-mesh.toml", keys);
  ASSERT_EQ(meshed.summary.outcome, Outcome::kCompleted) << meshed.summary.message;
  expect_even_wrap(meshed);
  expect_springback(meshed);
  const History exact = run_scene("punch-bend.toml", make_profile());
  EXPECT_LT(relative_error(at_end_of_stroke(meshed, "moment_N"), at_end_of_stroke(exact, "moment_N")), 0.002);
  EXPECT_LT(relative_error(meshed.column("radius_mm").back(), exact.column("radius_mm").back()), 0.002);
}

// Mechanics V11 gives these figures for R/t = 5 to 200; the integral above must be the same law.
TEST(BendingMoment, OfTheReferenceIntegral) {
  const struct {
    double ratio, moment, free_radius;
  } kRows[] = {{5, 215.856, 7.6957},   {10, 191.922, 15.7104},  {20, 173.193, 32.6658},
               {50, 155.684, 91.8436}, {100, 145.942, 228.602}, {200, 133.790, 811.73}};
  for (const auto& row : kRows) {  // computed with coarser steps: good to about 2e-4
    const double curvature = 1.0 / (row.ratio * kThickness);
    EXPECT_LT(relative_error(calc_moment(curvature), row.moment), 3e-4) << row.ratio;
    EXPECT_LT(relative_error(calc_free_radius(curvature), row.free_radius), 1.5e-3) << row.ratio;
  }
}

}  // namespace
}  // namespace hydroscope::verification
