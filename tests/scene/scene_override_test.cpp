// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "scene_texts.h"
#include "solver/scene/number_text.h"
#include "solver/scene/scene_table.h"
#include "solver/scene/scene_values.h"

namespace hydroscope::test {
namespace {

TEST(SceneOverride, ReplacesAKeyOfTheFile) {
  EXPECT_EQ(read(kTube, {"tool.die.friction=0.1"}).tools.at("die").friction, 0.1);
  EXPECT_EQ(read(kTube, {"tool.die.friction=0.1", "tool.die.friction = 0.2"}).tools.at("die").friction, 0.2);
  EXPECT_EQ(read(kTube, {"load.pressure_MPa=[[0, 0], [2, 20]]"}).end_time(), 2.0);
}

TEST(SceneOverride, AddsAKeyAndATable) {
  const Scene scene = read(
      kTube, {"title=Other", "frames.theme=dark", "frames.views=[]", "stop.quantity='t_mm'", "stop.below=1"});
  EXPECT_EQ(scene.title, "Other");
  EXPECT_EQ(scene.frames.theme, "dark");
  EXPECT_TRUE(scene.frames.views.empty());
  EXPECT_EQ(scene.stop.below, 1.0);
}

TEST(SceneOverride, TextNeedsNoQuotes) {
  EXPECT_EQ(read(kTube, {"tube.section=quarter"}).tube.section, "quarter");
  EXPECT_EQ(read(kTube, {"tube.section=\"quarter\""}).tube.section, "quarter");
}

TEST(SceneOverride, AnotherKindPassesOverKeysOfTheFirst) {
  const Scene scene = read(kTube, {"tool.die.shape=plane", "material.hardening=elastic"});
  EXPECT_EQ(scene.tools.at("die").shape, "plane");
  EXPECT_EQ(scene.material.hardening, "elastic");
}

TEST(SceneOverride, ErrorsNameTheOverride) {
  EXPECT_EQ(error_of(kTube, {"tool.die.friction=-1"}),
            "--set tool.die.friction=-1: key 'tool.die.friction': -1 is out of range; allowed: 0 to 10");
  EXPECT_EQ(error_of(kTube, {"tool.die.fricton=1"}),
            "--set tool.die.fricton=1: key 'tool.die.fricton': unknown; did you mean 'friction'?");
  EXPECT_EQ(error_of(kTube, {"tool.die.half_width_mm=1"}),
            "--set tool.die.half_width_mm=1: key 'tool.die.half_width_mm': has no effect here; it is for "
            "shape = \"box\"");
  EXPECT_EQ(error_of(kTube, {"tol.die.friction=1"}),
            "--set tol.die.friction=1: table '[tol]': unknown; did you mean '[tool]'?");
  EXPECT_EQ(error_of(kTube, {"tool.dei.friction=1"}),
            "--set tool.dei.friction=1: key 'tool.dei.file' is missing (needed with shape = \"mesh\" or \"points\")");
}

TEST(SceneOverride, Malformed) {
  EXPECT_EQ(error_of(kTube, {"friction"}),
            "--set friction: write it as key=value, e.g. --set tool.die.friction=0.1");
  EXPECT_EQ(
      error_of(kTube, {"tool.die.friction="}),
      "--set tool.die.friction=: '' is not a TOML value (a number, true, false, \"text\" or [a, list])");
  EXPECT_EQ(error_of(kTube, {"tube=3"}), "--set tube=3: key 'tube': is a table; write [tube]");
}

/// Writes each key's default by --set and expects the same scene member back.
TEST(SceneOverride, EveryDefaultSurvivesTheRoundTrip) {
  int checked = 0;
  for (const SceneTable& table : scene_tables()) {
    for (const SceneKey& key : table.keys) {
      Scene before, after;
      const std::string name = table.is_named() ? (table.of.front() == "*" ? "a" : table.of.front()) : "";
      const std::string written = format_slot(key.slot(before, name));
      if (written.empty()) continue;
      const SceneSource source = parse_scene_source("", "a.toml", {{"x.y", written, "--set"}});
      const SceneSlot slot = key.slot(after, name);
      SceneKey unlimited = key;
      unlimited.range = {};
      EXPECT_EQ(assign_value(source.entries.front().value, unlimited, slot), "")
          << key.name << " = " << written;
      EXPECT_EQ(format_slot(slot), written) << key.name;
      ++checked;
    }
  }
  EXPECT_GT(checked, 60);
}

TEST(SceneOverride, NumbersSurviveToTheLastBit) {
  for (const double number : {0.1, 1.0 / 3.0, 6.02214076e-9, 9.999999999999999}) {
    EXPECT_EQ(read(kTube, {"tool.die.friction=" + format_exact(number)}).tools.at("die").friction, number);
  }
}

}  // namespace
}  // namespace hydroscope::test
