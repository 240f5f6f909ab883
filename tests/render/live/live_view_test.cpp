// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/live/live_view.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "render/live/live_camera.h"
#include "solver/base/error.h"
#include "tests/render/live/live_scene.h"

namespace hydroscope {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string find_error(const std::function<void(LiveView&)>& change) {
  LiveView view;
  change(view);
  try {
    check_live_view(view);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(LiveViewCheck, DefaultsAreAllowed) { EXPECT_NO_THROW(check_live_view(LiveView{})); }

TEST(LiveViewCheck, NamesFieldValueAndWhatIsAllowed) {
  EXPECT_THAT(find_error([](LiveView& v) { v.view = "warp"; }),
              AllOf(HasSubstr("view"), HasSubstr("'warp'"), HasSubstr("contact-map"), HasSubstr("slip")));
  EXPECT_THAT(find_error([](LiveView& v) { v.theme = "blue"; }),
              AllOf(HasSubstr("theme"), HasSubstr("'blue'"), HasSubstr("light, dark")));
  EXPECT_THAT(find_error([](LiveView& v) { v.width = 63; }),
              AllOf(HasSubstr("width = 63"), HasSubstr("64"), HasSubstr("8192")));
  EXPECT_THAT(find_error([](LiveView& v) { v.zoom = 0.0; }), AllOf(HasSubstr("zoom = 0"), HasSubstr("0.01")));
  EXPECT_THAT(find_error([](LiveView& v) { v.tool_opacity = 1.5; }),
              AllOf(HasSubstr("tool_opacity = 1.5"), HasSubstr("between 0 and 1")));
  EXPECT_THAT(find_error([](LiveView& v) {
                v.range = Range{2.0, 1.0};
              }),
              AllOf(HasSubstr("range = 2, 1"), HasSubstr("lower one first")));
}

TEST(LiveViewCheck, EveryFieldIsChecked) {
  const double nan = std::nan("");
  const std::vector<std::pair<const char*, std::function<void(LiveView&)>>> wrong{
      {"height", [](LiveView& v) { v.height = 9000; }},
      {"smoothing", [](LiveView& v) { v.smoothing = 0; }},
      {"width * smoothing", [](LiveView& v) { v.width = 8192, v.smoothing = 4; }},
      {"azimuth", [=](LiveView& v) { v.azimuth = nan; }},
      {"elevation", [](LiveView& v) { v.elevation = 91; }},
      {"zoom", [=](LiveView& v) { v.zoom = nan; }},
      {"pan_x", [](LiveView& v) { v.pan_x = 1e3; }},
      {"pan_y", [=](LiveView& v) { v.pan_y = nan; }},
      {"focus", [=](LiveView& v) { v.focus = Vec3(0, nan, 0); }},
      {"clip_axis", [](LiveView& v) { v.clip_axis = 3; }},
      {"clip_share", [](LiveView& v) { v.clip_share = -0.1; }},
      {"tool_opacity", [=](LiveView& v) { v.tool_opacity = nan; }},
      {"glyph_density", [](LiveView& v) { v.glyph_density = 5; }},
      {"glyph_scale", [](LiveView& v) { v.glyph_scale = 0; }},
      {"text_scale", [](LiveView& v) { v.text_scale = 0; }},
      {"range",
       [=](LiveView& v) {
         v.range = Range{0.0, nan};
       }},
      {"marked", [](LiveView& v) { v.marked = {-1}; }},
      {"marked", [](LiveView& v) { v.marked.assign(10001, 0); }}};
  for (const auto& [field, change] : wrong) EXPECT_THAT(find_error(change), HasSubstr(field)) << field;
}

TEST(LiveCamera, ThePartKeepsItsSizeWhileItIsTurned) {
  Bounds box;
  box.include(Vec3(-20, -20, -40));
  box.include(Vec3(20, 20, 40));
  LiveView view;
  const double scale = calc_live_camera(view, box).scale;
  for (const double azimuth : {-70.0, 0.0, 200.0})
    for (const double elevation : {-90.0, 0.0, 60.0, 90.0}) {
      view.azimuth = azimuth;
      view.elevation = elevation;
      EXPECT_DOUBLE_EQ(calc_live_camera(view, box).scale, scale);
    }
  view.zoom = 4.0;
  EXPECT_DOUBLE_EQ(calc_live_camera(view, box).scale, 0.25 * scale);
}

TEST(LiveCamera, ZoomOneHoldsTheBoxInTheStandardViews) {
  for (const Vec3& half : {Vec3(20, 20, 40), Vec3(100, 5, 5), Vec3(5, 5, 300)}) {
    Bounds box;
    box.include(-half);
    box.include(half);
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0})
      for (const double elevation : {0.0, 25.0, 90.0, -90.0}) {
        LiveView view = make_front_view(640, 360);
        view.azimuth = azimuth;
        view.elevation = elevation;
        const Projection projection(view, calc_live_camera(view, box));
        for (int corner = 0; corner < 8; ++corner) {
          const Vec3 sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
          const Vec3 seen = projection.project(half.cwiseProduct(sign));
          EXPECT_TRUE(seen.x() > 0.0 && seen.x() < 640.0 && seen.y() > 0.0 && seen.y() < 360.0)
              << half.transpose() << " from " << azimuth << " " << elevation;
        }
      }
  }
}

TEST(LiveCamera, PanMovesThePictureByHeightsAndFocusLiesInTheMiddle) {
  Bounds box;
  box.include(Vec3(0, 0, 0));
  box.include(Vec3(10, 10, 10));
  LiveView view = make_front_view(320, 180);
  const Vec3 before = Projection(view, calc_live_camera(view, box)).project(box.centre());
  view.pan_x = 0.25;
  view.pan_y = 0.5;
  const Vec3 after = Projection(view, calc_live_camera(view, box)).project(box.centre());
  EXPECT_NEAR(after.x() - before.x(), -0.25 * 180, 1e-9);
  EXPECT_NEAR(after.y() - before.y(), 0.5 * 180, 1e-9);
  LiveView close = make_front_view(320, 180);
  close.has_text = true;
  close.zoom = 7.0;
  close.focus = Vec3(1, 2, 3);
  const Vec3 seen = Projection(close, calc_live_camera(close, box)).project(*close.focus);
  EXPECT_NEAR(seen.x(), 160.0, 1e-9);
  EXPECT_NEAR(seen.y(), 90.0, 1e-9);
}

TEST(LiveCamera, StraightFromAboveUpIsWhatWasBehind) {
  Bounds box;
  box.include(Vec3(-1, -1, -1));
  box.include(Vec3(1, 1, 1));
  LiveView view = make_front_view();
  view.elevation = 89.0;
  const Projection nearly(view, calc_live_camera(view, box));
  view.elevation = 90.0;
  const Projection above(view, calc_live_camera(view, box));
  EXPECT_LT((nearly.right - above.right).norm(), 1e-9);
  EXPECT_LT((nearly.upright - above.upright).norm(), 0.02);
}

TEST(LiveCamera, TheToolsCutStaysWhileThePartIsTurnedALittle) {
  Bounds box;
  box.include(Vec3(-1, -1, -1));
  box.include(Vec3(1, 1, 1));
  LiveView view;
  const auto cut_from = [&](double azimuth, double elevation) {
    view.azimuth = azimuth;
    view.elevation = elevation;
    return calc_live_cut(calc_live_camera(view, box), box).normal;
  };
  EXPECT_EQ(cut_from(35, 25), Vec3::UnitX());
  EXPECT_EQ(cut_from(10, 40), Vec3::UnitX());
  EXPECT_EQ(cut_from(90, 10), Vec3::UnitZ());
  EXPECT_EQ(cut_from(180, 10), Vec3(-Vec3::UnitX()));
  EXPECT_EQ(cut_from(35, 89), Vec3::UnitY());
  EXPECT_EQ(cut_from(35, -89), Vec3(-Vec3::UnitY()));
}

TEST(LiveClip, SharesRunAlongTheBox) {
  Bounds box;
  box.include(Vec3(-2, 0, 10));
  box.include(Vec3(2, 1, 50));
  LiveView view;
  EXPECT_FALSE(calc_clip_plane(view, box).has_value());
  view.clip_axis = 2;
  view.clip_share = 0.25;
  EXPECT_DOUBLE_EQ(calc_clip_plane(view, box)->point.z(), 20.0);
  EXPECT_EQ(calc_clip_plane(view, box)->normal, Vec3::UnitZ());
  view.clip_flip = true;
  EXPECT_EQ(calc_clip_plane(view, box)->normal, Vec3(-Vec3::UnitZ()));
}

}  // namespace
}  // namespace hydroscope
