// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/views.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "render/camera.h"
#include "render/view_text.h"
#include "solver/base/error.h"
#include "tests/render/synthetic.h"

namespace hydroscope {
namespace {

class ViewsOfBulge : public testing::Test {
 protected:
  DrawList make(const std::string& view, const FrameOptions& options = {}) {
    Views views(*snapshot, options);
    const CameraPose camera = calc_camera(options, views.bounds(), std::nullopt, 0, 1);
    return views.make_draw_list(view, *snapshot, camera, ranges);
  }

  SyntheticBulge bulge;
  std::shared_ptr<Snapshot> snapshot = bulge.make_snapshot(bulge.make_model(), 0.7, 3);
  std::map<std::string, Range> ranges{{"slip", {0, 2}},           {"slip-increment", {0, 0.1}},
                                      {"thickness", {1, 1.5}},    {"gap", {0, 3}},
                                      {"detachment", {0, 1}},     {"release-margin", {-1, 1}},
                                      {"plastic-strain", {0, 1}}, {"contact-pressure", {0, 60}}};
};

TEST_F(ViewsOfBulge, TheLegendCountsTheSolversNodes) {
  const DrawList list = make("contact-map");
  const ClassCounts counts = count_classes(*snapshot);
  EXPECT_EQ(std::accumulate(counts.nodes.begin(), counts.nodes.end(), 0),
            static_cast<int>(snapshot->points.size()));
  for (int c = 0; c < kContactClasses; ++c) {
    const auto i = static_cast<std::size_t>(c);
    EXPECT_GT(counts.nodes[i], 0) << "the synthetic snapshot shows every class";
    EXPECT_THAT(list.legend.swatches[i].label, testing::EndsWith("  " + std::to_string(counts.nodes[i])));
  }
}

TEST_F(ViewsOfBulge, EveryViewHasAHeadingAndSomethingToShow) {
  for (const std::string& view : view_names()) {
    const DrawList list = make(view);
    EXPECT_FALSE(list.legend.heading.empty()) << view;
    ASSERT_FALSE(list.surfaces.empty()) << view;
    EXPECT_FALSE(list.surfaces[0].surface->polygons.empty()) << view;
  }
}

TEST_F(ViewsOfBulge, FacetNormalsComeOnRequest) {
  FrameOptions options;
  const std::size_t without = make("tool-normals", options).legend.swatches.size();
  options.facet_normals = true;
  EXPECT_EQ(make("tool-normals", options).legend.swatches.size(), without + 1);
}

TEST_F(ViewsOfBulge, NormalsStandOnPointsOfTheToolThatIsDrawn) {
  // A tool that reaches over a plane of symmetry is cut there, and loses points.
  auto model = std::make_shared<SnapshotModel>(*snapshot->model);
  for (Vec3& x : model->tools[0].mesh.points) x.z() -= 20.0;
  snapshot->model = model;
  FrameOptions options;
  options.is_tool_cut = false;
  const ToolShape shape(model->tools[0], model->mirrors);
  ASSERT_LT(shape.mesh().points.size(), model->tools[0].mesh.points.size());
  std::vector<Vec3f> places;
  for (const Reflection& reflection : shape.reflections())
    for (const Vec3& x : shape.mesh().points) places.push_back(reflection.point(x).cast<float>());
  const DrawList list = make("tool-normals", options);
  const std::vector<Vec3f>& points = list.surfaces[1].surface->points;
  constexpr std::size_t kPoints = 48;  // of an arrow; the first is its start
  ASSERT_GT(points.size(), 100 * kPoints);
  for (std::size_t i = 0; i < points.size(); i += kPoints)
    EXPECT_THAT(places, testing::Contains(
                            testing::Truly([&](const Vec3f& x) { return (x - points[i]).norm() < 1e-4F; })))
        << "arrow " << i / kPoints;
}

TEST_F(ViewsOfBulge, AToolThatHasLeftIsNotDrawn) {
  const std::size_t with = make("contact-map").surfaces.size();
  EXPECT_GT(with, 1u);
  snapshot->tool_translation[0].setConstant(std::nan(""));
  EXPECT_EQ(make("contact-map").surfaces.size(), 1u) << "the wall alone";
  EXPECT_TRUE(make("tool-normals").surfaces.empty());
}

TEST_F(ViewsOfBulge, NodesWithoutGapAreNamedInTheLegend) {
  const auto without =
      std::count_if(snapshot->gap.begin(), snapshot->gap.end(), [](double g) { return std::isnan(g); });
  ASSERT_GT(without, 0);
  const DrawList list = make("gap");
  ASSERT_EQ(list.legend.swatches.size(), 1u);
  EXPECT_EQ(list.legend.swatches[0].label, "no value  " + std::to_string(without));
  EXPECT_EQ(list.legend.swatches[0].colour, kNoValueColour);
}

TEST_F(ViewsOfBulge, AToolThatStandsStillIsNotMadeAgain) {
  Views views(*snapshot, {});
  const CameraPose camera = calc_camera({}, views.bounds(), std::nullopt, 0, 1);
  const auto first = views.make_draw_list("contact-map", *snapshot, camera, ranges);
  const auto second = views.make_draw_list("contact-map", *snapshot, camera, ranges);
  EXPECT_EQ(first.surfaces.back().surface, second.surfaces.back().surface);
  snapshot->tool_translation[0] = Vec3(0, 0, 1);
  const auto moved = views.make_draw_list("contact-map", *snapshot, camera, ranges);
  EXPECT_NE(first.surfaces.back().surface, moved.surfaces.back().surface);
}

TEST_F(ViewsOfBulge, AToolThatHasBeenTakenAwayIsNotDrawn) {
  const std::size_t with = make("contact-map").surfaces.size();
  snapshot->tool_translation[0] = Vec3::Constant(std::nan(""));
  EXPECT_EQ(make("contact-map").surfaces.size(), with - 2) << "seen from its front and from behind";
  EXPECT_TRUE(make("tool-normals").surfaces.empty());
}

TEST_F(ViewsOfBulge, SlipArrowsGrowWithTheSlip) {
  const DrawList before = make("slip");
  for (Vec3& slip : snapshot->slip) slip *= 1.1;
  const DrawList after = make("slip");
  const auto& a = before.surfaces[1].surface->values;
  const auto& b = after.surfaces[1].surface->values;
  ASSERT_EQ(a.size(), b.size());
  ASSERT_FALSE(a.empty());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_FLOAT_EQ(b[i], 1.1f * a[i]);
}

TEST_F(ViewsOfBulge, UnknownViewsAndMissingRangesAreRefused) {
  FrameOptions options;
  options.views = {"contact_map"};
  try {
    Views views(*snapshot, options);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("contact-map, tool-normals"));
  }
  ranges.erase("gap");
  EXPECT_THROW(make("gap"), ContractError);
}

TEST(Ranges, LeaveOutWhatIsNoNumber) {
  const SyntheticBulge bulge;
  const auto s = bulge.make_snapshot(bulge.make_model(), 0.5, 1);
  const Range gap = calc_range("gap", *s);
  EXPECT_GE(gap.low, 0.0);
  EXPECT_LT(gap.high, 3.0);
  s->gap.assign(s->gap.size(), std::nan(""));
  EXPECT_EQ(calc_round_range(calc_range("gap", *s)), (Range{0.0, 1.0}));
}

TEST(Ranges, AreRoundAndNeverEmpty) {
  EXPECT_EQ(calc_round_range({0.0, 0.0}), (Range{0.0, 1.0}));
  const Range rounded = calc_round_range({0.013, 2.37});
  EXPECT_DOUBLE_EQ(rounded.low, 0.0);
  EXPECT_DOUBLE_EQ(rounded.high, 2.5);
  const Range constant = calc_round_range({1.5, 1.5});
  EXPECT_LT(constant.low, 1.5);
  EXPECT_GT(constant.high, 1.5);
  EXPECT_EQ(calc_round_range({0.0, 2.0}), (Range{0.0, 2.0})) << "round already";
}

TEST(ViewText, TimeLabelTellsTimePressureAndIncrement) {
  Snapshot s;
  s.time = 1.25;
  s.pressure = 16.963;
  s.increment = 42;
  EXPECT_EQ(make_time_label(s), "t = 1.2500 s   p = 16.963 MPa   increment 42");
}

}  // namespace
}  // namespace hydroscope
