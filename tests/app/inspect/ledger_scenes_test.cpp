// SPDX-License-Identifier: GPL-3.0-or-later
// Shipped scenes, run into a folder and read by the ledger: who let go, when and why, against what
// mechanics says of each scene.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "app/inspect/ledger_filter.h"
#include "app/inspect/ledger_report.h"
#include "app/results/run_writer.h"
#include "scenes/generators/die_meshes.h"
#include "scenes/generators/stl_file.h"
#include "solver/scene/scene_reader.h"
#include "solver/scene/scene_source.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A run in a folder of its own, its ledger, and its states as the solver gave them.
struct Story {
  TemporaryFolder folder;
  RunSummary summary;
  std::vector<IncrementReport> rows;
  std::vector<std::shared_ptr<const Snapshot>> states;
  Ledger ledger;

  double time_before(int increment) const { return ledger.log.row(increment - 1).time; }
  LedgerSummary sum_up() const { return sum_up_ledger(ledger, select_episodes(ledger, {})); }
};

std::unique_ptr<Story> tell(const std::string& file, const std::vector<std::string>& assignments = {}) {
  auto story = std::make_unique<Story>();
  std::vector<SceneOverride> overrides;
  for (const std::string& assignment : assignments) overrides.push_back(make_override(assignment));
  const Scene scene = read_scene("scenes/" + file, overrides);
  Run run(scene, {1, nullptr});
  const ResultFolder results = make_result_folder(story->folder.path() / "run", false);
  RunWriter writer(results, {scene.file, read_text(scene.file), assignments, {}, 1, scene.end_time()},
                   run.snapshot_model(), run.quantity_names());
  RunObserver observer;
  observer.on_increment = [&](const IncrementReport& report) {
    writer.add_increment(report);
    story->rows.push_back(report);
  };
  observer.on_snapshot = [&](const std::shared_ptr<const Snapshot>& snapshot, bool for_state, bool) {
    if (!for_state) return;
    writer.add_state(*snapshot);
    story->states.push_back(snapshot);
  };
  story->summary = run.run(observer);
  writer.finish(story->summary, {});
  story->ledger = read_ledger(results);
  return story;
}

// V9: what a backed wall has taken up beyond the pressure of touching it gives back, and all of it lets go at
// that pressure, N / r = 16.963 MPa (tests/verification/circular_die_test.cpp derives it).
TEST(LedgerScenes, CircularDieLetsGoTogetherAsItIsUnloaded) {
  const auto story = tell("circular-die.toml");
  ASSERT_EQ(story->summary.outcome, Outcome::kCompleted) << story->summary.message;
  ASSERT_EQ(story->ledger.patches.size(), 1U);
  const Patch& patch = story->ledger.patches[0];
  EXPECT_EQ(patch.nodes, 92);
  EXPECT_EQ(patch.first_increment, patch.last_increment);
  EXPECT_THAT(patch.verdicts, ElementsAre(92, 0, 0));
  EXPECT_EQ(patch.back, 0);
  EXPECT_THAT(patch.drives, ElementsAre("unloading"));
  for (const std::string& cause : patch.causes) EXPECT_EQ(cause, "unloading");
  // It lets go at p_t within 0.5 %, somewhere in this increment.
  const ReleaseFigures& f = story->ledger.episodes[patch.episodes[0]].figures;
  EXPECT_GT(f.pressure_before, 0.995 * 16.963);
  EXPECT_LT(f.pressure, 1.005 * 16.963);
  // On the path 30 MPa -> 0 in 1 s that is a time, too.
  EXPECT_GT(patch.first_time, 2.0 - 1.005 * 16.963 / 30.0);
  // The wall springs back from a mid radius of 32.0 to 31.9455, at the last by that much off the die.
  EXPECT_NEAR(patch.gap_reached, 32.0 - 31.9455, 0.002);
}

/// N of the wall per mm of length: what the symmetry plane x = 0 bears. Without friction it is the same all
/// along the wall, but where a tool's edge or a bend takes up shear.
double calc_wall_force(const Snapshot& state, double width) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.points.size(); ++i)
    if (std::abs(state.points[i].x()) < 1e-9) sum += std::abs(state.support_force[i].x());
  return sum / width;
}

/// Where a wall without bending stiffness leaves the hollow corner of the hat-like die. Between corner and
/// slide it is an arc of radius rho = N / p that touches the corner's arc (centre A, radius R) from inside
/// and the slide's edge (centre B, radius r) from outside: |C - A| = R - rho, |C - B| = r + rho. Radii of the
/// mid-surface. Returns the angle of the point of leaving around A, from +x [deg].
double calc_leaving_angle(double rho, double advance, double thickness) {
  const double big = 20.0 - 0.5 * thickness, small = 6.0 + 0.5 * thickness;
  const Vec2 a(10.8, 10.8), b(30.85 + 6.0 - advance, 4.0);
  const double far = (b - a).norm(), from_a = big - rho, from_b = small + rho;
  const double cosine = (from_a * from_a + far * far - from_b * from_b) / (2.0 * from_a * far);
  return (std::atan2(b.y() - a.y(), b.x() - a.x()) + std::acos(std::clamp(cosine, -1.0, 1.0))) * 180.0 /
         std::numbers::pi;
}

/// Angle around the corner's centre [deg].
double calc_corner_angle(const Vec3& x) {
  return std::atan2(x.y() - 10.8, x.x() - 10.8) * 180.0 / std::numbers::pi;
}

const Patch* find_largest(const Ledger& ledger) {
  const Patch* largest = nullptr;
  for (const Patch& patch : ledger.patches)
    if (largest == nullptr || patch.nodes > largest->nodes) largest = &patch;
  return largest;
}

class HatDie : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { story_ = tell("hat-die.toml").release(); }
  static void TearDownTestSuite() { delete story_; }
  void SetUp() override {
    ASSERT_EQ(story_->summary.outcome, Outcome::kCompleted) << story_->summary.message;
    patch_ = find_largest(story_->ledger);
    ASSERT_NE(patch_, nullptr);
  }
  const Episode& episode(std::size_t i) const { return story_->ledger.episodes[i]; }
  const ContactEvent& release(std::size_t i) const { return story_->ledger.event(*episode(i).let_go); }
  /// Angle at which a wall without bending stiffness leaves, with the force and the wall of this state.
  static double calc_angle(const Snapshot& s) {
    const double rho = calc_wall_force(s, 2.0) / s.pressure;
    return calc_leaving_angle(rho, -s.tool_translation[1].x(), s.thickness[30]);
  }

  static Story* story_;
  const Patch* patch_ = nullptr;
};
Story* HatDie::story_ = nullptr;

TEST_F(HatDie, ThePatchIsTheHollowCornerAndPhysical) {
  EXPECT_EQ(patch_->tool, 0);
  EXPECT_EQ(patch_->verdict, Verdict::kPhysical);
  EXPECT_EQ(patch_->verdicts[1] + patch_->verdicts[2], 0);
  EXPECT_EQ(patch_->back, 0);
  EXPECT_THAT(patch_->drives, ElementsAre("tool moves"));
  EXPECT_EQ(patch_->nodes % 2, 0) << "both rows of the slice";
  for (const std::size_t i : patch_->episodes) {
    EXPECT_GT(calc_corner_angle(release(i).position), 0.0);
    EXPECT_LT(calc_corner_angle(release(i).position), 90.0);
    EXPECT_LT(release(i).force_after, 0.0) << "it was pulled when it let go";
    EXPECT_THAT(episode(i).reason, HasSubstr("meanwhile 'slide' moved by"));
    EXPECT_THAT(episode(i).reason, HasSubstr("the fluid held 48 MPa"));
  }
  // Filling rounds the corner off; nothing leaves it in earnest before the slide comes.
  for (const Patch& patch : story_->ledger.patches) {
    if (patch.first_time <= 1.0) {
      EXPECT_EQ(patch.verdict, Verdict::kNoise);
    }
  }
  const std::string number = std::to_string(1 + (patch_ - story_->ledger.patches.data()));
  EXPECT_THAT(make_ledger_text(story_->ledger, select_episodes(story_->ledger, {}), "run", 20),
              HasSubstr("--follow detachment --patch " + number + "\n"));
}

TEST_F(HatDie, ItPeelsFromTheSlideOn) {
  std::vector<std::pair<double, int>> front;
  for (const std::size_t i : patch_->episodes)
    front.emplace_back(calc_corner_angle(release(i).position), release(i).increment);
  std::sort(front.begin(), front.end());
  for (std::size_t k = 1; k < front.size(); ++k)
    EXPECT_GE(front[k].second, front[k - 1].second) << front[k].first << " deg";
}

// Tension draws the wall to the slide's edge. Without bending stiffness it would leave the corner at the
// angle of calc_leaving_angle(). A wall that bends follows the corner's arc until about lambda = sqrt(D / N)
// before that point, where its curvature begins to go over from 1 / R to 1 / rho. D is at most the elastic E'
// h^3 / 12, and not negative: with N = 540 N/mm and h = 1.37 mm lambda is up to 9.2 mm, 27 degrees of R
// = 19.3 mm. One element is 2.6 degrees.
TEST_F(HatDie, ItLeavesWhereTensionAndPressureSay) {
  int compared = 0;
  const double element = 2.6, lambda = 27.0;
  for (const std::size_t i : patch_->episodes) {
    const auto at = std::find_if(story_->states.begin(), story_->states.end(),
                                 [&](const auto& s) { return s->increment >= release(i).increment; });
    ASSERT_NE(at, story_->states.end());
    ASSERT_NE(at, story_->states.begin());
    if ((*at)->increment != release(i).increment || (*at)->tool_translation[1].x() > -2.0) continue;
    const double angle = calc_corner_angle(release(i).position);
    EXPECT_GT(angle, calc_angle(**std::prev(at)) - element) << (*at)->time << " s";
    EXPECT_LT(angle, calc_angle(**at) + element + lambda) << (*at)->time << " s";
    ++compared;
  }
  EXPECT_GE(compared, 10);
}

// As lambda hardly changes while N does not, front and tangent point go on alike: by as much within a
// quarter.
TEST_F(HatDie, ItPeelsAsFastAsTheTangentPointGoesOn) {
  double first_front = 0.0, first_point = 0.0, last_front = 0.0, last_point = 0.0;
  for (const auto& s : story_->states) {
    if (s->tool_translation[1].x() > -2.5) continue;
    double front = 90.0;  // lowest node of the row z = 0 that still touches the die's corner
    for (std::size_t i = 0; i < s->points.size() / 2; ++i)
      if (s->contact_tool[i] == 0) front = std::min(front, calc_corner_angle(s->points[i]));
    if (first_front == 0.0) {
      first_front = front;
      first_point = calc_angle(*s);
    }
    last_front = front;
    last_point = calc_angle(*s);
  }
  ASSERT_GT(last_point - first_point, 20.0);
  EXPECT_NEAR((last_front - first_front) / (last_point - first_point), 1.0, 0.25);
  RecordProperty("front_over_tangent_point",
                 std::to_string((last_front - first_front) / (last_point - first_point)));
}

// Once it has let go the strip bears nothing and stands still: the gap grows as fast as the punch goes back.
TEST(LedgerScenes, PunchWithdrawn) {
  const auto story = tell("punch-withdraw.toml");
  ASSERT_EQ(story->summary.outcome, Outcome::kCompleted) << story->summary.message;
  ASSERT_EQ(story->ledger.patches.size(), 1U);
  const Patch& patch = story->ledger.patches[0];
  EXPECT_THAT(patch.verdicts, ElementsAre(patch.nodes, 0, 0));
  EXPECT_EQ(patch.back, 0);
  EXPECT_THAT(patch.drives, ElementsAre("tool withdrawn"));
  EXPECT_TRUE(std::isinf(patch.gap_reached)) << "8 mm is out of reach";
  EXPECT_GT(patch.first_time, 1.0);
  // The last of them lets go where the punch's force is gone; before it presses.
  for (const IncrementReport& row : story->rows) {
    if (row.increment >= patch.last_increment) {
      EXPECT_EQ(row.quantities[0], 0.0);
    }
    if (row.time > 0.1 && row.increment < patch.first_increment) {
      EXPECT_GT(row.quantities[0], 0.0);
    }
  }
  for (const std::size_t i : patch.episodes) {
    const Episode& episode = story->ledger.episodes[i];
    EXPECT_THAT(episode.reason, HasSubstr("its tool went back by"));
    EXPECT_THAT(episode.reason, HasSubstr("no fluid"));
  }
  // At the middle, where its normal is the punch's way: 8 mm/s, but for the 1e-3 N that the corrector leaves.
  std::vector<std::pair<double, double>> gaps;
  for (const auto& s : story->states)
    if (s->increment > patch.last_increment && std::isfinite(s->gap[0]))
      gaps.emplace_back(s->time, s->gap[0]);
  ASSERT_GE(gaps.size(), 2U);
  const double speed = (gaps.back().second - gaps.front().second) / (gaps.back().first - gaps.front().first);
  EXPECT_NEAR(speed, 8.0, 0.08);
}

class CoarseDie : public ::testing::Test {
 protected:
  std::unique_ptr<Story> press(const std::string& release) {
    write_file(folder_ / "coarse_die.stl", make_binary_stl(make_square_die(kCoarseDie), "coarse die"));
    return tell("coarse-die.toml", {"contact.release=\"" + release + "\"",
                                    "tool.die.file=\"" + folder_ / "coarse_die.stl" + "\""});
  }
  TemporaryFolder folder_;
};

// The fluid only ever rises and no tool moves: nothing has a reason to let go, and what does is noise.
TEST_F(CoarseDie, DefaultRuleLetsNothingGoForGood) {
  const auto story = press("full");
  ASSERT_EQ(story->summary.outcome, Outcome::kCompleted) << story->summary.message;
  EXPECT_EQ(story->sum_up().verdicts[0], 0) << "physical";
  EXPECT_EQ(story->sum_up().verdicts[2], 0) << "chatter";
  EXPECT_GT(story->rows.back().n_contact, 0) << "or there would be nothing to let go";
}

TEST_F(CoarseDie, SignOfTheForceIsNoise) {
  const auto story = press("fluid");
  EXPECT_EQ(story->sum_up().verdicts[0], 0);
  EXPECT_GT(story->sum_up().verdicts[1], 0);
  for (const Patch& patch : story->ledger.patches) EXPECT_THAT(patch.causes, ElementsAre("sign rule"));
}

TEST_F(CoarseDie, ForgettingTheFluidChatters) {
  const auto story = press("sign");
  // Where such a run goes is chance, and a wall that hangs in the air may open: little of it is called
  // physical.
  EXPECT_LT(story->sum_up().verdicts[0], 0.1 * story->sum_up().detachments);
  EXPECT_GT(story->sum_up().verdicts[2], 10);
  EXPECT_GT(story->sum_up().back, story->sum_up().detachments / 2);
  // No threshold: the margin to release is the force itself.
  for (const auto& s : story->states)
    for (const double threshold : s->release_threshold) EXPECT_EQ(threshold, 0.0);
}

}  // namespace
}  // namespace hydroscope::test
