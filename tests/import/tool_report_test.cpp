// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/tool_report.h"

#include <gmock/gmock.h>

#include "scenes/generators/die_meshes.h"
#include "solver/geometry/pose.h"
#include "solver/import/make_tool.h"
#include "tests/geometry/test_shapes.h"
#include "tests/import/test_files.h"

namespace hydroscope {
namespace {

using test::at;
using test::Folder;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// Outer face of a quarter of a tube of outer radius `radius`, z from 0 to `length`.
SheetSample make_tube(double radius, double length = 10.0) {
  SheetSample sheet{{}, 1.0, 1.5};
  for (int i = 0; i <= 30; ++i) {
    const double a = 3.0 * i * std::numbers::pi / 180;
    for (int j = 0; j <= 5; ++j)
      sheet.points.emplace_back(radius * std::cos(a), radius * std::sin(a), length * j / 5);
  }
  return sheet;
}

struct Die {
  Folder folder;
  ToolScene scene;

  explicit Die(const TriangleMesh& mesh) {
    folder.write("die.stl", make_binary_stl(mesh, "die"));
    scene.file = "die.stl";
  }
  ToolReport inspect(const SheetSample& sheet) const {
    return inspect_tool(scene, "die", folder.path(), sheet);
  }
};

TEST(ToolReport, HealthyDie) {
  const ToolReport report = Die(make_square_die({})).inspect(make_tube(30.75));
  EXPECT_THAT(report.errors, IsEmpty());
  EXPECT_THAT(report.warnings, IsEmpty());
  EXPECT_EQ(report.place.free_fraction, 1.0);
  EXPECT_EQ(report.place.points, 31 * 6);
  EXPECT_EQ(report.mesh.facets, 760);
  EXPECT_NEAR(report.mesh.smallest_radius, 10.0, 0.1);
  const std::string text = format_tool_report(report);
  EXPECT_THAT(text, AllOf(HasSubstr("760 facets"), HasSubstr("deg"), HasSubstr("healthy")));
}

TEST(ToolReport, WrongSide) {
  Die die(make_square_die({}));
  die.scene.flip = true;
  const ToolReport report = die.inspect(make_tube(26));
  EXPECT_THAT(report.errors,
              Contains(AllOf(HasSubstr("tool.die"), HasSubstr("wrong side"), HasSubstr("flip"))));
  EXPECT_THAT(format_tool_report(report), HasSubstr("error: tool.die"));
  die.scene.flip = false;
  EXPECT_THAT(die.inspect(make_tube(26)).errors, IsEmpty());
}

TEST(ToolReport, WrongSideOfAnAnalyticTool) {
  ToolScene scene;
  scene.shape = "cylinder";
  scene.radius = 33;
  scene.side = "outside";
  EXPECT_THAT(inspect_tool(scene, "ring", "", make_tube(30)).errors, Contains(HasSubstr("flip")));
  scene.side = "inside";
  EXPECT_THAT(inspect_tool(scene, "ring", "", make_tube(30)).errors, IsEmpty());
  EXPECT_NEAR(inspect_tool(scene, "ring", "", make_tube(30)).place.smallest_gap, 3.0, 1e-12);
}

TEST(ToolReport, OneOfTwoHalvesTurnedAround) {
  // Two separate half dies; the second faces away.
  TriangleMesh mesh = make_square_die({});
  TriangleMesh other = mesh;
  place_mesh(make_pose({0, 0, 180}, {0, 0, 0}), other);
  flip_mesh(other);
  const int offset = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (auto t : other.triangles) mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  SheetSample sheet = make_tube(30);
  const std::size_t count = sheet.points.size();
  for (std::size_t i = 0; i < count; ++i) sheet.points.push_back(-sheet.points[i] + Vec3(0, 0, 5));
  EXPECT_THAT(Die(mesh).inspect(sheet).errors, Contains(HasSubstr("1 of the tool's 2 parts")));
}

TEST(ToolReport, PenetrationAtTheStart) {
  const Die die(make_square_die({}));
  const ToolReport deep = die.inspect(make_tube(31.0));
  EXPECT_THAT(deep.errors, Contains(AllOf(HasSubstr("tool.die"), HasSubstr("0.25 mm inside the tool"))));
  EXPECT_NEAR(deep.place.largest_penetration, 0.25, 1e-3);
  const ToolReport slight = die.inspect(make_tube(30.77));
  EXPECT_THAT(slight.errors, IsEmpty());
  EXPECT_THAT(slight.warnings, Contains(HasSubstr("0.02 mm inside the tool")));
}

TEST(ToolReport, SheetALittleBehindAllAround) {
  ToolScene scene;
  scene.shape = "cylinder";
  scene.radius = 30;
  EXPECT_THAT(inspect_tool(scene, "ring", "", make_tube(30.5)).errors,
              Contains(AllOf(HasSubstr("wrong side"), HasSubstr("too tight"))));
}

TEST(ToolReport, MetresTakenForMillimetres) {
  Die die(make_square_die({}));
  die.scene.unit_scale = 0.001;
  EXPECT_THAT(die.inspect(make_tube(30.75)).errors,
              Contains(AllOf(HasSubstr("metres taken for millimetres"), HasSubstr("unit_scale = 1000"))));
  die.scene.unit_scale = 1 / 25.4;
  EXPECT_THAT(die.inspect(make_tube(30.75)).warnings, Contains(HasSubstr("unit_scale = 25.4")));
  die.scene.unit_scale = 1000;
  EXPECT_THAT(die.inspect(make_tube(30.75)).errors, Contains(HasSubstr("unit_scale = 0.001")));
}

TEST(ToolReport, RepairsFlippedFacets) {
  TriangleMesh mesh = make_square_die({});
  for (int f : {3, 50, 51, 400}) std::swap(mesh.triangles[at(f)][0], mesh.triangles[at(f)][1]);
  const ToolReport report = Die(mesh).inspect(make_tube(30.75));
  EXPECT_EQ(report.flipped_repaired, 4);
  EXPECT_THAT(report.warnings, Contains(HasSubstr("4 facets turned")));
  EXPECT_THAT(report.errors, IsEmpty());
}

TEST(ToolReport, FilletSmallerThanAnElement) {
  const Die die(make_square_die({}));
  SheetSample sheet = make_tube(30.75);
  sheet.element_size = 12.0;
  EXPECT_THAT(die.inspect(sheet).warnings, Contains(HasSubstr("smaller than the sheet's elements")));
  sheet.element_size = 0.3;
  EXPECT_THAT(die.inspect(sheet).warnings, Contains(HasSubstr("longer than two elements")));
}

TEST(ToolReport, NamesWhatIsWrongWithAMesh) {
  const Folder folder;
  const ToolReport cube =
      inspect_tool_file(folder.write("block.stl", make_binary_stl(test::make_cube(10, 4), "block")), 1.0);
  EXPECT_EQ(cube.name, "block");
  EXPECT_THAT(cube.warnings, Contains(AllOf(HasSubstr("48 creases"), HasSubstr("90.0 deg"))));
  TriangleMesh ball = test::make_icosphere(10, 1);
  ball.triangles.erase(ball.triangles.begin() + 5);
  const ToolReport open = inspect_tool_file(folder.write("ball.stl", make_binary_stl(ball, "ball")), 1.0);
  EXPECT_EQ(open.mesh.open_edges, 3);
  EXPECT_THAT(open.warnings, Contains(HasSubstr("facets turn by up to")));
  EXPECT_THAT(format_tool_report(open), AllOf(HasSubstr("3 open (1 rims)"), HasSubstr("usable")));
}

TEST(ToolReport, HolesInADie) {
  TriangleMesh mesh = make_square_die({});
  mesh.triangles.erase(mesh.triangles.begin() + 400);
  EXPECT_THAT(Die(mesh).inspect(make_tube(30.75)).warnings, Contains(HasSubstr("1 holes")));
}

TEST(ToolReport, OneSidedSurfaceIsHopeless) {
  TriangleMesh strip;
  for (int i = 0; i < 24; ++i) {
    const double a = 2 * std::numbers::pi * i / 24;
    const Vec3 out(std::cos(a), std::sin(a), 0);
    const Vec3 across = std::cos(a / 2) * out + std::sin(a / 2) * Vec3::UnitZ();
    strip.points.push_back(30 * out - 5 * across);
    strip.points.push_back(30 * out + 5 * across);
  }
  for (int i = 0; i < 24; ++i) {
    const int a = 2 * i, b = 2 * i + 1;
    const int c = i < 23 ? a + 2 : 1, d = i < 23 ? b + 2 : 0;
    strip.triangles.push_back({a, b, d});
    strip.triangles.push_back({a, d, c});
  }
  EXPECT_THAT(Die(strip).inspect(make_tube(20)).errors, Contains(HasSubstr("no free side")));
}

TEST(ToolReport, StartAgainstAToolOfEachForm) {
  // What a run checks, on the surface that it has made already.
  Die die(make_square_die({}));
  die.scene.pitch = 0.5;
  die.scene.height_axis = {-1, -1, 0};
  for (const char* surface : {"smooth", "facets", "nagata", "points"}) {
    die.scene.surface = surface;
    die.scene.flip = false;
    const auto start = [&](double radius) {
      const auto tool = make_tool_surface(die.scene, "die", die.folder.path(), 50);
      return inspect_start(*tool, die.scene, "die", make_tube(radius));
    };
    EXPECT_THAT(start(30.5).errors, IsEmpty()) << surface;
    EXPECT_EQ(start(30.5).place.free_fraction, 1.0);
    EXPECT_THAT(start(31.0).errors, Contains(HasSubstr("inside the tool"))) << surface;
    die.scene.unit_scale = 0.001;
    die.scene.pitch = 0.0005;
    EXPECT_THAT(start(30.5).errors, Contains(HasSubstr("unit_scale = 1000"))) << surface;
    die.scene.unit_scale = 1;
    die.scene.pitch = 0.5;
    die.scene.flip = true;
    die.scene.height_axis = {1, 1, 0};
    EXPECT_THAT(start(26).errors, Contains(HasSubstr("wrong side"))) << surface;
    die.scene.height_axis = {-1, -1, 0};
  }
}

TEST(ToolReport, PointSetsNameLinesThatTheyRound) {
  const Folder folder;
  folder.write("roof.grid",
               "hydroscope-grid 1\ncolumns 5 rows 2\norigin 0 0\npitch 1 1\nheights\n"
               "0 1 2 1 0\n0 1 2 1 0\n");
  ToolScene scene;
  scene.shape = "points";
  scene.file = "roof.grid";
  EXPECT_THAT(inspect_tool(scene, "roof", folder.path(), {}).warnings,
              Contains(AllOf(HasSubstr("tool.roof: 1 lines"), HasSubstr("40 deg"))));
}

TEST(ToolReport, SheetThatMeetsNothing) {
  SheetSample sheet = make_tube(30.0);
  for (Vec3& p : sheet.points) p.z() += 500;
  EXPECT_THAT(Die(make_square_die({})).inspect(sheet).warnings, Contains(HasSubstr("no point of the sheet")));
}

}  // namespace
}  // namespace hydroscope
