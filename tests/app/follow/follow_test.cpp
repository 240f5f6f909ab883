// SPDX-License-Identifier: GPL-3.0-or-later
// Close-ups of what let go: which states, where the camera looks, what the charts say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/follow/chart_column.h"
#include "app/follow/close_up.h"
#include "app/follow/follow_detachment.h"
#include "app/results/json.h"
#include "render/image/png_file.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "tests/app/inspect/small_strip.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Nodes 2, 3 and 8 let go at increment 9, pulled by 1, 3 and 2 N; saved states at these increments.
std::string make_lines() {
  std::string lines;
  for (const int node : {2, 3, 8}) lines += make_event_line(1, "touch", node, "die,gap closed,0,0.5,0");
  lines += make_event_line(9, "detach", 2, "die,tension,-1,0,0.01") +
           make_event_line(9, "detach", 3, "die,tension,-3,0,0.02") +
           make_event_line(9, "detach", 8, "die,tension,-2,0,0.03");
  return lines;
}

std::vector<Snapshot> make_states(const std::vector<int>& increments) {
  std::vector<Snapshot> states;
  for (const int increment : increments) {
    states.push_back(make_strip_state(increment));
    Snapshot& s = states.back();
    // The arrays that a strip leaves out, and the die below it.
    for (auto* field : {&s.slip, &s.slip_increment}) field->assign(s.points.size(), Vec3::Zero());
    s.plastic_strain.assign(s.points.size(), 0.0);
    for (const std::size_t node : {2U, 3U, 8U}) {
      if (increment < 1 || increment >= 9) continue;
      s.contact_state[node] = ContactClass::kStick;
      s.contact_tool[node] = 0;
      s.tool_normal[node] = Vec3::UnitZ();
      s.contact_force[node] = (0.5 + 0.1 * increment) * Vec3::UnitZ();
      s.gap[node] = 0.0;
    }
  }
  return states;
}

Ledger make_story(const std::vector<int>& increments) {
  return make_small_ledger(make_lines(), make_states(increments));
}

std::vector<std::string> list_frames(const Ledger& ledger, int around) {
  std::vector<std::string> frames;
  for (const PatchFrame& frame : find_patch_frames(ledger, ledger.patches.at(0), around))
    frames.push_back(std::to_string(ledger.sheet.states[frame.state].increment) + " " +
                     to_string(frame.phase));
  return frames;
}

TEST(Follow, StatesBeforeAtAndAfter) {
  const Ledger ledger = make_story({0, 4, 6, 8, 9, 12, 14, 20});
  EXPECT_THAT(list_frames(ledger, 2), ElementsAre("6 before", "8 before", "9 at", "12 after", "14 after"));
  EXPECT_THAT(list_frames(ledger, 9), testing::SizeIs(8));
  // Without a state of that increment the next one shows it.
  EXPECT_THAT(list_frames(make_story({0, 8, 11, 12}), 1), ElementsAre("8 before", "11 at", "12 after"));
  // A run that ended there.
  EXPECT_THAT(list_frames(make_story({0, 8}), 3), ElementsAre("0 before", "8 before"));
}

TEST(Follow, AFrontIsShownUntilItsLastNode) {
  const std::string lines = make_lines() + make_event_line(9, "touch", 4, "die,gap closed,0,1,0") +
                            make_event_line(10, "detach", 4, "die,tension,-1,0,0.01");
  const Ledger ledger = make_small_ledger(lines, make_states({8, 9, 10, 11}));
  ASSERT_EQ(ledger.patches.size(), 1U);
  EXPECT_THAT(list_frames(ledger, 1), ElementsAre("8 before", "9 at", "10 at", "11 after"));
}

TEST(Follow, TheMostPulledNodeIsCharted) {
  const Ledger ledger = make_story({0, 8, 9});
  EXPECT_EQ(find_most_pulled(ledger, ledger.patches[0]), 3) << "all have the same share of the fluid";
  EXPECT_THAT(find_patch_nodes(ledger, ledger.patches[0]), ElementsAre(2, 3, 8));
  // Half of the force on half of the area is as much; node 5 has 1 mm^2 and a little more pull for it.
  const Ledger corner = make_small_ledger(make_event_line(1, "touch", 4, "die,gap closed,0,1,0") +
                                              make_event_line(1, "touch", 5, "die,gap closed,0,1,0") +
                                              make_event_line(9, "detach", 4, "die,tension,-3,0,0.01") +
                                              make_event_line(9, "detach", 5, "die,tension,-2,0,0.01"),
                                          make_states({0, 8, 9}));
  EXPECT_EQ(find_most_pulled(corner, corner.patches[0]), 5);
}

TEST(Follow, ANodesStoryComesFromStatesAndEvents) {
  const Ledger ledger = make_story({0, 4, 8, 12});
  const NodeStory story = make_node_story(ledger, 3);
  // States 0, 4, 8 (also the increment before the letting go), 12; touch at 0.1 s; let go at 0.9 s.
  ASSERT_EQ(story.forces.size(), 7U);
  EXPECT_THAT(story.force_times,
              testing::Pointwise(testing::DoubleNear(1e-9), {0.0, 0.1, 0.4, 0.8, 0.9, 0.9, 1.2}));
  EXPECT_DOUBLE_EQ(story.forces[1], 0.5);
  EXPECT_DOUBLE_EQ(story.forces[2], 0.9);
  EXPECT_DOUBLE_EQ(story.forces[3], -3.0) << "the event knows more than the state";
  EXPECT_EQ(story.forces[5], 0.0);
  EXPECT_DOUBLE_EQ(story.gaps[4], 0.02);
  const auto charts = make_patch_charts(ledger, {story});
  ASSERT_EQ(charts.size(), 4U);
  EXPECT_EQ(charts[0].series.at(0).y, story.forces);
  EXPECT_EQ(charts[1].series.at(0).y, story.gaps);
  EXPECT_EQ(charts[3].series.at(0).y.front(), 10.0);
  EXPECT_EQ(charts[3].series.at(0).y.back(), 9.0);
}

/// Where a point stands in the picture: -1 .. 1 both ways.
std::array<double, 2> project(const CameraPose& pose, const Vec3& x, double aspect) {
  const Vec3 direction = (pose.position - pose.focal).normalized();
  const Vec3 right = pose.up.cross(direction).normalized(), upright = direction.cross(right);
  return {right.dot(x - pose.focal) / (aspect * pose.scale), upright.dot(x - pose.focal) / pose.scale};
}

/// A quarter of a tube of radius 30 in a die, some nodes of which touch.
Snapshot make_quarter() {
  Snapshot s;
  auto model = std::make_shared<SnapshotModel>();
  for (int j = 0; j <= 20; ++j)
    for (int i = 0; i <= 30; ++i) {
      const double angle = 0.5 * 3.14159265358979 * i / 30;
      const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
      s.points.push_back(30.0 * out + 5.0 * j * Vec3::UnitZ());
      s.directors.push_back(out);
      s.tool_normal.push_back(-out);
      s.thickness.push_back(1.5);
      if (i == 30 || j == 20) continue;
      const int a = j * 31 + i;
      model->quads.push_back({a, a + 1, a + 32, a + 31});
    }
  s.model = model;
  return s;
}

TEST(Follow, TheCameraAimsAtThePatchAlongTheTube) {
  const Snapshot s = make_quarter();
  for (const std::vector<int>& nodes :
       {std::vector{10 * 31 + 15}, std::vector{3 * 31 + 4, 3 * 31 + 5, 4 * 31 + 4, 4 * 31 + 5},
        std::vector{0, 5, 10, 15, 20, 25, 30}}) {
    const PatchAxes axes = find_patch_axes(s, nodes, nodes.front(), Vec3(0.5, 0.4, 0.7).normalized());
    EXPECT_NEAR(axes.along.z(), 1.0, 1e-6) << "the tube's axis, towards the viewer";
    EXPECT_NEAR(axes.outward.dot(axes.along), 0.0, 1e-12);
    const double aspect = 768.0 / 720.0;
    const CloseUp close = aim_at_patch(s, nodes, nodes.front(), axes, aspect, 1.0);
    double widest = 0.0;
    for (const int node : nodes) {
      const auto place = project(close.pose, s.points[static_cast<std::size_t>(node)], aspect);
      EXPECT_LT(std::abs(place[0]), 0.9);
      EXPECT_LT(std::abs(place[1]), 0.9);
      widest = std::max(
          widest,
          std::abs(place[0] - project(close.pose, s.points[static_cast<std::size_t>(nodes[0])], aspect)[0]));
    }
    EXPECT_TRUE(nodes.size() < 7 || widest > 0.8) << "a close-up fills the picture";
    EXPECT_GT((close.pose.position - close.pose.focal).dot(axes.outward), 0.0) << "seen from the tool's side";
    // The cut goes through the patch and takes away the viewer's half.
    EXPECT_GT(close.cut.normal.dot(close.pose.position - close.cut.point), 0.0);
    EXPECT_LE(std::abs(close.cut.normal.dot(close.cut.point - s.points[static_cast<std::size_t>(nodes[0])])),
              5.0);
  }
}

TEST(Follow, ZoomComesCloserToTheNode) {
  const Snapshot s = make_quarter();
  const std::vector<int> nodes{0, 5, 10, 15, 20, 25, 30};
  const PatchAxes axes = find_patch_axes(s, nodes, 5, Vec3::UnitZ());
  const CloseUp whole = aim_at_patch(s, nodes, 5, axes, 1.0, 1.0),
                near = aim_at_patch(s, nodes, 5, axes, 1.0, 10.0);
  EXPECT_NEAR(near.pose.scale, 0.1 * whole.pose.scale, 1e-12);
  const auto place = project(near.pose, s.points[5] + 0.75 * s.directors[5], 1.0);
  EXPECT_LT(std::hypot(place[0], place[1]), 0.4);
}

TEST(Follow, AnInnerFaceIsSeenFromInside) {
  Snapshot s = make_quarter();
  for (Vec3& n : s.tool_normal) n = -n;                                   // the tool is inside
  for (const std::size_t node : {4U, 5U}) s.tool_normal[node].setZero();  // not yet there: as the third
  const PatchAxes axes = find_patch_axes(s, {4, 5, 6}, 5, Vec3::UnitZ());
  EXPECT_LT(axes.outward.dot(s.directors[5]), -0.99);
}

TEST(Follow, TheCropKeepsThePatchAndLeavesOutWhatIsFar) {
  const Snapshot s = make_quarter();
  const std::vector<int> nodes{10 * 31 + 15};
  const PatchAxes axes = find_patch_axes(s, nodes, nodes[0], Vec3::UnitZ());
  const CloseUp close = aim_at_patch(s, nodes, nodes[0], axes, 1.0, 1.0);
  const auto cropped = crop_to_patch(s, nodes, axes, close, 1.0);
  EXPECT_LT(cropped->quads.size(), s.model->quads.size() / 2);
  EXPECT_EQ(
      std::count_if(cropped->quads.begin(), cropped->quads.end(),
                    [&](const auto& quad) { return std::count(quad.begin(), quad.end(), nodes[0]) > 0; }),
      4);
}

class FollowedRun : public testing::Test {
 protected:
  FollowedRun() {
    write_small_run(folder.path(), make_lines(), make_states({0, 4, 8, 9, 12, 14}));
    options.frames.views = {"detachment"};
    options.frames.size = {480, 270};
    options.frames.smoothing = 1;
  }
  Json sidecar(int number) const {
    return Json::parse(
        read_whole_file(folder.path() / "frames/detachment-1" / ("0000" + std::to_string(number) + ".json")));
  }

  TemporaryFolder folder;
  FollowOptions options;
};

TEST_F(FollowedRun, FramesBeforeAtAndAfterWithTheirSidecars) {
  const Ledger ledger = read_ledger({folder.path()});
  const auto drawn = follow_detachment({folder.path()}, ledger, options);
  ASSERT_EQ(drawn.size(), 1U);
  ASSERT_EQ(drawn[0].frames, 6);
  std::vector<std::string> phases;
  for (int i = 1; i <= 6; ++i) phases.push_back(sidecar(i).at("patch").at("phase").text());
  EXPECT_THAT(phases, ElementsAre("before", "before", "before", "at", "after", "after"));
  const Json at = sidecar(4);
  EXPECT_EQ(at.at("increment").number(), 9);
  EXPECT_EQ(at.at("charted").items().at(0).at("node").number(), 3);
  EXPECT_EQ(sidecar(3).at("charted").items().at(0).at("normal_force_N").number(), 1.3);
  EXPECT_EQ(at.at("size_px").items().at(0).number(), 480);
  EXPECT_EQ(at.at("quads").number(), 5) << "of the whole sheet, not of what is shown of it";
  const Image image = read_png((folder.path() / "frames/detachment-1/00004.png").string()).image;
  EXPECT_EQ(image.width, 480);
  EXPECT_EQ(image.height, 270);
  // Drawn again, earlier frames are gone.
  options.around = 1;
  EXPECT_EQ(follow_detachment({folder.path()}, ledger, options)[0].frames, 3);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "frames/detachment-1/00004.png"));
}

TEST_F(FollowedRun, TheLineInTheChartsIsTheTimeOfTheFrame) {
  const Ledger ledger = read_ledger({folder.path()});
  const ChartColumn column(ledger, {make_node_story(ledger, 3)}, {.size = {400, 700}, .text_scale = 1.9});
  ASSERT_EQ(column.places().size(), 4U);
  for (const double now : {0.3, 1.7}) {
    const Image picture = column.draw({.now = now, .let_go = 0.9});
    for (const ChartPlace& place : column.places()) {
      EXPECT_EQ(place.x[0], 0.0);
      EXPECT_EQ(place.plot.left, column.places()[0].plot.left) << "one time, one column";
      EXPECT_EQ(place.plot.width, column.places()[0].plot.width);
      EXPECT_NEAR(place.x[1], 3.0, 1e-12);  // 30 increments of 0.1 s
      // Columns of the plot that have the line's colour from top to bottom.
      std::vector<int> columns;
      for (int x = place.plot.left; x < place.plot.left + place.plot.width; ++x) {
        bool is_line = true;
        for (int y = place.plot.top; y < place.plot.top + place.plot.height; ++y) {
          const std::uint8_t* p = picture.pixel(x, y);
          is_line = is_line && Rgb{p[0], p[1], p[2]} == kTimeLine;
        }
        if (is_line) columns.push_back(x);
      }
      ASSERT_FALSE(columns.empty()) << now;
      EXPECT_NEAR(columns.front(), place.plot.left + now / 3.0 * place.plot.width, 2.0) << now;
    }
  }
}

TEST_F(FollowedRun, WhatCannotBeFollowedIsSaid) {
  const Ledger ledger = read_ledger({folder.path()});
  const auto error = [&](const Ledger& given) -> std::string {
    try {
      choose_patches(given, options, "results/my");
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_THAT(error(make_small_ledger("", make_states({0}))), HasSubstr("results/my: nothing let go"));
  options.patches = {2};
  EXPECT_THAT(error(ledger), HasSubstr("--patch 2: the run has patches 1 to 1"));
  options.patches = {1};
  options.nodes = {12};
  EXPECT_THAT(error(ledger), HasSubstr("--node 12: the sheet has nodes 0 to 11"));
}

}  // namespace
}  // namespace hydroscope::test
