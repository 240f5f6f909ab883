// SPDX-License-Identifier: GPL-3.0-or-later
// What a single key can do wrong: name, type, unit, range. Exact words and places.
#include "scene_texts.h"

namespace hydroscope::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(SceneErrors, UnknownKeyNamesTheNearest) {
  EXPECT_EQ(error_of(with_line(kTube, 4, "thikness_mm = 1.5")),
            "a.toml:4: key 'tube.thikness_mm': unknown; did you mean 'thickness_mm'?");
  EXPECT_EQ(error_of(with_line(kTube, 20, "frcition = 0.1")),
            "a.toml:20: key 'tool.die.frcition': unknown; did you mean 'friction'?");
}

TEST(SceneErrors, WrongUnitNamesOurs) {
  EXPECT_EQ(error_of(with_line(kTube, 4, "thickness_m = 0.0015")),
            "a.toml:4: key 'tube.thickness_m': unknown; did you mean 'thickness_mm'?");
  EXPECT_EQ(error_of(with_line(kTube, 16, "pressure_bar = [[0, 0], [1, 170]]")),
            "a.toml:16: key 'load.pressure_bar': unknown; did you mean 'pressure_MPa'?");
}

TEST(SceneErrors, KeyOfAnotherTable) {
  EXPECT_EQ(error_of(with_line(kTube, 8, "elements_around = 8\nyoungs_modulus_MPa = 1e5")),
            "a.toml:9: key 'tube.youngs_modulus_MPa': unknown; it belongs to [material]");
}

TEST(SceneErrors, UnknownTable) {
  EXPECT_EQ(error_of(kTube + "[framse]\n"), "a.toml:24: table '[framse]': unknown; did you mean '[frames]'?");
  EXPECT_EQ(error_of(kTube + "[weather]\nrain = 1\n"), "a.toml:24: table '[weather]': unknown");
  EXPECT_EQ(error_of(kStrip + "[edge.left]\n"),
            "a.toml:14: table '[edge.left]': unknown; allowed: [edge.start] and [edge.end]");
  EXPECT_EQ(error_of(kTube + "[frames.camera]\nzoom = 1\n"),
            "a.toml:24: key 'frames.camera': is a table here; expected a value");
  EXPECT_EQ(error_of(kTube + "[tool.\"a/b\"]\nshape = \"plane\"\n"),
            "a.toml:24: table '[tool.a/b]': the name may have letters, digits, '_' and '-' only");
}

TEST(SceneErrors, TableByNameNeedsAName) {
  EXPECT_EQ(error_of("tool = 3\n" + kStrip), "a.toml:1: key 'tool': is a table; write [tool.NAME]");
  EXPECT_EQ(error_of(kTube + "[tool]\nfriction = 0.1\n"),
            "a.toml:25: key 'tool.friction': [tool] holds tables by name; write [tool.NAME]");
}

TEST(SceneErrors, WrongType) {
  EXPECT_EQ(error_of(with_line(kTube, 4, "thickness_mm = \"1.5\"")),
            "a.toml:4: key 'tube.thickness_mm': \"1.5\" has the wrong type; expected a number [mm]");
  EXPECT_EQ(error_of(with_line(kTube, 8, "elements_around = 8.0")),
            "a.toml:8: key 'tube.elements_around': 8 has the wrong type; expected a whole number");
  EXPECT_EQ(error_of(with_line(kTube, 16, "pressure_MPa = 17.0")),
            "a.toml:16: key 'load.pressure_MPa': 17 has the wrong type; expected a path [[s, MPa], ...]");
  EXPECT_EQ(error_of(with_line(kTube, 6, "extent = 2024-01-01")),
            "a.toml:6: key 'tube.extent': a date or time has the wrong type; expected text in quotes");
  EXPECT_EQ(error_of(kTube + "[load.x]\n"),
            "a.toml:24: key 'load.x': unknown; known here: control, pressure_MPa, "
            "volume_ratio, axial_feed_mm, pressure_surface, load_stiffness");
  EXPECT_THAT(error_of(with_line(kTube, 16, "pressure_MPa = [[0, 0], [1, 17, 3]]")),
              StartsWith("a.toml:16: key 'load.pressure_MPa': row [1, 17, 3] does not fit; expected a path"));
  EXPECT_THAT(error_of(kTube + "[frames]\nmirror = 1\n"),
              HasSubstr("1 has the wrong type; expected true or false"));
}

TEST(SceneErrors, OutOfRangeNamesValueAndRange) {
  EXPECT_EQ(error_of(with_line(kTube, 4, "thickness_mm = -1.5")),
            "a.toml:4: key 'tube.thickness_mm': -1.5 is out of range; allowed: 0.005 to 100");
  EXPECT_EQ(error_of(with_line(kTube, 20, "friction = -0.1")),
            "a.toml:20: key 'tool.die.friction': -0.1 is out of range; allowed: 0 to 10");
  EXPECT_EQ(error_of(with_line(kTube, 4, "thickness_mm = nan")),
            "a.toml:4: key 'tube.thickness_mm': nan is not a finite number");
  EXPECT_EQ(error_of(with_line(kTube, 8, "elements_around = 99999999999")),
            "a.toml:8: key 'tube.elements_around': 99999999999 is out of range; allowed: 1 to 100000");
  EXPECT_EQ(error_of(with_line(kTube, 16, "pressure_MPa = [[0, 0], [1, 17e6]]")),
            "a.toml:16: key 'load.pressure_MPa': row [1, 17000000]: 17000000 is out of range; allowed: "
            "-10000 to 10000");
}

TEST(SceneErrors, MetresTakenForMillimetres) {
  EXPECT_EQ(error_of(with_line(kTube, 3, "radius_mm = 0.03")),
            "a.toml:3: key 'tube.radius_mm': 0.03 is out of range; allowed: 0.5 to 10000");
}

TEST(SceneErrors, Choices) {
  EXPECT_EQ(
      error_of(with_line(kTube, 7, "section = \"octants\"")),
      "a.toml:7: key 'tube.section': \"octants\" is not known; did you mean \"octant\"? allowed: \"full\", "
      "\"half\", \"quarter\", \"octant\", \"sector\"");
  EXPECT_THAT(
      error_of(kTube + "[frames]\nviews = [\"contact_map\"]\n"),
      StartsWith(
          "a.toml:25: key 'frames.views': \"contact_map\" is not known; did you mean \"contact-map\"?"));
  EXPECT_EQ(error_of(kTube + "[frames]\nviews = [\"slip\", \"slip\"]\n"),
            "a.toml:25: key 'frames.views': \"slip\" stands twice");
}

TEST(SceneErrors, TimesMustIncrease) {
  EXPECT_EQ(
      error_of(with_line(kTube, 16, "pressure_MPa = [[0, 0], [1, 5], [1, 17]]")),
      "a.toml:16: key 'load.pressure_MPa': the first column must increase from row to row, but 1 follows 1");
  EXPECT_EQ(error_of(with_line(kTube, 16, "pressure_MPa = [[-1, 0], [1, 5]]")),
            "a.toml:16: key 'load.pressure_MPa': times start at -1 s; allowed: 0 s or later");
  EXPECT_THAT(error_of(with_line(kTube, 20, "motion_mm = [[0, 0, 0, 0], [0, 0, 0, 1]]")),
              StartsWith("a.toml:20: key 'tool.die.motion_mm': the first column must increase"));
  EXPECT_THAT(error_of(with_line(kTube, 16, "pressure_MPa = []")),
              StartsWith("a.toml:16: key 'load.pressure_MPa': is an empty list"));
}

TEST(SceneErrors, BrokenSyntax) {
  EXPECT_THAT(error_of(with_line(kTube, 4, "thickness_mm = ")), StartsWith("a.toml:4: not valid TOML: "));
  EXPECT_THAT(error_of(with_line(kTube, 4, "radius_mm = 3")), StartsWith("a.toml:4: not valid TOML: "));
}

TEST(SceneErrors, FirstInTheOrderOfTheFile) {
  const std::string text = with_line(with_line(kTube, 19, "radius_mn = 1"), 4, "thickness_mn = 1.5");
  EXPECT_THAT(error_of(text), StartsWith("a.toml:4:"));
}

}  // namespace
}  // namespace hydroscope::test
