// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sample_run.h"

namespace hydroscope::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

TEST(Progress, Durations) {
  EXPECT_EQ(format_duration(7.4), "0:07");
  EXPECT_EQ(format_duration(65), "1:05");
  EXPECT_EQ(format_duration(3723), "1:02:03");
}

TEST(Progress, BarSaysWhereTheRunIs) {
  IncrementReport report = make_report(5);
  report.pressure = 14.321;
  const std::string bar = make_progress_bar(report, 1.0, 60.0, 130);
  EXPECT_THAT(bar, HasSubstr("]  50 %   14.32 MPa  inc 5     contact 3      touch"));
  EXPECT_THAT(bar, EndsWith("1:00 left"));
  EXPECT_EQ(bar.substr(0, 42), "[" + std::string(20, '#') + std::string(20, '.') + "]");
}

TEST(Progress, BarKeepsItsLength) {
  const size_t end = make_progress_bar(make_report(1), 1.0, 60.0, 100).find(']');
  EXPECT_EQ(make_progress_bar(make_report(9), 1.0, 60.0, 100).find(']'), end);
  EXPECT_EQ(make_progress_bar(make_report(9), 1.0, 20000.0, 100).find(']'), end);
}

TEST(Progress, BarFitsNarrowTerminals) {
  for (const int columns : {1, 10, 40, 60, 80, 300}) {
    EXPECT_LT(make_progress_bar(make_report(5), 1.0, 60.0, columns).size(),
              static_cast<size_t>(std::max(columns, 1)));
  }
}

TEST(Progress, NothingIsPromisedTooEarly) {
  IncrementReport report = make_report(5);
  report.time = 0.001;
  EXPECT_EQ(make_progress_line(report, 1.0, 60.0).find("left"), std::string::npos);
  EXPECT_EQ(make_progress_line(make_report(5), 1.0, 0.1).find("left"), std::string::npos);
}

}  // namespace
}  // namespace hydroscope::test
