// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/make_tool.h"

#include <gmock/gmock.h>

#include "scenes/generators/die_meshes.h"
#include "solver/geometry/grid_mesh.h"
#include "solver/geometry/quad_prism.h"
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

/// A mesh file of quads: the cells of a grid mesh, two facets each.
std::string make_quad_obj(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  for (const Vec3& p : mesh.points) text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  for (std::size_t f = 0; f + 1 < mesh.triangles.size(); f += 2) {
    const auto quad = cover_with_quads(mesh, {{static_cast<int>(f), static_cast<int>(f) + 1}}).quads.at(0);
    text << "f " << quad[0] + 1 << ' ' << quad[1] + 1 << ' ' << quad[2] + 1 << ' ' << quad[3] + 1 << '\n';
  }
  return text.str();
}

/// A quarter of a torus's inner side, skew, with an axis along which it has no walls.
TriangleMesh make_saddle() {
  return make_grid_mesh(13, 11, [](int i, int j) {
    const double x = i - 6, y = j - 5 + 0.05 * i;
    return Vec3(x, y, 0.04 * x * x - 0.03 * y * y + 0.02 * x * y);
  });
}

TEST(MakeTool, FormsTellApart) {
  const Folder folder;
  folder.write("saddle.obj", make_quad_obj(make_saddle()));
  ToolScene scene;
  scene.file = "saddle.obj";
  scene.pitch = 0.7;
  std::vector<FootPoint> feet;
  const Vec3 x(1.37, 2.21, 0.4);
  for (const char* surface : {"smooth", "facets", "quads", "nagata", "points"}) {
    scene.surface = surface;
    feet.push_back(look_up(*make_tool_surface(scene, "t", folder.path(), 50), x));
    // All of them are the same saddle but for their facets.
    EXPECT_NEAR(feet.back().gap, feet.front().gap, 0.03) << surface;
    EXPECT_GT(feet.back().normal.dot(feet.front().normal), 0.999) << surface;
  }
  for (std::size_t i = 0; i < feet.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT(std::abs(feet[i].gap - feet[j].gap), 1e-7) << i << " " << j;
      // Bent and flat facets share the interpolated normal.
      if (i == 1) continue;
      EXPECT_GT((feet[i].normal - feet[j].normal).norm(), 1e-7) << i << " " << j;
    }
  }
}

TEST(MakeTool, ProjectionsTellApart) {
  const Folder folder;
  folder.write("die.stl", make_binary_stl(make_square_die({}), "die"));
  ToolScene scene;
  scene.file = "die.stl";
  scene.surface = "facets";
  const Vec3 x(30.7, 20.9, 1);
  const double prism = look_up(*make_tool_surface(scene, "t", folder.path(), 50), x).gap;
  scene.projection = "orthogonal";
  const auto orthogonal = make_tool_surface(scene, "t", folder.path(), 50);
  EXPECT_GT(std::abs(look_up(*orthogonal, x).gap - prism), 1e-7);
  SearchHint hint;
  EXPECT_FALSE(orthogonal->find_foot_point(Vec3(0, 0, 60), 1e3, 1e3, hint));  // beyond its end
}

TEST(MakeTool, SearchesGiveTheSameFootPoint) {
  const Folder folder;
  folder.write("die.stl", make_binary_stl(make_square_die({}), "die"));
  ToolScene scene;
  scene.file = "die.stl";
  std::vector<FootPoint> feet;
  for (const char* search : {"tree", "grid", "all"}) {
    scene.search = search;
    feet.push_back(look_up(*make_tool_surface(scene, "t", folder.path(), 50), Vec3(27, 22, 3)));
    EXPECT_EQ(feet.back().gap, feet.front().gap);
    EXPECT_EQ(feet.back().normal, feet.front().normal);
  }
  scene.search = "octree";
  EXPECT_THROW(make_tool_surface(scene, "t", folder.path(), 50), InputError);
}

TEST(MakeTool, PointsSampledAlongAnAxisAreThePlacedMesh) {
  // The cavity of a quarter of a square die, seen from the tube's axis along the diagonal.
  const Folder folder;
  folder.write("die.stl", make_binary_stl(make_square_die({}), "die"));
  ToolScene scene;
  scene.file = "die.stl";
  scene.position = {1, 2, 3};
  scene.rotation = {0, 0, 30};
  const auto mesh = make_tool_surface(scene, "t", folder.path(), 50);
  scene.surface = "points";
  scene.pitch = 0.25;
  scene.height_axis = {-1, -1, 0};
  const auto points = make_tool_surface(scene, "t", folder.path(), 50);
  const Pose pose = make_pose(scene.rotation, scene.position);
  for (double a : {0.2, 0.5, 0.785, 1.1, 1.4}) {
    const Vec3 x = pose.place_point(Vec3(29 * std::cos(a), 29 * std::sin(a), 4.4));
    EXPECT_NEAR(look_up(*points, x).gap, look_up(*mesh, x).gap, 0.01);
    EXPECT_LT((look_up(*points, x).normal - look_up(*mesh, x).normal).norm(), 0.02);
  }
  scene.height_axis = {-1, 0, 0};  // the other wall is vertical then
  EXPECT_THAT(catch_input_error([&] { make_tool_surface(scene, "die", folder.path(), 50); }),
              AllOf(HasSubstr("tool.die"), HasSubstr("height_axis")));
}

TEST(MakeTool, PointsFromAGridFile) {
  const Folder folder;
  folder.write("bowl.grid",
               "hydroscope-grid 1\ncolumns 3 rows 4\norigin -1 0 pitch 1 2\nheights\n"
               "1 0 1\n1 0 1\n1,0,1\n1, 0, 3\n");
  ToolScene scene;
  scene.shape = "points";
  scene.file = "bowl.grid";
  scene.normals = "facet";
  // A groove along y of 45 degree walls.
  const Vec3 x(0.6, 1.2, 1.0);
  EXPECT_NEAR(look_up(*make_tool_surface(scene, "t", folder.path(), 50), x).gap, 0.4 / std::sqrt(2.0), 1e-12);
  scene.unit_scale = 2.0;
  EXPECT_NEAR(look_up(*make_tool_surface(scene, "t", folder.path(), 50), 2 * x).gap, 0.8 / std::sqrt(2.0),
              1e-12);
  scene.unit_scale = 1.0;
  scene.position = {0, 0, 5};
  scene.flip = true;
  const FootPoint below = look_up(*make_tool_surface(scene, "t", folder.path(), 50), Vec3(0.6, 1.2, 5.2));
  EXPECT_NEAR(below.gap, 0.4 / std::sqrt(2.0), 1e-12);
  EXPECT_LT((below.normal - Vec3(1, 0, -1).normalized()).norm(), 1e-12);
  EXPECT_GT(look_up(*make_tool_surface(scene, "t", folder.path(), 50), Vec3(0.8, 5.5, 6)).gap,
            0.2);  // the high corner
}

TEST(MakeTool, ErrorsOfForms) {
  const Folder folder;
  folder.write("die.stl", make_binary_stl(make_square_die({}), "die"));
  const auto fail = [&](const ToolScene& scene) {
    return catch_input_error([&] { make_tool_surface(scene, "die", folder.path(), 50); });
  };
  ToolScene scene;
  scene.file = "die.stl";
  scene.surface = "quads";
  EXPECT_THAT(fail(scene), AllOf(HasSubstr("tool.die"), HasSubstr("no quadrilaterals")));
  scene.surface = "points";
  EXPECT_THAT(fail(scene), HasSubstr("pitch_mm"));
  scene.pitch = 1;
  EXPECT_THAT(fail(scene), AllOf(HasSubstr("tool.die"), HasSubstr("wall of 90.0 deg")));
  scene.flip = true;
  scene.height_axis = {-1, -1, 0};
  EXPECT_THAT(fail(scene), HasSubstr("overhangs"));
  scene.surface = "nagata";
  scene.normals = "facet";
  EXPECT_THAT(fail(scene), HasSubstr("averaged normals"));
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
