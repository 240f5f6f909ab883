// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/scene_reference.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "solver/scene/scene_table.h"

namespace hydroscope {
namespace {

// Tests run in the top folder of the project.
TEST(SceneReference, FileEqualsTheTable) {
  std::ifstream file("docs/scene_reference.md");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_TRUE(text.str() == make_scene_reference())
      << "make it anew: cmake --build BUILD --target scene_reference";
}

TEST(SceneReference, KeysCarryTheirUnit) {
  for (const SceneTable& table : scene_tables()) {
    for (const SceneKey& key : table.keys) {
      if (key.unit.empty()) continue;
      EXPECT_TRUE(key.name.ends_with("_" + key.unit)) << table.header() << " " << key.name;
    }
  }
}

TEST(SceneReference, EveryKeyIsASentence) {
  for (const SceneTable& table : scene_tables()) {
    for (const SceneKey& key : table.keys) {
      EXPECT_TRUE(key.doc.size() > 10 && key.doc.ends_with(".")) << table.header() << " " << key.name;
      EXPECT_EQ(key.doc.find('|'), std::string::npos) << key.name << ": would break the table";
    }
  }
}

TEST(SceneReference, ConditionsNameChoicesThatExist) {
  for (const SceneTable& table : scene_tables()) {
    for (const SceneKey& key : table.keys) {
      if (key.condition.key.empty()) continue;
      const SceneKey* selector = table.find(key.condition.key);
      ASSERT_NE(selector, nullptr) << key.name;
      for (const std::string& value : key.condition.values) {
        EXPECT_NE(std::find(selector->choices.begin(), selector->choices.end(), value),
                  selector->choices.end())
            << key.name << " for " << value;
      }
    }
  }
}

TEST(SceneReference, NoTwoKeysShareAMember) {
  for (const SceneTable& table : scene_tables()) {
    Scene scene;
    std::vector<const void*> members;
    for (const SceneKey& key : table.keys) {
      const SceneSlot slot = key.slot(scene, "a");
      const void* member = std::visit([](auto* pointer) -> const void* { return pointer; }, slot);
      EXPECT_EQ(std::find(members.begin(), members.end(), member), members.end()) << key.name;
      members.push_back(member);
    }
  }
}

}  // namespace
}  // namespace hydroscope
