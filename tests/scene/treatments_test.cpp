// SPDX-License-Identifier: GPL-3.0-or-later
// Keys that choose a treatment of the method: what they allow, what they need, what follows from them.
#include "scene_texts.h"

namespace hydroscope::test {
namespace {

using testing::HasSubstr;

TEST(SceneTreatments, DefaultsAreTheOnesOfTheReference) {
  const Scene scene = read(kTube);
  EXPECT_EQ(scene.contact.curvature, "symmetric");
  EXPECT_EQ(scene.contact.constraint, "elimination");
  EXPECT_EQ(scene.contact.friction_law, "return-mapping");
  EXPECT_EQ(scene.contact.release, "full");
  EXPECT_EQ(scene.increment.correction, "newton");
  EXPECT_EQ(scene.increment.control, "r_min");
  EXPECT_TRUE(scene.shell.director_stiffness && scene.shell.curvature_terms);
}

TEST(SceneTreatments, WordsThatAreNone) {
  EXPECT_THAT(error_of(kTube, {"contact.curvature=fulll"}),
              HasSubstr("allowed: \"none\", \"known-radius\", \"symmetric\", \"full\""));
  EXPECT_THAT(error_of(kTube, {"contact.friction_law=one-step"}), HasSubstr("\"one-step-behind\""));
  EXPECT_THAT(error_of(kTube, {"contact.release=signs"}),
              HasSubstr("allowed: \"full\", \"fluid\", \"sign\""));
  EXPECT_THAT(error_of(kTube, {"contact.constraint=penalties"}), HasSubstr("\"penalty\""));
  EXPECT_THAT(error_of(kTube, {"increment.correction=algo"}), HasSubstr("\"algoneq\""));
  EXPECT_THAT(error_of(kTube, {"increment.control=rmin"}), HasSubstr("allowed: \"r_min\", \"error\""));
}

/// A key of a treatment that is not chosen would do nothing: it is refused.
TEST(SceneTreatments, KeysOfOtherTreatments) {
  for (const std::string key : {"contact.penalty_N_per_mm=1e30", "increment.r_safe=3",
                                "increment.algoneq_passes=2", "increment.error_tolerance=1e-3"}) {
    EXPECT_THAT(error_of(kTube, {key}), HasSubstr("has no effect here")) << key;
  }
  EXPECT_EQ(error_of(kTube, {"contact.constraint=penalty", "contact.penalty_N_per_mm=1e30"}), "no error");
  EXPECT_EQ(error_of(kTube, {"increment.correction=one-step-behind", "increment.r_safe=3"}), "no error");
  EXPECT_EQ(error_of(kTube, {"increment.correction=algoneq", "increment.algoneq_passes=2"}), "no error");
  EXPECT_EQ(error_of(kTube, {"increment.control=error", "increment.error_tolerance=1e-3"}), "no error");
}

/// Exact surfaces know their radius; of a tool from a file the user must say it.
TEST(SceneTreatments, KnownRadiusNeedsARadius) {
  const std::string known = "contact.curvature=known-radius";
  EXPECT_EQ(error_of(kTube, {known}), "no error");
  const std::string mesh = with_line(with_line(kTube, 18, "shape = \"mesh\""), 19, "file = \"a.stl\"");
  EXPECT_EQ(error_of(mesh), "no error");
  const std::string error = error_of(mesh, {known});
  EXPECT_EQ(error,
            "a.toml:17: table [tool.die]: key 'known_radius_mm' is missing; contact.curvature = "
            "\"known-radius\" needs it for a tool from a file");
  EXPECT_EQ(error_of(mesh, {known, "tool.die.known_radius_mm=32"}), "no error");
  EXPECT_EQ(read(mesh, {known, "tool.die.known_radius_mm=32"}).tools.at("die").known_radius, 32.0);
  EXPECT_THAT(error_of(kTube, {known, "tool.die.known_radius_mm=32"}), HasSubstr("has no effect here"));
  EXPECT_THAT(error_of(mesh, {"tool.die.known_radius_mm=0"}), HasSubstr("out of range"));
}

/// Explicit steps draw the limits of r_min tight, but never against the user's word.
TEST(SceneTreatments, ExplicitStepsChooseTightLimits) {
  const IncrementScene newton = read(kTube).increment;
  EXPECT_EQ(newton.max_strain, 0.03);
  EXPECT_TRUE(newton.stop_at.empty());
  for (const std::string correction : {"none", "one-step-behind", "algoneq"}) {
    const std::string set = "increment.correction=" + correction;
    const IncrementScene tight = read(kTube, {set}).increment;
    EXPECT_EQ(tight.max_strain, 0.003);
    EXPECT_EQ(tight.max_rotation, 1.0);
    EXPECT_EQ(tight.max_penetration, 0.01);
    EXPECT_EQ(tight.stop_at, (std::vector<std::string>{"yield", "release", "slip"}));
    const IncrementScene given =
        read(kTube, {set, "increment.max_strain=0", "increment.max_rotation_deg=5", "increment.stop_at=[]"})
            .increment;
    EXPECT_EQ(given.max_strain, 0.0);
    EXPECT_EQ(given.max_rotation, 5.0);
    EXPECT_TRUE(given.stop_at.empty());
    EXPECT_EQ(given.max_penetration, 0.01);
  }
}

/// 0 switches a limit off; less is no number for it.
TEST(SceneTreatments, LimitsMayBeZeroAndNotBelow) {
  for (const std::string key : {"max_strain", "max_rotation_deg", "max_slide"}) {
    EXPECT_EQ(error_of(kTube, {"increment." + key + "=0"}), "no error");
    EXPECT_THAT(error_of(kTube, {"increment." + key + "=-1"}), HasSubstr("out of range")) << key;
  }
}

}  // namespace
}  // namespace hydroscope::test
