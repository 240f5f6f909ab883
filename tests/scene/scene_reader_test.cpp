// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/scene_reader.h"

#include <filesystem>
#include <fstream>

#include "scene_texts.h"

namespace hydroscope::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(SceneReader, FillsTheAggregates) {
  const Scene scene = read(kTube);
  EXPECT_EQ(scene.title, "Free expansion");
  EXPECT_EQ(scene.sheet, "tube");
  EXPECT_EQ(scene.directory, ".");
  EXPECT_EQ(scene.tube.radius, 30.0);
  EXPECT_EQ(scene.tube.outer_radius, 30.75);
  EXPECT_EQ(scene.tube.extent, "slice");
  EXPECT_EQ(scene.tube.elements_around, 8);
  EXPECT_EQ(scene.material.swift_k, 550.0);
  EXPECT_THAT(scene.load.pressure.times, ElementsAre(0.0, 1.0));
  EXPECT_THAT(scene.load.pressure.values, ElementsAre(0.0, 17.0));
  EXPECT_EQ(scene.tools.at("die").friction, 0.05);
  EXPECT_EQ(scene.quantities.at("t_mm").angle, 45.0);
  EXPECT_EQ(scene.end_time(), 1.0);
}

TEST(SceneReader, LeavesDefaultsAlone) {
  const Scene scene = read(kTube), fresh;
  EXPECT_EQ(scene.material.poisson, fresh.material.poisson);
  EXPECT_EQ(scene.increment.max_strain, fresh.increment.max_strain);
  EXPECT_EQ(scene.frames.views, fresh.frames.views);
  EXPECT_EQ(scene.contact.release_tolerance, fresh.contact.release_tolerance);
}

TEST(SceneReader, OuterRadiusBecomesMidSurface) {
  const Scene scene = read(with_line(kTube, 3, "outer_radius_mm = 20.0"));
  EXPECT_EQ(scene.tube.radius, 19.25);
  EXPECT_EQ(scene.tube.outer_radius, 20.0);
}

TEST(SceneReader, StripWithEdges) {
  const Scene scene = read(kStrip);
  EXPECT_EQ(scene.sheet, "strip");
  EXPECT_THAT(scene.edges.at("start").hold, ElementsAre("x", "y", "rotation"));
  EXPECT_EQ(scene.edges.at("end").tension.values.back(), 100.0);
}

TEST(SceneReader, EveryToolShapeAndMotion) {
  const Scene scene = read(kTube + R"([tool.punch]
shape = "torus"
radius_mm = 10
minor_radius_mm = 2
direction = [0, 1, 0]
motion_mm = [[0, 0, 0, 0], [3, 0, -5.5, 0]]
leaves_at_s = 4
[tool.floor]
shape = "plane"
point_mm = [0, -1, 0]
[tool.box]
shape = "box"
half_width_mm = 30
half_height_mm = 20
corner_radius_mm = 6
[tool.cad]
file = "die.stl"
unit_scale = 1000
)");
  EXPECT_EQ(scene.tools.size(), 5U);
  EXPECT_EQ(scene.tools.at("punch").motion[1][2], -5.5);
  EXPECT_EQ(scene.tools.at("punch").leaves_at, 4.0);
  EXPECT_EQ(scene.tools.at("floor").point[1], -1.0);
  EXPECT_EQ(scene.tools.at("cad").shape, "mesh");
  EXPECT_EQ(scene.end_time(), 3.0);
}

TEST(SceneReader, QuantitiesCombineAndStop) {
  const Scene scene = read(kTube + R"([quantity.r45_mm]
kind = "corner_radius"
half_width_mm = 20.5
[quantity.rho_mm]
kind = "sum"
of = ["r45_mm", "t_mm"]
factors = [1, -0.5]
[quantity.both]
kind = "sum"
of = ["rho_mm", "t_mm"]
[stop]
quantity = "rho_mm"
below = 9.0
)");
  EXPECT_EQ(scene.quantities.at("r45_mm").angle, 45.0);
  EXPECT_THAT(scene.quantities.at("rho_mm").factors, ElementsAre(1.0, -0.5));
  EXPECT_THAT(scene.quantities.at("both").factors, ElementsAre(1.0, 1.0));
  EXPECT_EQ(scene.stop.below, 9.0);
  EXPECT_FALSE(scene.stop.above.has_value());
}

TEST(SceneReader, UnusedLoadDoesNotProlongTheRun) {
  const std::string text =
      with_line(kTube, 16, "pressure_MPa = [[0, 0], [1, 17]]\nvolume_ratio = [[0, 1], [5, 2]]");
  EXPECT_EQ(read(text).end_time(), 1.0);
  EXPECT_EQ(read(text, {"load.control=volume"}).end_time(), 5.0);
}

TEST(SceneReader, ReadsAFileAndItsFolder) {
  const auto folder = std::filesystem::temp_directory_path() / "hydroscope_scene_reader_test";
  std::filesystem::create_directories(folder);
  const std::string file = (folder / "a.toml").string();
  std::ofstream(file) << kTube;
  const Scene scene = read_scene(file);
  EXPECT_EQ(scene.directory, folder.string());
  EXPECT_EQ(scene.file, file);
  std::ofstream(file) << kTube << "[tool.cad]\nfile = \"missing.stl\"\n";
  try {
    read_scene(file);
    ADD_FAILURE() << "a missing tool file went unnoticed";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file + ":25: key 'tool.cad.file': no such file: '"));
  }
  std::filesystem::remove_all(folder);
  EXPECT_THROW(read_scene(file), InputError);
  EXPECT_THROW(read_scene("/"), InputError);
}

}  // namespace
}  // namespace hydroscope::test
