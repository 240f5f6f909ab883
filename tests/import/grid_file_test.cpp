// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/grid_file.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/import/test_files.h"

namespace hydroscope {
namespace {

using test::catch_input_error;
using test::Folder;
using testing::AllOf;
using testing::HasSubstr;

const std::string kHead = "hydroscope-grid 1\ncolumns 3\nrows 2\norigin -1 2.5\npitch 0.5 1\n";

TEST(GridFile, ReadsRowsFromTheLowestCorner) {
  const Folder folder;
  const std::string file = folder.write(
      "a.grid", "# a comment\n" + kHead + "heights # z\n1 2,3\n\t1.4; -5e-1\r\n +2\n# the end\n");
  const HeightField field = read_grid_file(file, 1.0);
  EXPECT_EQ(field.columns, 3);
  EXPECT_EQ(field.rows, 2);
  EXPECT_EQ(field.heights, (std::vector<double>{1, 2, 3, 1.4, -0.5, 2}));
  EXPECT_EQ(field.point(1, 1), Vec3(-0.5, 3.5, -0.5));
  EXPECT_EQ(read_grid_file(file, 10.0).point(1, 1), Vec3(-5, 35, -5));
}

TEST(GridFile, MissingPoints) {
  const Folder folder;
  const HeightField field = read_grid_file(folder.write("a.grid", kHead + "heights\n1 2 -\n1 2 3\n"), 1.0);
  EXPECT_FALSE(field.has_point(2, 0));
  EXPECT_TRUE(field.has_cell(0, 0));
  EXPECT_FALSE(field.has_cell(1, 0));
}

TEST(GridFile, SurvivesTheRoundTripToTheLastBit) {
  HeightField field;
  field.columns = 2;
  field.rows = 3;
  field.origin = Vec2(0.1, -1.0 / 3.0);
  field.pitch = Vec2(std::sqrt(2.0), 0.7);
  field.heights = {1e-9, 1.0 / 7.0, 0.3, 0.9, 1.1, std::nan("")};
  const Folder folder;
  const HeightField again = read_grid_file(folder.write("a.grid", format_grid_file(field)), 1.0);
  EXPECT_EQ(again.origin, field.origin);
  EXPECT_EQ(again.pitch, field.pitch);
  for (std::size_t i = 0; i < field.heights.size(); ++i) {
    EXPECT_TRUE(again.heights[i] == field.heights[i] || (i == 5 && std::isnan(again.heights[i])));
  }
}

TEST(GridFile, ErrorsNameFileAndLine) {
  const Folder folder;
  const auto fail = [&](const std::string& text) {
    const std::string file = folder.write("a.grid", text);
    return catch_input_error([&] { read_grid_file(file, 1.0); });
  };
  EXPECT_THAT(fail("P2 3 3 255\n"), AllOf(HasSubstr("a.grid: line 1"), HasSubstr("hydroscope-grid 1")));
  EXPECT_THAT(fail("hydroscope-grid 2\n"), HasSubstr("unknown version"));
  EXPECT_THAT(fail(kHead + "colour 3\n"), AllOf(HasSubstr("line 6"), HasSubstr("\"colour\", expected")));
  EXPECT_THAT(fail(kHead), HasSubstr("the file ends, expected"));
  EXPECT_THAT(fail("hydroscope-grid 1\ncolumns 3\nheights 1 2 3\n"), HasSubstr("must stand before heights"));
  EXPECT_THAT(fail("hydroscope-grid 1\ncolumns 1\n"), HasSubstr("whole numbers from 2"));
  EXPECT_THAT(fail("hydroscope-grid 1\ncolumns 2.5\n"), HasSubstr("whole numbers from 2"));
  EXPECT_THAT(fail("hydroscope-grid 1\npitch 1\n"), HasSubstr("a number is missing"));
  EXPECT_THAT(fail(kHead + "heights\n1 2 3 4 x 6\n"),
              AllOf(HasSubstr("line 7"), HasSubstr("\"x\" is not a number")));
  EXPECT_THAT(fail(kHead + "heights\n1 2 3 4 inf 6\n"), HasSubstr("is not a number"));
  EXPECT_THAT(fail(kHead + "heights\n1 2 3 4 5\n"), HasSubstr("ends after 5 of 6 heights"));
  EXPECT_THAT(fail(kHead + "heights\n1 2 3 4 5 6 7\n"), HasSubstr("\"7\" after the last height"));
  EXPECT_THAT(fail(kHead + "heights\n1 2 3 4 5 60\n"), AllOf(HasSubstr("a.grid"), HasSubstr("wall of 8")));
  EXPECT_THAT(fail(kHead + "heights\n- 2 3 4 - 6\n"), HasSubstr("no four neighbouring points"));
  EXPECT_THAT(fail("hydroscope-grid 1\ncolumns 2\nrows 2\norigin 0 0\npitch 0 1\nheights 1 1 1 1\n"),
              HasSubstr("pitch"));
  EXPECT_THAT(fail("hydroscope-grid 1\ncolumns 9999999\nrows 9999999\norigin 0 0\npitch 1 1\nheights 1\n"),
              HasSubstr("20 million"));
  EXPECT_THAT(catch_input_error([&] { read_grid_file(folder.path() + "/none.grid", 1.0); }),
              HasSubstr("no such file"));
}

}  // namespace
}  // namespace hydroscope
