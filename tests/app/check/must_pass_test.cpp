// SPDX-License-Identifier: GPL-3.0-or-later
// What is no difference: a check that cries wolf is switched off.
#include <gmock/gmock.h>

#include <cstdlib>
#include <random>
#include <thread>

#include "app/check/frame_comparison.h"
#include "tests/app/check/sample_sequence.h"

namespace hydroscope::test {
namespace {

std::string list(const CheckReport& report) {
  std::string text;
  for (const Finding& finding : report.findings) text += describe(finding) + "\n";
  return text;
}

TEST(MustPass, TheStatesOfTheBaselineItself) {
  const CheckReport report = check_changed([](SnapshotModel&, std::vector<Snapshot>&) {});
  EXPECT_TRUE(report.is_passed()) << list(report);
  EXPECT_TRUE(report.is_same_renderer);
  EXPECT_EQ(report.frames, 3);
  EXPECT_EQ(report.sidecars_compared, 12);
  EXPECT_EQ(report.pictures_compared, 12);
  EXPECT_EQ(report.class_passes, 3);
  EXPECT_EQ(report.largest_difference, 0);
  EXPECT_THAT(report.renderer, testing::HasSubstr("llvmpipe"));
  EXPECT_TRUE(report.notes.empty());
}

TEST(MustPass, CoordinatesOffByABillionth) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> noise(-1e-9, 1e-9);
    const auto shake = [&](Vec3& x) {
      x = x.cwiseProduct(Vec3(1 + noise(random), 1 + noise(random), 1 + noise(random)));
    };
    const CheckReport report = check_changed([&](SnapshotModel& model, std::vector<Snapshot>& states) {
      for (Vec3& x : model.tools[0].mesh.points) shake(x);
      for (Snapshot& s : states)
        for (Vec3& x : s.points) shake(x);
    });
    EXPECT_TRUE(report.is_passed()) << list(report);
  }
}

TEST(MustPass, AnotherThread) {
  CheckReport report;
  std::thread([&] { report = check_changed([](SnapshotModel&, std::vector<Snapshot>&) {}); }).join();
  EXPECT_TRUE(report.is_passed()) << list(report);
  EXPECT_EQ(report.largest_difference, 0);
}

TEST(MustPass, NodesHiddenByOtherWallsAreNotedNotRejected) {
  ClassAgreement agreement;
  agreement.nodes = 1000;
  agreement.unseen = 5;
  EXPECT_TRUE(check_classes(agreement, 1).empty());
  agreement.unseen = 6;
  EXPECT_FALSE(check_classes(agreement, 1).empty());
}

}  // namespace
}  // namespace hydroscope::test
