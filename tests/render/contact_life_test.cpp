// SPDX-License-Identifier: GPL-3.0-or-later
// The views of how contact ends, against snapshots made by hand.
#include "render/contact_life.h"

#include <gmock/gmock.h>

#include <cmath>

#include "render/camera.h"
#include "render/views.h"
#include "solver/base/error.h"
#include "tests/render/synthetic.h"

namespace hydroscope {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Six nodes in a row of two elements: what each does is written in the test.
class ContactLifeOfSix : public testing::Test {
 protected:
  ContactLifeOfSix() {
    auto model = std::make_shared<SnapshotModel>();
    model->quads = {{0, 1, 4, 3}, {1, 2, 5, 4}};
    s.model = model;
    s.increment = 20;
    s.time = 2.0;
    s.pressure = 10.0;
    for (int i = 0; i < 6; ++i) {
      s.points.emplace_back(i % 3, i / 3, 0.0);
      s.directors.push_back(Vec3::UnitZ());
    }
    s.thickness.assign(6, 0.1);
    s.plastic_strain.assign(6, 0.0);
    s.contact_state.assign(6, ContactClass::kFree);
    s.contact_tool.assign(6, -1);
    s.gap.assign(6, 1.0);
    s.contact_pressure.assign(6, 0.0);
    for (auto* field : {&s.contact_force, &s.tool_normal, &s.slip, &s.slip_increment})
      field->assign(6, Vec3::Zero());
    s.let_go_time.assign(6, kNaN);
    s.toggles.assign(6, 0);
    s.release_reference.assign(6, 0.0);
    s.release_threshold.assign(6, 0.0);
  }

  /// Pressed by `force` [N] and rubbed, which must not count; 10 N is the reference and 0.1 N the threshold.
  void press(std::size_t node, double force) {
    s.contact_state[node] = ContactClass::kStick;
    s.contact_tool[node] = 0;
    s.tool_normal[node] = -Vec3::UnitZ();
    s.contact_force[node] = Vec3(3.0, -4.0, -force);
    s.release_reference[node] = 10.0;
    s.release_threshold[node] = 0.1;
  }

  DrawList draw(const std::string& view, double since = kNaN) {
    FrameOptions options;
    Views views(s, options);
    const CameraPose camera = calc_camera(options, views.bounds(), std::nullopt, 0, 1);
    return views.make_draw_list(view, s, camera, {{"detachment", {0, 1}}, {"release-margin", {-1, 1}}},
                                since);
  }

  Snapshot s;
};

TEST_F(ContactLifeOfSix, TellsTouchingFromLetGoAndFromNeverTouching) {
  press(0, 5.0);
  s.let_go_time[1] = 1.25;
  s.let_go_time[2] = 1.9;
  s.contact_state[3] = ContactClass::kDetachedNow;
  s.let_go_time[3] = 2.0;
  const ContactLife alone = calc_contact_life(s);
  EXPECT_THAT(alone.classes,
              ElementsAre(LifeClass::kTouching, LifeClass::kLetGo, LifeClass::kLetGo, LifeClass::kLetGoNow,
                          LifeClass::kNeverTouching, LifeClass::kNeverTouching));
  EXPECT_THAT(alone.counts, ElementsAre(2, 1, 2, 1));
  EXPECT_TRUE(std::isnan(alone.age[0]) && std::isnan(alone.age[5]));
  EXPECT_DOUBLE_EQ(alone.age[1], 0.75);
  EXPECT_DOUBLE_EQ(alone.age[3], 0.0);
  // Since the frame before, at 1.5 s, node 2 let go, too; node 1 was gone then.
  const ContactLife since = calc_contact_life(s, 1.5);
  EXPECT_EQ(since.classes[1], LifeClass::kLetGo);
  EXPECT_EQ(since.classes[2], LifeClass::kLetGoNow);
  EXPECT_EQ(calc_contact_life(s, 1.9).classes[2], LifeClass::kLetGo) << "the frame before showed it";
}

TEST_F(ContactLifeOfSix, MarginIsTheForceLeftUntilTheThreshold) {
  press(0, 5.0);
  press(1, 0.3);
  press(2, -0.1);
  press(3, -0.2);
  press(4, 1.0);
  s.release_reference[4] = 0.0;  // nothing to compare with
  const ContactLife life = calc_contact_life(s);
  EXPECT_NEAR(life.margin[0], 0.51, 1e-15);  // round-off of a product of unit vectors
  EXPECT_NEAR(life.margin[1], 0.04, 1e-15);
  EXPECT_NEAR(life.margin[2], 0.0, 1e-15);
  EXPECT_NEAR(life.margin[3], -0.01, 1e-15);
  EXPECT_TRUE(std::isnan(life.margin[4]) && std::isnan(life.margin[5]));
  EXPECT_THAT(life.nearest, ElementsAre(3, 2, 1));
  EXPECT_EQ(life.near_release, 3);
}

TEST_F(ContactLifeOfSix, TheNearestIsNamedAlsoWhenItIsFarFromRelease) {
  press(0, 5.0);
  press(1, 4.0);
  const ContactLife life = calc_contact_life(s);
  EXPECT_THAT(life.nearest, ElementsAre(1));
  EXPECT_EQ(life.near_release, 0);
  const DrawList list = draw("release-margin");
  EXPECT_THAT(list.legend.swatches.back().label, HasSubstr("nearest to release"));
  EXPECT_THAT(list.legend.notes.back(), HasSubstr("node 1, 41 % left"));
}

TEST_F(ContactLifeOfSix, TogglesAreCountedByClass) {
  s.toggles = {0, 1, 2, 4, 5, 9};
  const ContactLife life = calc_contact_life(s);
  EXPECT_THAT(life.toggle_counts, ElementsAre(1, 1, 1, 1, 1, 1));
  EXPECT_EQ(life.toggles, 21);
  EXPECT_EQ(find_toggle_class(3), 3);
  EXPECT_EQ(find_toggle_class(8), 4);
  const DrawList list = draw("chatter");
  ASSERT_EQ(list.legend.swatches.size(), 6U);
  for (const auto& swatch : list.legend.swatches) EXPECT_THAT(swatch.label, testing::EndsWith("  1"));
}

TEST_F(ContactLifeOfSix, OlderStatesSayThatTheyDoNotKnow) {
  press(0, 5.0);
  s.contact_state[3] = ContactClass::kDetachedNow;
  s.let_go_time.clear();
  s.toggles.clear();
  s.release_reference.clear();
  s.release_threshold.clear();
  const ContactLife life = calc_contact_life(s);
  EXPECT_FALSE(life.is_known);
  EXPECT_THAT(life.counts, ElementsAre(4, 1, 0, 1)) << "what the classes alone tell";
  EXPECT_TRUE(life.nearest.empty());
  for (const char* view : {"detachment", "chatter", "release-margin"})
    EXPECT_THAT(draw(view).legend.notes, testing::Contains(HasSubstr("older version"))) << view;
}

TEST_F(ContactLifeOfSix, NodesThatLetGoInThisFrameAreHighlighted) {
  s.let_go_time[0] = 1.5;
  s.let_go_time[1] = 1.9;
  const auto count = [&](double since) {
    const auto& colours = draw("detachment", since).surfaces[0].surface->colours;
    return std::count(colours.begin(), colours.end(), class_colour(ContactClass::kDetachedNow));
  };
  EXPECT_EQ(count(kNaN), 0);
  EXPECT_GT(count(1.6), 0);
  EXPECT_GT(count(1.4), count(1.6));
}

TEST_F(ContactLifeOfSix, MarkersStandOnTheFaceThatMeetsTheTool) {
  press(2, 0.2);
  const DrawList list = draw("release-margin");
  Vec3f least = Vec3f::Constant(1e9F), greatest = Vec3f::Constant(-1e9F);
  bool is_found = false;
  for (const SurfaceItem& item : list.surfaces) {
    if (item.table != nullptr || !item.surface->values.empty()) continue;
    is_found = true;
    for (const Vec3f& x : item.surface->points) {
      least = least.cwiseMin(x);
      greatest = greatest.cwiseMax(x);
    }
  }
  ASSERT_TRUE(is_found);
  EXPECT_NEAR((0.5F * (least + greatest) - Vec3f(2.0F, 0.0F, 0.05F)).norm(), 0.0F, 1e-5F);
}

TEST_F(ContactLifeOfSix, ACloseUpMarksNoNodesThatItLeavesOut) {
  press(0, 0.2);
  press(2, 0.2);
  const auto count_points = [&] { return draw("release-margin").surfaces.back().surface->points.size(); };
  const std::size_t both = count_points();
  auto cropped = std::make_shared<SnapshotModel>(*s.model);
  cropped->quads.pop_back();  // with it goes node 2
  s.model = cropped;
  EXPECT_EQ(count_points(), both / 2);
}

TEST_F(ContactLifeOfSix, RangesOfTheViews) {
  s.let_go_time[1] = 1.25;
  press(0, 5.0);
  press(2, -20.0);
  EXPECT_EQ(calc_range("detachment", s), (Range{0.0, 0.75}));
  EXPECT_EQ(calc_range("release-margin", s), (Range{-1.0, 1.0}))
      << "from one reference force on all are alike";
  s.contact_force[2] = Vec3(0, 0, 2.1);
  s.contact_force[0] = Vec3(0, 0, -1.0);
  const Range even = calc_range("release-margin", s);
  EXPECT_NEAR(even.high, 0.2, 1e-12);  // |-2.1 + 0.1| of 10
  EXPECT_EQ(even.low, -even.high);
}

TEST_F(ContactLifeOfSix, ArraysOfAWrongLengthAreRefused) {
  s.toggles.pop_back();
  EXPECT_THROW(draw("chatter"), ContractError);
}

}  // namespace
}  // namespace hydroscope
