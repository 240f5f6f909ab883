// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "solver/scene/scene_reader.h"

namespace hydroscope {
namespace {

// Tests run in the top folder of the project. Die meshes may not have been generated yet.
TEST(ShippedScenes, AllRead) {
  for (const auto& entry : std::filesystem::directory_iterator("scenes")) {
    if (entry.path().extension() != ".toml") continue;
    std::ifstream file(entry.path());
    std::ostringstream text;
    text << file.rdbuf();
    EXPECT_NO_THROW({
      const Scene scene = parse_scene(text.str(), entry.path().string());
      EXPECT_FALSE(scene.title.empty()) << entry.path();
      EXPECT_EQ(text.str().front(), '#') << entry.path() << " should begin with what it reproduces";
    }) << entry.path();
  }
}

/// The first thing that a newcomer copies.
TEST(ShippedScenes, ExampleOfTheReadmeReads) {
  std::ifstream file("README.md");
  std::ostringstream text;
  text << file.rdbuf();
  const std::string start = "```toml\n", readme = text.str();
  const size_t from = readme.find(start) + start.size();
  const Scene scene = parse_scene(readme.substr(from, readme.find("```", from) - from), "README.md");
  EXPECT_EQ(scene.sheet, "tube");
  EXPECT_EQ(scene.tools.size(), 1U);
}

}  // namespace
}  // namespace hydroscope
