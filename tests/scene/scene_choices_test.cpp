// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "solver/session/accuracy_choices.h"
#include "solver/session/error_estimate.h"
#include "solver/session/part_symmetry.h"
#include "tests/scene/scene_texts.h"

namespace hydroscope::test {
namespace {

/// A whole tube in a square die, 100 mm long.
const std::string kDie = R"(accuracy = 0.01
[tube]
radius_mm = 30
thickness_mm = 0.3
length_mm = 100
[material]
youngs_modulus_MPa = 193e3
hardening = "swift"
swift_K_MPa = 1400.0
swift_eps0 = 0.05
swift_n = 0.5
[load]
pressure_MPa = [[0.0, 0.0], [1.0, 28.0]]
[tool.die]
shape = "box"
half_width_mm = 30.15
half_height_mm = 30.15
corner_radius_mm = 7.0
[quantity.t_mm]
kind = "thickness"
angle_deg = 225
z_mm = 20
)";

Scene choose(const std::string& text, const std::vector<std::string>& assignments = {}) {
  std::vector<SceneOverride> overrides;
  for (const std::string& assignment : assignments) overrides.push_back(make_override(assignment));
  return choose_for_accuracy(parse_scene(text, "a.toml", overrides), {});
}

std::string find_reason(const Scene& scene, const std::string& key) {
  for (const Choice& choice : scene.choices) {
    if (choice.key == key) return choice.value + ": " + choice.reason;
  }
  return "";
}

TEST(Accuracy, WholeTubeInASquareDieBecomesAnOctantSlice) {
  const Scene scene = choose(kDie);
  EXPECT_EQ(scene.tube.section, "octant");
  EXPECT_EQ(scene.tube.extent, "slice");
  EXPECT_EQ(scene.tube.elements_along, 1);
  EXPECT_NEAR(scene.quantities.at("t_mm").angle, 45.0, 1e-9);  // 225 degrees is a corner, too
  EXPECT_EQ(scene.quantities.at("t_mm").z, 0.0);
  EXPECT_GT(scene.tube.elements_around, 8);
  EXPECT_LT(scene.tube.elements_around, 40);
  EXPECT_THAT(find_reason(scene, "tube.section"), ::testing::HasSubstr("mirror at 0 and 45"));
  EXPECT_THAT(describe_choices(scene), ::testing::HasSubstr("tube.extent = slice: instead of full"));
}

TEST(Accuracy, SymmetryIsRefusedWhereToolsLackIt) {
  EXPECT_EQ(choose(kDie, {"tool.die.half_height_mm=31"}).tube.section, "quarter");
  EXPECT_EQ(choose(kDie, {"tool.die.rotation_deg=[0,0,45]"}).tube.section, "octant");
  const Scene turned = choose(kDie, {"tool.die.rotation_deg=[0,0,30]"});
  EXPECT_EQ(turned.tube.section, "full");
  EXPECT_EQ(find_reason(turned, "tube.section"), "full: stays: tool 'die' has no mirror image there");
  EXPECT_EQ(choose(kDie, {"tool.die.half_width_mm=32", "tool.die.half_height_mm=32",
                          "tool.die.position_mm=[1,0,0]"})
                .tube.section,
            "half");
  EXPECT_EQ(choose(kDie, {"tool.die.motion_mm=[[0,0,0,0],[1,0.1,0,0]]"}).tube.section, "half");
  EXPECT_EQ(choose(kDie, {"load.pressure_MPa=[[0,0],[1,-1]]"}).tube.section, "full");
  EXPECT_EQ(choose(kDie, {"tool.die.shape=cylinder", "tool.die.radius_mm=31"}).tube.section, "sector");
  EXPECT_NE(
      choose(kDie, {"tool.die.shape=cylinder", "tool.die.radius_mm=31", "tool.die.direction=[0,0.01,1]"})
          .tube.section,
      "sector");
}

TEST(Accuracy, PairsOfToolsAreEachOthersImages) {
  const auto planes = [](const std::string& friction) {
    return kDie + "[tool.up]\nshape = \"plane\"\npoint_mm = [0, 33, 0]\ndirection = [0, -1, 0]\n" +
           "[tool.down]\nshape = \"plane\"\npoint_mm = [0, -33, 0]\ndirection = [0, 1, 0]\nfriction = " +
           friction + "\n";
  };
  EXPECT_EQ(choose(planes("0.0")).tube.section, "quarter");
  EXPECT_EQ(choose(planes("0.1")).tube.section, "full");
}

TEST(Accuracy, SliceAndHalfNeedTheirEnds) {
  EXPECT_EQ(choose(kDie, {"ends.axial=free"}).tube.extent, "half");
  EXPECT_EQ(choose(kDie, {"ends.radial=held"}).tube.extent, "half");
  EXPECT_EQ(choose(kDie, {"ends.rotation=held"}).tube.extent, "half");
  EXPECT_EQ(choose(kDie, {"tool.die.rotation_deg=[0,5,0]"}).tube.extent, "full");
  const Scene rubbed = choose(kDie, {"tool.die.motion_mm=[[0,0,0,0],[1,0,0,1]]", "tool.die.friction=0.1"});
  EXPECT_EQ(rubbed.tube.extent, "full");
}

TEST(Accuracy, WholeForcesAreSumsOfParts) {
  const std::string force = kDie + "[quantity.F]\nkind = \"contact_force\"\ntool = \"die\"\n";
  const Scene whole = choose(force);
  EXPECT_EQ(whole.tube.section, "octant");
  EXPECT_EQ(whole.quantities.at("F").kind, "sum");
  EXPECT_EQ(whole.quantities.at("F").factors, (std::vector<double>{8.0}));
  EXPECT_EQ(whole.quantities.at("F_of_part").range, (std::array<double, 2>{0.0, 45.0}));
  const Scene part = choose(force, {"quantity.F.angle_range_deg=[10, 30]"});
  EXPECT_EQ(part.quantities.at("F").kind, "contact_force");
  const Scene odd = choose(force, {"quantity.F.angle_range_deg=[10, 70]"});
  EXPECT_EQ(odd.tube.section, "full");
  EXPECT_THAT(find_reason(odd, "tube.section"), ::testing::HasSubstr("quantity 'F' ends inside octant"));
}

TEST(Accuracy, TheUsersWordCounts) {
  const int needed = choose(kDie).tube.elements_around;
  EXPECT_EQ(choose(kDie, {"tube.elements_around=400"}).tube.elements_around, 50);  // an eighth of them
  const Scene coarse = choose(kDie, {"tube.elements_around=16"});
  EXPECT_EQ(coarse.tube.elements_around, needed);
  EXPECT_THAT(find_reason(coarse, "tube.elements_around"), ::testing::HasSubstr("raised from 2"));
  const Scene given =
      choose(kDie, {"increment.tolerance=1e-6", "shell.thickness_points=9", "contact.curvature=none"});
  EXPECT_EQ(given.increment.tolerance, 1e-6);
  EXPECT_EQ(given.shell.thickness_points, 9);
  EXPECT_EQ(given.contact.curvature, "none");
  EXPECT_THAT(find_reason(given, "contact.curvature"), ::testing::HasSubstr("as given"));
}

TEST(Accuracy, AskedForOnTheCommandLineChoosesAnew) {
  std::string text =
      kDie.substr(kDie.find('\n') + 1) + "[increment]\ntolerance = 1e-6\n[contact]\ncurvature = \"none\"\n";
  text.insert(text.find("length_mm"), "elements_around = 400\n");
  const Scene scene = choose(text, {"accuracy=0.01"});
  EXPECT_EQ(scene.tube.elements_around, choose(kDie).tube.elements_around);
  EXPECT_GT(scene.increment.tolerance, 1e-5);
  EXPECT_EQ(scene.contact.curvature, "symmetric");
  EXPECT_EQ(choose(text, {"accuracy=0.01", "increment.tolerance=1e-7"}).increment.tolerance, 1e-7);
}

TEST(Accuracy, FinerForMore) {
  int last = 0;
  for (const char* accuracy : {"accuracy=0.05", "accuracy=0.01", "accuracy=0.003"}) {
    const Scene scene = choose(kDie, {accuracy});
    EXPECT_GT(scene.tube.elements_around, last);
    last = scene.tube.elements_around;
  }
  EXPECT_LE(choose(kDie, {"accuracy=0.001"}).increment.tolerance, 1e-4);
}

TEST(Accuracy, CompanionIsHalfAsFine) {
  const Scene scene = choose(kDie, {"accuracy=0.003"}), half = make_companion(scene);
  EXPECT_EQ(half.tube.elements_around, (scene.tube.elements_around + 1) / 2);
  EXPECT_EQ(half.increment.largest, 2.0 * scene.increment.largest);
  EXPECT_LT(half.shell.thickness_points, scene.shell.thickness_points);
  EXPECT_EQ(half.accuracy, 0.0);
  EXPECT_TRUE(choose_for_accuracy(half, {}).choices.size() == scene.choices.size()) << "chosen once only";
}

TEST(Accuracy, WithoutItCountsAreNeededAndNothingIsChosen) {
  const std::string text = kDie.substr(kDie.find('\n') + 1);
  EXPECT_THROW(parse_scene(text, "a.toml"), InputError);
  EXPECT_THROW(choose(kDie, {"accuracy=0.0005"}), InputError);
  EXPECT_THROW(choose(kDie, {"accuracy=0.5"}), InputError);
  EXPECT_TRUE(choose(kTube).choices.empty());
}

TriangleMesh make_drum(double radius, int facets, double turned) {
  TriangleMesh mesh;
  for (int i = 0; i < facets; ++i) {
    const double a = 2.0 * std::numbers::pi * i / facets + turned;
    for (const double z : {-60.0, 60.0})
      mesh.points.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
    const int p = 2 * i, q = 2 * ((i + 1) % facets);
    mesh.triangles.push_back({p, q + 1, q});
    mesh.triangles.push_back({p, p + 1, q + 1});
  }
  return mesh;
}

TEST(Accuracy, MeshesAreJudgedByTheirVertices) {
  const MeshFacts facts = inspect_mesh(make_drum(31.0, 72, 0.0), 40.0);
  EXPECT_TRUE(facts.is_prismatic);
  EXPECT_NEAR(facts.least_radius, 31.0, 0.1);
  EXPECT_TRUE(is_mirrored(facts.mesh, Vec3::UnitX()));
  EXPECT_FALSE(is_mirrored(make_drum(31.0, 72, 0.02), Vec3::UnitX()));
  EXPECT_TRUE(is_mirrored(make_drum(31.0, 72, 0.02), Vec3::UnitZ()));
  const std::string text = kDie.substr(0, kDie.find("shape")) + "shape = \"mesh\"\nfile = \"die.stl\"\n" +
                           kDie.substr(kDie.find("[quantity"));
  const Scene scene = parse_scene(text, "a.toml");
  EXPECT_EQ(choose_for_accuracy(scene, {{"die", facts}}).tube.section, "octant");
  EXPECT_EQ(choose_for_accuracy(scene, {{"die", facts}}).tube.extent, "slice");
  EXPECT_EQ(choose_for_accuracy(scene, {{"die", inspect_mesh(make_drum(31.0, 72, 0.02), 40.0)}}).tube.section,
            "full");
}

TEST(ErrorEstimate, TakesItsShareOfTheDifference) {
  // x^2 is caught by cubics without error; a force that ends at nothing is measured against its largest
  // value.
  const auto make = [](double scale, int steps) {
    QuantityHistory history;
    for (int i = 1; i <= steps; ++i) {
      const double t = 2.0 * i / steps;
      history.times.push_back(t);
      history.values.push_back({scale * t * t, scale * t * (2.0 - t)});
    }
    return history;
  };
  const ErrorEstimate estimate =
      compare_histories(make(1.0, 20), make(1.02, 7), {"size", "force"}, {false, true}, {0.0, 1.0, 2.0}, 0.5);
  ASSERT_EQ(estimate.errors.size(), 2U);
  EXPECT_NEAR(estimate.errors[0].relative, 0.01, 1e-12);
  EXPECT_NEAR(estimate.errors[1].relative, 0.01, 1e-12);
  EXPECT_NEAR(estimate.errors[1].time, 1.0, 1e-12);
  EXPECT_NEAR(estimate.worst, 0.01, 1e-12);
  EXPECT_FALSE(compare_histories({}, make(1.0, 5), {"size"}, {false}, {}, 0.5).trouble.empty());
}

}  // namespace
}  // namespace hydroscope::test
