// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/base/whole_file.h"

#include <gtest/gtest.h>

#include "solver/base/error.h"
#include "tests/app/file_size_limit.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

namespace fs = std::filesystem;

int count_files(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(WholeFile, ReplacesAtOnce) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  write_whole_file(file, "one");
  write_whole_file(file, std::string("two\0three", 9));
  EXPECT_EQ(read_whole_file(file), std::string("two\0three", 9));
  EXPECT_EQ(count_files(folder.path()), 1);
}

TEST(WholeFile, FullDiskLeavesTheOldFile) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.txt";
  write_whole_file(file, "old");
  {
    const FileSizeLimit limit(1000);
    EXPECT_THROW(write_whole_file(file, std::string(5000, 'x')), EnvironmentError);
  }
  EXPECT_EQ(read_whole_file(file), "old");
  EXPECT_EQ(count_files(folder.path()), 1) << "a temporary file was left";
}

TEST(WholeFile, MissingFolderIsNamed) {
  try {
    write_whole_file("/no/such/folder/a.txt", "x");
    ADD_FAILURE();
  } catch (const EnvironmentError& error) {
    EXPECT_STREQ(error.what(), "/no/such/folder/a.txt: cannot be written: No such file or directory");
  }
  EXPECT_THROW(read_whole_file("/no/such/file"), InputError);
  EXPECT_THROW(read_whole_file("/tmp"), InputError);
}

TEST(LineFile, EachLineIsThereAtOnce) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.csv";
  LineFile lines(file);
  lines.append("a,b\n");
  EXPECT_EQ(read_whole_file(file), "a,b\n");
  lines.append("1,2\n3,4\n");
  EXPECT_EQ(read_whole_file(file), "a,b\n1,2\n3,4\n");
}

TEST(LineFile, FullDiskLeavesWholeLines) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.csv";
  LineFile lines(file);
  lines.append("head\n");
  {
    const FileSizeLimit limit(20);
    EXPECT_THROW(lines.append(std::string(50, 'x') + "\n"), EnvironmentError);
  }
  EXPECT_EQ(read_whole_file(file), "head\n");
  lines.append("next\n");
  EXPECT_EQ(read_whole_file(file), "head\nnext\n");
}

}  // namespace
}  // namespace hydroscope::test
