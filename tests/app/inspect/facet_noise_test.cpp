// SPDX-License-Identifier: GPL-3.0-or-later
// The scatter that a tool's facets cause, against the numbers of the mechanics notebook's section 6.3.
#include "app/inspect/facet_noise.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/inspect/verdict.h"
#include "tests/app/inspect/small_strip.h"

namespace hydroscope::test {
namespace {

using testing::HasSubstr;

constexpr double kSteel = 206e3 / (1.0 - 0.3 * 0.3);  // E' [MPa]

/// Half a cylinder of radius R along z, facets of `degrees`; beside it, from angle 0 down, a flat wall.
TriangleMesh make_cylinder(double radius, double degrees) {
  TriangleMesh mesh;
  const int facets = static_cast<int>(std::lround(90.0 / degrees));
  const double turn = degrees * std::numbers::pi / 180.0;
  for (int i = -3; i <= facets; ++i)
    for (const double z : {-20.0, 20.0})
      mesh.points.push_back(i < 0 ? Vec3(radius, 3.0 * i, z)
                                  : Vec3(radius * std::cos(i * turn), radius * std::sin(i * turn), z));
  for (int i = 0; i < facets + 3; ++i) {
    const int a = 2 * i;
    mesh.triangles.push_back({a, a + 1, a + 2});
    mesh.triangles.push_back({a + 1, a + 3, a + 2});
  }
  return mesh;
}

Vec3 at_angle(double radius, double degrees) {
  const double a = degrees * std::numbers::pi / 180.0;
  return {radius * std::cos(a), radius * std::sin(a), 3.0};
}

TEST(FacetNoise, FlatFacetsAsInTheNotebook) {
  // R = 33, t = 1.5: theta = 3.4 degrees gives 4.5 MPa. 90 / 3.4 is no whole number: 3.4615.
  const double degrees = 90.0 / 26.0, theta = degrees * std::numbers::pi / 180.0;
  const FacetTool tool(make_cylinder(33.0, degrees), ToolForm::kFlat, 40.0);
  const FacetNoise noise = tool.estimate(at_angle(32.9, 47.0), 1.5, kSteel);
  EXPECT_NEAR(noise.angle, degrees, 1e-9);
  // Facets are chords: their width is less than the arc's by theta^2 / 24.
  EXPECT_NEAR(noise.pressure, kSteel * 1.5 / 33.0 * theta * theta / 8.0, 1e-3 * noise.pressure);
  EXPECT_NEAR(noise.pressure * std::pow(3.4 / degrees, 2), 4.5, 0.06);
}

TEST(FacetNoise, BentFacetsLeaveTheFourthPower) {
  const double theta = 10.0 * std::numbers::pi / 180.0;
  const FacetTool tool(make_cylinder(33.0, 10.0), ToolForm::kBent, 40.0);
  const FacetNoise noise = tool.estimate(at_angle(33.0, 45.0), 1.5, kSteel);
  EXPECT_NEAR(noise.pressure, kSteel * 1.5 / 33.0 * std::pow(theta, 4) / 128.0, 5e-3 * noise.pressure);
}

TEST(FacetNoise, FlatWallsCreasesAndExactToolsMakeNone) {
  const FacetTool tool(make_cylinder(33.0, 5.0), ToolForm::kFlat, 40.0);
  EXPECT_EQ(tool.estimate(Vec3(33.0, -7.5, 0.0), 1.5, kSteel).pressure, 0.0) << "far from the fillet";
  const FacetTool creased(make_cylinder(33.0, 45.0), ToolForm::kFlat, 40.0);
  EXPECT_EQ(creased.estimate(at_angle(33.0, 45.0), 1.5, kSteel).pressure, 0.0) << "an edge is no curvature";
  EXPECT_EQ(FacetTool(make_cylinder(33.0, 5.0), ToolForm::kExact, 40.0)
                .estimate(Vec3::Zero(), 1.5, kSteel)
                .pressure,
            0.0);
}

TEST(FacetNoise, WhatIsNotKnownStaysSo) {
  EXPECT_TRUE(std::isnan(FacetTool().estimate(Vec3::Zero(), 1.5, kSteel).pressure));
  EXPECT_EQ(find_tool_form("cylinder", ""), ToolForm::kExact);
  EXPECT_EQ(find_tool_form("mesh", "smooth"), ToolForm::kBent);
  EXPECT_EQ(find_tool_form("mesh", "nagata"), ToolForm::kBent);
  EXPECT_EQ(find_tool_form("mesh", "facets"), ToolForm::kFlat);
  EXPECT_EQ(find_tool_form("mesh", "quads"), ToolForm::kFlat);
  EXPECT_EQ(find_tool_form("mesh", "points"), ToolForm::kOther);
  EXPECT_EQ(find_tool_form("points", "smooth"), ToolForm::kOther);
}

TEST(FacetNoise, APullWithinTheNoiseIsNoPull) {
  ContactEvent event;
  event.increment = 10;
  event.cause = "tension";
  VerdictBounds bounds;
  bounds.opening = 0.002;
  ReleaseFigures f;
  f.gap_reached = 0.001;
  f.force_share = -0.05;
  EXPECT_EQ(judge_release(event, {}, f, bounds).verdict, Verdict::kPhysical);
  f.facet_noise_share = 0.06;
  const Judgement judged = judge_release(event, {}, f, bounds);
  EXPECT_EQ(judged.verdict, Verdict::kNoise);
  EXPECT_THAT(judged.reason, HasSubstr("-5 % of the fluid's share (facet noise: 6 %)"));
  f.facet_noise_share = 0.04;
  EXPECT_EQ(judge_release(event, {}, f, bounds).verdict, Verdict::kPhysical);
  f.force_share = 0.1;
  f.patch_force_share = -0.05;
  EXPECT_EQ(judge_release(event, {}, f, bounds).verdict, Verdict::kPhysical);
  f.patch_noise_share = 0.06;
  EXPECT_EQ(judge_release(event, {}, f, bounds).verdict, Verdict::kNoise);
}

TEST(FacetNoise, OverAPatchItAddsAsSquares) {
  Snapshot before = make_strip_state(7);
  SheetHistory sheet;
  sheet.states = {make_sheet_state(before)};
  sheet.neighbours = find_neighbours(make_strip_model()->quads, 12);
  // A tool of facets that is moved by 100 mm: the strip's nodes lie on its fillet's facets.
  sheet.states[0].tool_translation[0] = Vec3(-33.0 + 4.0, 0.0, 0.0);
  FacetNoiseModel noise;
  noise.modulus = kSteel;
  noise.tools = {FacetTool(make_cylinder(33.0, 5.0), ToolForm::kFlat, 40.0)};
  const Ledger ledger =
      make_ledger(make_log(make_event_line(1, "touch", 2, "die,gap closed,0,1,0") +
                           make_event_line(1, "touch", 3, "die,gap closed,0,1,0") +
                           make_event_line(9, "detach", 2) + make_event_line(9, "detach", 3)),
                  sheet, {}, noise);
  ASSERT_EQ(ledger.patches.size(), 1U);
  const ReleaseFigures &a = ledger.episodes[0].figures, &b = ledger.episodes[1].figures;
  ASSERT_GT(a.facet_noise, 0.0);
  EXPECT_NEAR(a.facet_noise_share, a.facet_noise * 2.0 / 20.0, 1e-15);  // 2 mm^2, 20 N of fluid
  EXPECT_NEAR(ledger.patches[0].facet_noise, 2.0 * std::hypot(a.facet_noise, b.facet_noise), 1e-12);
  EXPECT_NEAR(a.patch_noise_share, ledger.patches[0].facet_noise / 40.0, 1e-15);
}

TEST(FacetNoise, TheMomentOfLettingGoIsReadWhereARunKeepsIt) {
  const std::string head =
      "increment,time_s,kind,node,x_mm,y_mm,z_mm,tool,cause,force_before_N,force_after_N,gap_mm,patch_"
      "pressure_MPa,"
      "threshold_N\n";
  const ContactLog log =
      make_contact_log(CsvTable::parse(head + "1,0.1,touch,3,6,0,0,die,gap closed,0,0.5,0,0,0\n" +
                                           "9,0.9,detach,3,6,0,0,die,tension,0.5,-0.75,0.01,-0.25,0.5\n",
                                       "events.csv"),
                       CsvTable::parse(make_history(30), "history.csv"), {12, {"die", "punch"}});
  SheetHistory sheet;
  sheet.states = {make_sheet_state(make_strip_state(0))};
  sheet.neighbours = find_neighbours(make_strip_model()->quads, 12);
  const Ledger ledger = make_ledger(log, sheet, {});
  const ReleaseNote& release = ledger.episodes.at(0).figures.release;
  EXPECT_EQ(release.force, -0.75);
  EXPECT_EQ(release.threshold, 0.5);
  EXPECT_EQ(release.pressure, -0.25);
  EXPECT_THAT(ledger.episodes[0].reason,
              HasSubstr("it let go at -0.75 N, threshold -0.5 N, patch pressure -0.25 MPa"));
  EXPECT_TRUE(
      std::isnan(make_small_ledger(make_event_line(9, "detach", 3), {}).episodes[0].figures.release.force));
}

}  // namespace
}  // namespace hydroscope::test
