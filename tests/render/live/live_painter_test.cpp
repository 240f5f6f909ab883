// SPDX-License-Identifier: GPL-3.0-or-later
// What the pixels of live pictures show.
#include "render/live/live_painter.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <set>

#include "render/live/live_camera.h"
#include "render/live/pick.h"
#include "render/view_range.h"
#include "solver/base/error.h"
#include "tests/render/live/live_scene.h"
#include "tests/render/synthetic.h"

namespace hydroscope {
namespace {

constexpr Rgb kMark{255, 255, 255};

/// One painter for all: making a context takes longer than a picture.
struct Bulge {
  Bulge() : shape{.around = 10, .along = 12}, model(shape.make_model()) {
    first = shape.make_snapshot(model, 0.0, 0);
    early = make_known(0.5, 2);
    late = make_known(0.7, 3);
    painter = std::make_unique<LivePainter>(first);
  }
  /// With a story of what let go.
  std::shared_ptr<const Snapshot> make_known(double progress, int increment) const {
    auto s = shape.make_snapshot(model, progress, increment);
    for (std::size_t i = 0; i < s->points.size(); ++i) {
      const bool touches = s->contact_tool[i] >= 0;
      s->toggles.push_back(static_cast<int>(i % 5));
      s->let_go_time.push_back(touches || i % 3 != 0 ? std::nan("") : 0.1 * progress);
      s->release_reference.push_back(touches ? 400.0 : 0.0);
      s->release_threshold.push_back(touches ? 20.0 : 0.0);
    }
    return s;
  }
  SyntheticBulge shape;
  std::shared_ptr<const SnapshotModel> model;
  std::shared_ptr<const Snapshot> first, early, late;
  std::unique_ptr<LivePainter> painter;
};

class LivePicture : public testing::Test {
 protected:
  static Bulge& bulge() {
    static Bulge the_bulge;
    return the_bulge;
  }
  using Change = std::function<void(LiveView&)>;
  static LiveView make_view(const Change& change = {}) {
    LiveView view;
    view.width = 320;
    view.height = 180;
    view.has_text = false;
    if (change) change(view);
    return view;
  }
  static Image paint(const LiveView& view) { return bulge().painter->paint(view, bulge().late); }
  static Image paint(const Change& change) { return paint(make_view(change)); }

  /// The ground alone.
  static Image paint_ground(LiveView view) {
    view.pan_x = 90.0;
    view.marked.clear();
    return paint(view);
  }
  static int count_covered(const LiveView& view) { return count_changed(paint(view), paint_ground(view), 2); }
  static int count_covered(const Change& change) { return count_covered(make_view(change)); }
};

TEST_F(LivePicture, TheSameViewOfTheSameStateIsTheSamePicture) {
  for (const std::string& view_name : view_names()) {
    LiveView view = make_view([&](LiveView& v) { v.view = view_name; });
    const Image a = paint(view);
    const Image b = bulge().painter->paint(view, bulge().early);
    if (view_name != "tool-normals") {
      EXPECT_GT(count_changed(a, b), 30) << view_name;
    }
    EXPECT_EQ(paint(view), a) << view_name;
    EXPECT_EQ(bulge().painter->paint(view, *bulge().late), a) << view_name << ", as a copy";
  }
}

TEST_F(LivePicture, DoesNotDependOnWhatWasDrawnBefore) {
  LiveView wanted = make_view([](LiveView& v) {
    v.view = "slip", v.azimuth = 70, v.clip_axis = 2, v.marked = {40}, v.has_text = true;
  });
  LivePainter fresh(bulge().first);
  const Image alone = fresh.paint(wanted, bulge().late);
  EXPECT_EQ(count_changed(paint(wanted), alone, 0), 0) << "after other tests, or first of all";
  // More looks than are kept, other sizes, themes, arrows and cuts in between.
  for (int i = 0; i < 9; ++i)
    paint([&](LiveView& v) {
      v.width = 200 + 10 * i, v.azimuth = 45.0 * i, v.theme = i % 2 ? "dark" : "light";
      v.view = i % 3 ? "slip" : "tool-normals", v.glyph_density = 0.2 * i, v.clip_axis = i % 4 - 1;
      v.tool_opacity = 0.1 * i, v.smoothing = 1 + i % 2, v.is_mirrored = i % 2, v.marked = {i};
    });
  EXPECT_EQ(count_changed(paint(wanted), alone, 0), 0);
}

TEST_F(LivePicture, AnotherSideOfTheToolsIsCutAsThePartIsTurned) {
  // The look is the same, the cut is not: what was kept for one side must not serve the other.
  for (const double azimuth : {35.0, 125.0, 35.0, 215.0}) {
    const LiveView view = make_view([&](LiveView& v) { v.azimuth = azimuth, v.tool_opacity = 1.0; });
    LivePainter fresh(bulge().first);
    EXPECT_EQ(count_changed(paint(view), fresh.paint(view, bulge().late), 0), 0) << azimuth;
  }
}

TEST_F(LivePicture, AllViewsDifferAlsoInSmallPictures) {
  for (const int width : {64, 320}) {
    std::vector<Image> seen;
    for (const std::string& view_name : view_names()) {
      const Image image = paint([&](LiveView& v) {
        v.view = view_name, v.width = width, v.height = width, v.has_text = true, v.zoom = 1.2;
      });
      ASSERT_EQ(image.width, width);
      ASSERT_EQ(image.height, width);
      for (const Image& other : seen)
        EXPECT_GT(count_changed(image, other, 0), 0) << view_name << " " << width;
      seen.push_back(image);
    }
  }
}

TEST_F(LivePicture, ZoomEnlargesByItsSquare) {
  const double half = count_covered([](LiveView& v) { v.zoom = 0.4; });
  const double quarter = count_covered([](LiveView& v) { v.zoom = 0.2; });
  EXPECT_NEAR(half / quarter, 4.0, 0.3);
}

TEST_F(LivePicture, PanShiftsByPixels) {
  const Image before = paint([](LiveView& v) { v.zoom = 0.5; });
  const Image after = paint([](LiveView& v) { v.zoom = 0.5, v.pan_x = 40.0 / 180.0; });
  const Image ground = paint_ground(make_view());
  int wrong = 0, covered = 0;
  for (int y = 0; y < 180; ++y)
    for (int x = 20; x < 320; ++x)
      for (int c = 0; c < 3; ++c) {
        covered += before.pixel(x, y)[c] != ground.pixel(x, y)[c] ? 1 : 0;
        wrong += std::abs(before.pixel(x, y)[c] - after.pixel(x - 20, y)[c]) > 3 ? 1 : 0;
      }
  EXPECT_GT(covered, 3000);
  EXPECT_LT(wrong, covered / 50) << "the picture's middle moves to the right, the part to the left";
}

TEST_F(LivePicture, OrbitTurnsThePart) {
  // Along its axis the open tube is a thin ring.
  const Change along = [](LiveView& v) { v.azimuth = 90, v.elevation = 0, v.tool_opacity = 0; };
  const Change across = [](LiveView& v) { v.azimuth = 0, v.elevation = 0, v.tool_opacity = 0; };
  EXPECT_LT(2 * count_covered(along), count_covered(across));
}

TEST_F(LivePicture, ClipPlaneTakesOneSideAndFlipTheOther) {
  const auto count = [&](int axis, bool flip) {
    return count_covered([&](LiveView& v) {
      v.azimuth = 0, v.elevation = 0, v.clip_axis = axis, v.clip_flip = flip, v.element_edges = true;
      v.view = "slip";
    });
  };
  // Seen along x the plane across z halves the picture, tools and arrows included.
  const double whole = count(-1, false), below = count(2, false), above = count(2, true);
  EXPECT_NEAR(below / whole, 0.5, 0.03);
  EXPECT_NEAR(above / whole, 0.5, 0.03);
}

TEST_F(LivePicture, ClipPlaneShowsTheWallsArea) {
  // Seen along the axis, cut in the middle of the round tube: pi (Ro^2 - Ri^2) of the section's colour.
  LiveView view = make_view([](LiveView& v) {
    v.azimuth = 90, v.elevation = 0, v.clip_axis = 2, v.tool_opacity = 0, v.width = 640, v.height = 640;
  });
  const Image image = bulge().painter->paint(view, bulge().first);
  const CameraPose camera = calc_live_camera(view, calc_live_bounds(*bulge().first, true));
  const double pixel = 2.0 * camera.scale / 640.0;
  const double wall = M_PI * (30.75 * 30.75 - 29.25 * 29.25) / (pixel * pixel);
  // The borders are drawn over some of it.
  const int lit = count_colour(image, theme("light").section, 24);
  EXPECT_GT(lit, 0.5 * wall);
  EXPECT_LT(lit, 1.2 * wall);
  view.clip_axis = -1;
  EXPECT_LT(count_colour(bulge().painter->paint(view, bulge().first), theme("light").section, 24),
            0.1 * wall);
}

TEST_F(LivePicture, ToolsWithoutOpacityAreAsIfAbsent) {
  auto bare = std::make_shared<Snapshot>(*bulge().late);
  bare->tool_translation[0].setConstant(std::nan(""));
  for (const char* name : {"contact-map", "slip", "gap"}) {
    const LiveView view = make_view([&](LiveView& v) { v.tool_opacity = 0, v.clip_axis = 1, v.view = name; });
    EXPECT_EQ(paint(view), bulge().painter->paint(view, std::shared_ptr<const Snapshot>(bare))) << name;
  }
  const int without = count_covered([](LiveView& v) { v.tool_opacity = 0; });
  const int with = count_covered([](LiveView& v) { v.tool_opacity = 0.5; });
  const int whole = count_covered([](LiveView& v) { v.tool_opacity = 0.5, v.is_tool_cut = false; });
  EXPECT_GT(with, without + 200);
  EXPECT_GT(whole, with + 200);
}

TEST_F(LivePicture, MoreOpacityHidesMoreOfTheSheet) {
  const auto blue = [&](double opacity) {
    return count_colour(paint([&](LiveView& v) { v.tool_opacity = opacity, v.is_tool_cut = false; }),
                        class_colour(ContactClass::kSlip), 30);
  };
  EXPECT_GT(blue(0.0), 300);
  EXPECT_LT(blue(1.0), blue(0.0) / 2);
}

TEST_F(LivePicture, MirrorsMakeTheWholePart) {
  // From the front, from the middle of the whole part: the modelled eighth lies in one quarter.
  const auto count = [&](bool is_mirrored) {
    return count_covered([&](LiveView& v) {
      v.azimuth = 90, v.elevation = 0, v.is_mirrored = is_mirrored, v.focus = Vec3::Zero(), v.zoom = 0.5;
      v.tool_opacity = 0;
    });
  };
  EXPECT_GT(count(true), 300);
  const Image quarter = paint([](LiveView& v) {
    v.azimuth = 90, v.elevation = 0, v.is_mirrored = false, v.focus = Vec3::Zero(), v.zoom = 0.5;
    v.tool_opacity = 0;
  });
  const Image ground = paint_ground(make_view());
  int outside = 0, inside = 0;
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 320; ++x) {
      const bool is_covered = std::abs(quarter.pixel(x, y)[0] - ground.pixel(x, y)[0]) > 2;
      (x >= 158 && y <= 92 ? inside : outside) += is_covered ? 1 : 0;
    }
  EXPECT_GT(inside, 100);
  EXPECT_EQ(outside, 0);
}

TEST_F(LivePicture, EdgesAreLinesOnTheSheetAndOnTheTools) {
  const Change plain = [](LiveView& v) { v.view = "gap", v.zoom = 2; };
  const Change meshed = [](LiveView& v) { v.view = "gap", v.zoom = 2, v.element_edges = true; };
  const int changed = count_changed(paint(plain), paint(meshed), 4);
  EXPECT_GT(changed, 1000);
  EXPECT_LT(changed, count_covered(plain) / 2) << "lines, not areas";
  const Image bare = paint([](LiveView& v) { v.feature_edges = false; });
  EXPECT_GT(count_changed(paint(make_view()), bare), 40);
}

TEST_F(LivePicture, GlyphsFollowDensityAndScale) {
  const auto count = [&](const char* name, double density, double scale) {
    return count_colour(paint([&](LiveView& v) {
                          v.view = name, v.glyph_density = density, v.glyph_scale = scale, v.width = 640,
                          v.height = 360, v.tool_opacity = 0;
                        }),
                        class_colour(ContactClass::kStick), 60);
  };
  for (const char* name : {"slip", "tool-normals"}) {
    EXPECT_EQ(count(name, 0.0, 1.0), 0) << name;
    EXPECT_GT(count(name, 0.3, 2.0), 20) << name;
    EXPECT_GT(count(name, 1.0, 2.0), 1.3 * count(name, 0.3, 2.0)) << name;
    EXPECT_GT(count(name, 0.3, 3.0), 1.3 * count(name, 0.3, 1.5)) << name;
  }
}

TEST_F(LivePicture, RangeIsTheStatesOwnAndRoundOrAsLocked) {
  auto snapshot = std::make_shared<Snapshot>(*bulge().late);
  for (std::size_t i = 0; i < snapshot->plastic_strain.size(); ++i)
    snapshot->plastic_strain[i] = i == 7 ? 0.37 : 0.0;
  LiveView view = make_view([](LiveView& v) { v.view = "plastic-strain"; });
  bulge().painter->paint(view, *snapshot);
  EXPECT_EQ(bulge().painter->last_range(), (Range{0.0, 0.4}));
  view.range = Range{0.1, 0.2};
  bulge().painter->paint(view, *snapshot);
  EXPECT_EQ(bulge().painter->last_range(), (Range{0.1, 0.2}));
  paint([](LiveView& v) { v.view = "contact-map", v.range = Range{0, 1}; });
  EXPECT_FALSE(bulge().painter->last_range());
  // All values below the range: no colour of the map's upper half is left.
  const Rgb high = colour_table(MapName::kSea)[220];
  const Change own = [](LiveView& v) { v.view = "plastic-strain"; };
  const Change far = [](LiveView& v) { v.view = "plastic-strain", v.range = Range{10, 20}; };
  EXPECT_GT(count_colour(paint(own), high, 40), 30);
  EXPECT_EQ(count_colour(paint(far), high, 40), 0);
}

TEST_F(LivePicture, ThemeSmoothingAndText) {
  EXPECT_GT(paint(make_view()).pixel(2, 2)[0], 180);
  EXPECT_LT(paint([](LiveView& v) { v.theme = "dark"; }).pixel(2, 2)[0], 60);
  const auto count_kinds = [](const Image& image) {
    std::set<Rgb> kinds;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
      kinds.insert({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    return kinds.size();
  };
  EXPECT_GT(count_kinds(paint([](LiveView& v) { v.smoothing = 2; })), count_kinds(paint(make_view())));
  // Letters in the upper left corner, where there is ground alone without them.
  LiveView view = make_view([](LiveView& v) { v.width = 480, v.height = 270, v.has_text = true; });
  const auto count_dark = [&](const Image& image) {
    int dark = 0;
    for (int y = 0; y < 50; ++y)
      for (int x = 0; x < 200; ++x) dark += image.pixel(x, y)[0] < 90 ? 1 : 0;
    return dark;
  };
  const int usual = count_dark(paint(view));
  EXPECT_GT(usual, 300);
  view.text_scale = 0.6;
  EXPECT_LT(count_dark(paint(view)), 0.8 * usual);
  view.has_text = false;
  EXPECT_EQ(count_dark(paint(view)), 0);
}

/// Middles of the connected places that differ, of a ring's size at least.
std::vector<Vec2> find_spots(const Image& a, const Image& b, int least) {
  std::vector<char> open(static_cast<std::size_t>(a.width * a.height), 0);
  const auto at = [&](int x, int y) -> char& { return open[static_cast<std::size_t>(y * a.width + x)]; };
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      for (int c = 0; c < 3; ++c)
        if (std::abs(a.pixel(x, y)[c] - b.pixel(x, y)[c]) > 2) at(x, y) = 1;
  std::vector<Vec2> spots;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      if (at(x, y) == 0) continue;
      std::vector<std::array<int, 2>> spot{{x, y}};
      at(x, y) = 0;
      Vec2 sum = Vec2::Zero();
      for (std::size_t i = 0; i < spot.size(); ++i) {
        const auto [px, py] = spot[i];
        sum += Vec2(px + 0.5, py + 0.5);
        for (int v = std::max(py - 1, 0); v <= std::min(py + 1, a.height - 1); ++v)
          for (int u = std::max(px - 1, 0); u <= std::min(px + 1, a.width - 1); ++u)
            if (at(u, v) != 0) {
              at(u, v) = 0;
              spot.push_back({u, v});
            }
      }
      if (static_cast<int>(spot.size()) >= least) spots.push_back(sum / static_cast<double>(spot.size()));
    }
  return spots;
}

TEST_F(LivePicture, MarksStandWherePickFindsTheirNodes) {
  for (const char* colours : {"light", "dark"}) {
    const LiveView plain = make_view([&](LiveView& v) {
      v.width = 640, v.height = 360, v.zoom = 1.5, v.tool_opacity = 0, v.theme = colours;
    });
    const Image before = paint(plain);
    const std::vector<int> seen = pick_rectangle(plain, *bulge().first, *bulge().late, 60, 60, 580, 300);
    ASSERT_GT(seen.size(), 50u);
    int spots_found = 0;
    for (std::size_t i = 5; i < seen.size(); i += 17) {
      LiveView marked = plain;
      marked.marked = {seen[i]};
      const Image after = paint(marked);
      EXPECT_GT(count_colour(after, kMark, 30), count_colour(before, kMark, 30) + 30) << colours;
      // Whole rings only: where another wall hides half of one, its middle is not its node's.
      for (const Vec2& spot : find_spots(before, after, 220)) {
        // Where the wall is seen at a slant, a pixel is more than half an element.
        std::set<int> picked;
        for (const Vec2& off : {Vec2(0, 0), Vec2(1.5, 0), Vec2(-1.5, 0), Vec2(0, 1.5), Vec2(0, -1.5)})
          if (const auto pick =
                  pick_point(plain, *bulge().first, *bulge().late, spot.x() + off.x(), spot.y() + off.y()))
            picked.insert(pick->node);
        EXPECT_EQ(picked.count(seen[i]), 1u) << seen[i] << " at " << spot.transpose();
        spots_found += picked.size() == 1 ? 1 : 0;
      }
    }
    EXPECT_GT(spots_found, 8) << colours;
  }
}

TEST_F(LivePicture, AMarkBehindTheWallIsNotSeen) {
  const LiveView plain = make_view([](LiveView& v) {
    v.azimuth = 45, v.elevation = 30, v.is_mirrored = false, v.tool_opacity = 0, v.zoom = 0.8;
  });
  // The eighth seen from outside shows all its nodes, from inside too; its neighbour's wall hides none.
  LiveView whole = plain;
  whole.is_mirrored = true;
  whole.azimuth = 0.0;
  whole.elevation = 0.0;
  const std::vector<int> seen = pick_rectangle(whole, *bulge().first, *bulge().late, 0, 0, 320, 180);
  EXPECT_EQ(seen.size(), bulge().late->points.size()) << "each node has an image on the near side";
  LiveView marked = whole;
  marked.marked = {5 * 11 + 2};
  const Image before = paint(whole), after = paint(marked);
  // Eight images of the node: the four on the far side (x < 0) are hidden.
  EXPECT_EQ(find_spots(before, after, 20).size(), 4u);
}

TEST_F(LivePicture, MarksOfNodesThatAreNotThereAreRefused) {
  LiveView view = make_view([](LiveView& v) { v.marked = {143}; });
  EXPECT_THROW(paint(view), InputError);
  view.marked = {142};
  EXPECT_NO_THROW(paint(view));
  EXPECT_THROW(paint([](LiveView& v) { v.view = "warp"; }), InputError);
}

TEST_F(LivePicture, WhatIsDrawnIsWhatCanBePicked) {
  for (const int clip : {-1, 0, 2})
    for (const bool is_mirrored : {true, false}) {
      const LiveView view = make_view([&](LiveView& v) {
        v.tool_opacity = 0, v.clip_axis = clip, v.is_mirrored = is_mirrored, v.azimuth = 60, v.zoom = 1.3;
        v.has_text = false, v.theme = "dark";
      });
      const Image image = paint(view), ground = paint_ground(view);
      int wrong = 0, covered = 0;
      for (int y = 0; y < 180; y += 5)
        for (int x = 0; x < 320; x += 5) {
          bool is_drawn = false;
          for (int c = 0; c < 3; ++c) is_drawn = is_drawn || image.pixel(x, y)[c] != ground.pixel(x, y)[c];
          const bool is_picked =
              pick_point(view, *bulge().first, *bulge().late, x + 0.5, y + 0.5).has_value();
          covered += is_drawn ? 1 : 0;
          wrong += is_drawn != is_picked ? 1 : 0;
        }
      EXPECT_GT(covered, 150);
      // Lines along the rim are a pixel wider than the wall, and the cut's own area is no place on a face.
      EXPECT_LE(wrong, covered / 20) << clip << " " << is_mirrored;
    }
}

}  // namespace
}  // namespace hydroscope
