// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/workstation/replay.h"
#include "solver/base/error.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

using testing::HasSubstr;

class JournalTest : public testing::Test {
 protected:
  void write() {
    Journal journal(path_, {"0.1", "a b.toml", "00ff", {{"die.stl", "12"}}, {"x.y=\"q, \\n\""}, 3, ""});
    journal.add({0, 7, 0.1, "some\none", "until pressure 1", "", "", 0xfedcba9876543210ULL, ""});
    journal.add({2, 9, 1.0 / 3.0, "", "", "completed", "all, done", 1, ""});
  }
  std::string fault() const {
    try {
      read_journal(path_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no fault";
  }

  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "journal.jsonl";
};

TEST_F(JournalTest, ComesBackLineByLine) {
  write();
  const std::string text = read_text(path_);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  const JournalContents read = read_journal(path_);
  EXPECT_EQ(read.trouble, "");
  EXPECT_EQ(read.head.scene, "a b.toml");
  EXPECT_EQ(read.head.files, (std::vector<std::pair<std::string, std::string>>{{"die.stl", "12"}}));
  EXPECT_EQ(read.head.overrides.at(0), "x.y=\"q, \\n\"");
  EXPECT_EQ(read.head.threads, 3);
  ASSERT_EQ(read.entries.size(), 2U);
  EXPECT_EQ(read.entries[0].who, "some\none");
  EXPECT_EQ(read.entries[0].command, "until pressure 1");
  EXPECT_EQ(read.entries[0].state, 0xfedcba9876543210ULL);
  EXPECT_FALSE(read.entries[0].is_end());
  EXPECT_EQ(read.entries[1].time, 1.0 / 3.0);
  EXPECT_EQ(read.entries[1].branch, 2);
  EXPECT_EQ(read.entries[1].outcome, "completed");
}

TEST_F(JournalTest, ABrokenLastLineIsLeftOutAndNoted) {
  write();
  const std::string text = read_text(path_);
  for (const std::size_t lost : {std::size_t{2}, std::size_t{40}}) {
    std::ofstream(path_) << text.substr(0, text.size() - lost);
    const JournalContents read = read_journal(path_);
    EXPECT_EQ(read.entries.size(), 1U);
    EXPECT_THAT(read.trouble, HasSubstr("journal.jsonl:3: the last line is broken off"));
  }
}

TEST_F(JournalTest, AFaultElsewhereNamesItsLine) {
  write();
  std::string text = read_text(path_);
  text.insert(text.find('\n') + 1, "nonsense\n");
  std::ofstream(path_) << text;
  EXPECT_THAT(fault(), HasSubstr("journal.jsonl:2: no line of a journal"));
  std::ofstream(path_) << "{\"journal\": 99}\n";
  EXPECT_THAT(fault(), HasSubstr("is of format 99; this program reads 1"));
  std::ofstream(path_) << "";
  EXPECT_THAT(fault(), HasSubstr("is empty"));
}

TEST(Digest, IsFnv1a) {
  EXPECT_EQ(make_digest(""), "cbf29ce484222325");  // published test vectors of 64-bit FNV-1a
  EXPECT_EQ(make_digest("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(make_digest("foobar"), "85944171f73967e8");
}

TEST(Digest, AChangedFileIsNamedWithBothDigests) {
  const JournalHead was{"", "s.toml", "1111", {{"die.stl", "2222"}}, {}, 1, ""};
  JournalHead now = was;
  EXPECT_NO_THROW(check_digests(was, now));
  now.files[0].second = "3333";
  try {
    check_digests(was, now);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("die.stl: has changed"));
    EXPECT_THAT(error.what(), HasSubstr("3333"));
    EXPECT_THAT(error.what(), HasSubstr("2222"));
  }
  now = was;
  now.scene_digest = "4444";
  EXPECT_THROW(check_digests(was, now), InputError);
  now = was;
  now.files.clear();
  EXPECT_THROW(check_digests(was, now), InputError);
}

}  // namespace
}  // namespace hydroscope::test
