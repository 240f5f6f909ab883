// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/make_tool.h"

#include <gmock/gmock.h>

#include "scenes/generators/die_meshes.h"
#include "tests/import/test_files.h"

namespace hydroscope {
namespace {

using test::catch_input_error;
using test::Folder;
using testing::AllOf;
using testing::HasSubstr;

FootPoint look_up(const ToolSurface& tool, const Vec3& x) {
  SearchHint hint;
  return tool.find_foot_point(x, 1e3, 1e3, hint).value();
}

ToolScene make_scene(const std::string& shape) {
  ToolScene scene;
  scene.shape = shape;
  scene.radius = 30;
  scene.minor_radius = 5;
  scene.half_width = 20;
  scene.half_height = 15;
  scene.corner_radius = 4;
  return scene;
}

TEST(MakeTool, EveryAnalyticShape) {
  const Vec3 x(0, 14, 0);
  EXPECT_NEAR(look_up(*make_tool_surface(make_scene("plane"), "t", "", 50), Vec3(1, 2, 3)).gap, 3.0, 1e-12);
  EXPECT_NEAR(look_up(*make_tool_surface(make_scene("cylinder"), "t", "", 50), x).gap, 16.0, 1e-12);
  EXPECT_NEAR(look_up(*make_tool_surface(make_scene("box"), "t", "", 50), x).gap, 1.0, 1e-12);
  EXPECT_NEAR(look_up(*make_tool_surface(make_scene("torus"), "t", "", 50), Vec3(31, 0, 0)).gap, 4.0, 1e-12);
}

TEST(MakeTool, SideAndFlip) {
  ToolScene scene = make_scene("cylinder");
  scene.side = "outside";
  EXPECT_NEAR(look_up(*make_tool_surface(scene, "t", "", 50), Vec3(31, 0, 0)).gap, 1.0, 1e-12);
  scene.flip = true;
  EXPECT_NEAR(look_up(*make_tool_surface(scene, "t", "", 50), Vec3(31, 0, 0)).gap, -1.0, 1e-12);
  ToolScene plane = make_scene("plane");
  plane.flip = true;
  EXPECT_NEAR(look_up(*make_tool_surface(plane, "t", "", 50), Vec3(0, 0, 3)).gap, -3.0, 1e-12);
}

TEST(MakeTool, PointDirectionAndPose) {
  ToolScene scene = make_scene("plane");
  scene.point = {0, 0, 2};
  scene.direction = {0, 0, 5};
  scene.rotation = {90, 0, 0};  // z goes to -y
  scene.position = {0, -10, 0};
  const auto tool = make_tool_surface(scene, "t", "", 50);
  EXPECT_NEAR(look_up(*tool, Vec3(3, -13, 4)).gap, 1.0, 1e-12);
  EXPECT_LT((look_up(*tool, Vec3(3, -13, 4)).normal - Vec3(0, -1, 0)).norm(), 1e-14);
  ToolScene bar = make_scene("cylinder");
  bar.direction = {1, 0, 0};
  bar.point = {0, 0, 7};
  EXPECT_NEAR(look_up(*make_tool_surface(bar, "t", "", 50), Vec3(99, 0, 27)).gap, 10.0, 1e-12);
}

TEST(MakeTool, MeshFromAFileBesideTheScene) {
  const Folder folder;
  folder.write("die.stl", make_binary_stl(make_square_die({}), "die"));
  ToolScene scene;
  scene.file = "die.stl";
  scene.position = {1, 2, 0};
  const auto tool = make_tool_surface(scene, "die", folder.path(), 50);
  EXPECT_NEAR(look_up(*tool, Vec3(30.75, 2, 0)).gap, 1.0, 1e-5);
  scene.file = folder.path() + "/die.stl";  // absolute paths stay as they are
  EXPECT_NEAR(look_up(*make_tool_surface(scene, "die", "/elsewhere", 50), Vec3(30.75, 2, 0)).gap, 1.0, 1e-5);
  scene.flip = true;
  EXPECT_NEAR(look_up(*make_tool_surface(scene, "die", "", 50), Vec3(30.75, 2, 0)).gap, -1.0, 1e-5);
  scene.unit_scale = 2.0;
  EXPECT_NEAR(look_up(*make_tool_surface(scene, "die", "", 50), Vec3(60, 2, 0)).gap, -2.5, 1e-4);
}

TEST(MakeTool, NormalRulesTellApart) {
  const Folder folder;
  folder.write("die.stl", make_binary_stl(make_square_die({}), "die"));
  ToolScene scene;
  scene.file = "die.stl";
  std::vector<Vec3> normals;
  for (const char* rule : {"facet", "plain", "area", "max"}) {
    scene.normals = rule;
    // On the corner's second facet, near the tangent line.
    normals.push_back(
        look_up(*make_tool_surface(scene, "die", folder.path(), 50), Vec3(30.7, 20.9, 1)).normal);
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT((normals[i] - normals[j]).norm(), 1e-6) << i << " " << j;
  }
}

TEST(MakeTool, ErrorsNameTheTool) {
  const auto fail = [](const ToolScene& scene) {
    return catch_input_error([&] { make_tool_surface(scene, "die", "/nowhere", 50); });
  };
  EXPECT_THAT(fail(make_scene("blob")), AllOf(HasSubstr("tool.die"), HasSubstr("blob")));
  EXPECT_THAT(fail(make_scene("mesh")), AllOf(HasSubstr("tool.die"), HasSubstr("file")));
  ToolScene scene = make_scene("mesh");
  scene.file = "die.stl";
  EXPECT_THAT(fail(scene), HasSubstr("/nowhere/die.stl: no such file"));
  scene = make_scene("cylinder");
  scene.radius = 0;
  EXPECT_THAT(fail(scene), HasSubstr("radius_mm"));
  scene = make_scene("cylinder");
  scene.side = "below";
  EXPECT_THAT(fail(scene), HasSubstr("inside or outside"));
  scene = make_scene("torus");
  scene.minor_radius = 31;
  EXPECT_THAT(fail(scene), HasSubstr("minor_radius_mm"));
  scene = make_scene("box");
  scene.corner_radius = 16;
  EXPECT_THAT(fail(scene), HasSubstr("corner_radius_mm"));
  scene = make_scene("plane");
  scene.direction = {0, 0, 0};
  EXPECT_THAT(fail(scene), HasSubstr("direction"));
}

}  // namespace
}  // namespace hydroscope
