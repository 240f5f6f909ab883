// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/results/result_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string error_of(const fs::path& path, bool force) {
  try {
    make_result_folder(path, force);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

void put(const fs::path& file) {
  fs::create_directories(file.parent_path());
  write_whole_file(file, "x");
}

TEST(ResultFolder, IsMadeWithItsParents) {
  const TemporaryFolder folder;
  make_result_folder(folder.path() / "a/b", false);
  EXPECT_TRUE(fs::is_directory(folder.path() / "a/b/states"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "a/b"), fs::directory_iterator()), 1);
}

TEST(ResultFolder, EmptyFolderIsTaken) {
  const TemporaryFolder folder;
  EXPECT_EQ(error_of(folder.path(), false), "no error");
}

TEST(ResultFolder, FullFolderIsRefusedAndTold) {
  const TemporaryFolder folder;
  const std::string start = "-o " + folder.path().string() + ": exists and ";
  put(folder.path() / "notes.txt");
  EXPECT_THAT(error_of(folder.path(), false), HasSubstr(start + "is not empty; --force"));
  put(folder.path() / "history.csv");
  EXPECT_THAT(error_of(folder.path(), false), HasSubstr(start + "holds what a run left that did not finish"));
  put(folder.path() / "summary.json");
  EXPECT_THAT(error_of(folder.path(), false), HasSubstr(start + "holds the results of a run"));
  EXPECT_TRUE(fs::exists(folder.path() / "summary.json"));
}

TEST(ResultFolder, ForceRemovesOursAndNothingElse) {
  const TemporaryFolder folder;
  const std::vector<std::string> ours = {"summary.json",           "history.csv",
                                         ".events.csv.part",       "states/00003.vtp",
                                         "tools/die.vtp",          "frames/contact-map/00001.png",
                                         "frames/slip/00001.json", "frames/slip.webp",
                                         "check/junit.xml",        "check/slip/00001-got.png"};
  const std::vector<std::string> foreign = {"notes.txt", "states/mine.vtp", "frames/slip/best.png",
                                            "paper/summary.json"};
  for (const auto& name : ours) put(folder.path() / name);
  for (const auto& name : foreign) put(folder.path() / name);
  make_result_folder(folder.path(), true);
  for (const auto& name : ours) EXPECT_FALSE(fs::exists(folder.path() / name)) << name;
  for (const auto& name : foreign) EXPECT_TRUE(fs::exists(folder.path() / name)) << name;
}

TEST(ResultFolder, WhatCannotBeWrittenIsBadInput) {
  const TemporaryFolder folder;
  put(folder.path() / "file");
  EXPECT_THAT(error_of(folder.path() / "file", true), HasSubstr("is a file"));
  EXPECT_THAT(error_of(folder.path() / "file/below", true), HasSubstr("cannot be written: Not a directory"));
  EXPECT_THAT(error_of("/proc/hydroscope", false), HasSubstr("-o /proc/hydroscope: cannot be written"));
}

TEST(ResultFolder, FramesOfAViewAreRemoved) {
  const TemporaryFolder folder;
  const std::vector<std::string> gone = {"frames/slip/00001.png", "frames/slip/.00002.png.part",
                                         "frames/slip.webp"};
  const std::vector<std::string> kept = {"frames/gap/00001.png", "frames/gap.mp4", "frames/slip/best.png",
                                         "summary.json"};
  for (const auto& name : gone) put(folder.path() / name);
  for (const auto& name : kept) put(folder.path() / name);
  remove_frames({folder.path()}, {"slip", "thickness"});
  for (const auto& name : gone) EXPECT_FALSE(fs::exists(folder.path() / name)) << name;
  for (const auto& name : kept) EXPECT_TRUE(fs::exists(folder.path() / name)) << name;
}

TEST(ResultFolder, StatesInOrder) {
  const TemporaryFolder folder;
  const ResultFolder results{folder.path()};
  EXPECT_THROW(find_states(results), InputError);
  put(folder.path() / ResultFolder::state_name(10));
  put(folder.path() / ResultFolder::state_name(2));
  const auto states = find_states(results);
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[0].filename(), "00002.vtp");
}

}  // namespace
}  // namespace hydroscope::test
