// SPDX-License-Identifier: GPL-3.0-or-later
// What the pixels show: read from flat pictures, whose colours come out exactly.
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <thread>

#include "render/camera.h"
#include "render/frame_painter.h"
#include "solver/base/error.h"
#include "tests/render/synthetic.h"

namespace hydroscope {
namespace {

using Histogram = std::map<Rgb, int>;

Histogram count_colours(const Image& image) {
  Histogram counts;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    ++counts[{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]}];
  return counts;
}

FrameOptions make_small(bool is_flat) {
  FrameOptions options;
  options.size = {320, 180};
  options.is_flat = is_flat;
  return options;
}

class Picture : public testing::Test {
 protected:
  Frame paint(const std::string& view, const FrameOptions& options) {
    return FramePainter(options).paint(view, *snapshot, {}, ranges);
  }

  SyntheticBulge bulge;
  std::shared_ptr<Snapshot> snapshot = bulge.make_snapshot(bulge.make_model(), 0.7, 3);
  std::map<std::string, Range> ranges{{"slip", {0, 2}},           {"slip-increment", {0, 0.1}},
                                      {"thickness", {1, 1.5}},    {"gap", {0, 3}},
                                      {"detachment", {0, 1}},     {"release-margin", {-1, 1}},
                                      {"plastic-strain", {0, 1}}, {"contact-pressure", {0, 60}}};
};

TEST_F(Picture, ContactMapShowsEveryClassInItsColourAndNothingElse) {
  Histogram counts = count_colours(paint("contact-map", make_small(true)).image);
  for (int c = 0; c < kContactClasses; ++c) {
    const Rgb colour = class_colour(static_cast<ContactClass>(c));
    EXPECT_GT(counts[colour], 20) << class_name(static_cast<ContactClass>(c));
    counts.erase(colour);
  }
  EXPECT_EQ(counts.size(), 1u) << "the ground alone is left: no colour between two classes";
}

TEST_F(Picture, AClassThatNoNodeHasIsNotInThePicture) {
  for (ContactClass& c : snapshot->contact_state)
    if (c == ContactClass::kSlip) c = ContactClass::kFree;
  EXPECT_EQ(
      count_colours(paint("contact-map", make_small(true)).image).count(class_colour(ContactClass::kSlip)),
      0u);
}

TEST_F(Picture, OneNodeThatLetsGoIsSeen) {
  const Image before = paint("contact-map", make_small(true)).image;
  // In the middle of the flat that faces the camera (angle 0, z = 0 on the seam's corner).
  const std::size_t node = 5 * 21;
  ASSERT_EQ(snapshot->contact_state[node], ContactClass::kStick);
  snapshot->contact_state[node] = ContactClass::kDetachedNow;
  EXPECT_FALSE(paint("contact-map", make_small(true)).image == before);
}

TEST_F(Picture, NodesWithoutGapAreGreyNotOnTheMap) {
  FrameOptions options = make_small(true);
  EXPECT_GT(count_colours(paint("gap", options).image)[kNoValueColour], 50);
  for (double& gap : snapshot->gap) gap = std::nan("");
  const Histogram counts = count_colours(paint("gap", options).image);
  EXPECT_EQ(counts.size(), 2u) << "ground and grey alone";
  EXPECT_EQ(counts.count(kNoValueColour), 1u);
}

TEST_F(Picture, NegativeInfinityIsNoSmallValue) {
  snapshot->contact_pressure.assign(snapshot->contact_pressure.size(),
                                    -std::numeric_limits<double>::infinity());
  EXPECT_EQ(count_colours(paint("contact-pressure", make_small(true)).image).size(), 2u);
}

TEST_F(Picture, AFieldOfOneValueHasTheMapsColour) {
  snapshot->thickness.assign(snapshot->thickness.size(), 1.25);
  ranges["thickness"] = {1.0, 1.5};
  Histogram counts = count_colours(paint("thickness", make_small(true)).image);
  ASSERT_EQ(counts.size(), 2u);
  const ColourTable& table = colour_table(MapName::kDusk);
  // The middle of the range may fall on either of the two middle entries.
  EXPECT_GT(counts[table[127]] + counts[table[128]], 1000);
}

TEST_F(Picture, MirroringShowsTheWholePart) {
  FrameOptions options = make_small(true);
  options.elevation = 0.0;
  options.azimuth = 90.0;  // along the tube: a square around its axis
  Bounds box;              // one camera for the whole and the piece
  box.include(Vec3(-45, -45, -60));
  box.include(Vec3(45, 45, 60));
  options.bounds = box;
  // The axis is seen as a point: camera pixels from the sidecar's rule, focal to the middle.
  const CameraPose camera = calc_camera(options, box, std::nullopt, 0, 1);
  const double pixel = 2.0 * camera.scale / options.size[1];
  const double axis_x = 0.5 * options.size[0] - camera.focal.x() / pixel;
  const double axis_y = 0.5 * options.size[1] + camera.focal.y() / pixel;
  const auto covered_sides = [&](const Image& image) {
    std::array<int, 4> sides{};  // left, right, upper, lower
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        const std::uint8_t* p = image.pixel(x, y);
        if (Rgb{p[0], p[1], p[2]} == theme("light").background_bottom) continue;
        ++sides[x + 0.5 < axis_x ? 0 : 1];
        ++sides[y + 0.5 < axis_y ? 2 : 3];
      }
    return sides;
  };
  const auto sides = covered_sides(paint("thickness", options).image);
  EXPECT_GT(sides[0], 500);
  // Rasterisation may give a border pixel to one side: a row of pixels at most.
  EXPECT_NEAR(sides[0], sides[1], 180);
  EXPECT_NEAR(sides[2], sides[3], 180);
  options.is_mirrored = false;
  const auto piece = covered_sides(paint("thickness", options).image);
  EXPECT_GT(piece[2], 100);
  EXPECT_LT(piece[3], 20);
  EXPECT_LT(std::min(piece[0], piece[1]), 20);
}

TEST_F(Picture, RepeatsBitForBitAlsoOnAnotherThread) {
  const FrameOptions options = make_small(false);
  for (const std::string& view : view_names()) {
    const Frame first = paint(view, options);
    EXPECT_EQ(paint(view, options).image, first.image) << view;
    Frame elsewhere;
    std::thread([&] { elsewhere = paint(view, options); }).join();
    EXPECT_EQ(elsewhere.image, first.image) << view;
    EXPECT_EQ(elsewhere.sidecar, first.sidecar) << view;
  }
}

TEST_F(Picture, DoesNotDependOnWhatWasDrawnBefore) {
  const FrameOptions options = make_small(false);
  FramePainter painter(options);
  const auto other = bulge.make_snapshot(snapshot->model, 0.9, 4);
  painter.paint("contact-map", *snapshot, {0, 2}, ranges);
  painter.paint("slip", *snapshot, {0, 2}, ranges);
  const Image after = painter.paint("contact-map", *other, {1, 2}, ranges).image;
  painter.paint("slip", *other, {1, 2}, ranges);
  // The camera belongs to the first snapshot, so the fresh painter gets it too.
  FramePainter fresh(options);
  fresh.paint("gap", *snapshot, {0, 2}, ranges);
  EXPECT_EQ(fresh.paint("contact-map", *other, {1, 2}, ranges).image, after);
}

TEST_F(Picture, SmoothEdgesHaveColoursInBetween) {
  FrameOptions rough = make_small(false), smooth = make_small(false);
  rough.smoothing = 1;
  smooth.smoothing = 2;
  EXPECT_GT(count_colours(paint("contact-map", smooth).image).size(),
            count_colours(paint("contact-map", rough).image).size());
}

TEST_F(Picture, ToolsAreSeenAndCanBeMovedAway) {
  const FrameOptions options = make_small(false);
  const Image with = paint("contact-map", options).image;
  snapshot->tool_translation[0] = Vec3(0, 500, 0);
  EXPECT_FALSE(paint("contact-map", options).image == with);
}

TEST_F(Picture, TheTimeLabelIsPartOfThePicture) {
  const FrameOptions options = make_small(false);
  const Image before = paint("contact-map", options).image;
  ++snapshot->increment;
  EXPECT_FALSE(paint("contact-map", options).image == before);
}

TEST_F(Picture, ThemesDiffer) {
  FrameOptions options = make_small(false);
  const Image light = paint("slip", options).image;
  options.theme = "dark";
  EXPECT_LT(paint("slip", options).image.pixel(160, 2)[0], 60);
  EXPECT_GT(light.pixel(160, 2)[0], 180);
}

}  // namespace
}  // namespace hydroscope
