// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/image_difference.h"

#include <gtest/gtest.h>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

/// A picture with a pattern in it.
Image make_pattern() {
  Image image = make_image(64, 48, {120, 130, 140});
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if ((x / 5 + y / 7) % 2 == 0) image.pixel(x, y)[0] = 40;
  return image;
}

TEST(PixelDifference, EqualPicturesDoNotDiffer) {
  const PixelDifference d = calc_pixel_difference(make_pattern(), make_pattern(), 3);
  EXPECT_EQ(d.compared, 64 * 48);
  EXPECT_EQ(d.off, 0);
  EXPECT_EQ(d.largest, 0);
  EXPECT_FALSE(d.has_block);
}

TEST(PixelDifference, LevelsAreOfEachChannel) {
  Image got = make_pattern();
  got.pixel(7, 8)[2] = static_cast<std::uint8_t>(got.pixel(7, 8)[2] + 3);
  EXPECT_EQ(calc_pixel_difference(make_pattern(), got, 3).off, 0);
  got.pixel(7, 8)[2] = static_cast<std::uint8_t>(got.pixel(7, 8)[2] + 1);
  const PixelDifference d = calc_pixel_difference(make_pattern(), got, 3);
  EXPECT_EQ(d.off, 1);
  EXPECT_EQ(d.largest, 4);
  EXPECT_EQ(d.x, 7);
  EXPECT_EQ(d.y, 8);
}

TEST(PixelDifference, FourPixelsInASquareAreABlockAndALineIsNot) {
  Image got = make_pattern();
  for (int x = 10; x < 14; ++x) got.pixel(x, 20)[1] = 0;
  EXPECT_FALSE(calc_pixel_difference(make_pattern(), got, 3).has_block);
  for (int x = 11; x < 13; ++x) got.pixel(x, 21)[1] = 0;
  const PixelDifference d = calc_pixel_difference(make_pattern(), got, 3);
  EXPECT_TRUE(d.has_block);
  EXPECT_EQ(d.x, 11);
  EXPECT_EQ(d.y, 20);
}

TEST(PixelDifference, TheFirstColumnIsNoNeighbourOfTheLast) {
  Image got = make_pattern();
  got.pixel(63, 9)[1] = got.pixel(63, 10)[1] = got.pixel(0, 10)[1] = got.pixel(0, 11)[1] = 0;
  EXPECT_FALSE(calc_pixel_difference(make_pattern(), got, 3).has_block);
}

TEST(PixelDifference, BoxesCanBeLeftOut) {
  Image got = make_pattern();
  for (int x = 10; x < 14; ++x) got.pixel(x, 20)[1] = got.pixel(x, 21)[1] = 0;
  const PixelDifference d = calc_pixel_difference(make_pattern(), got, 3, {{10, 20, 4, 2}});
  EXPECT_EQ(d.off, 0);
  EXPECT_EQ(d.compared, 64 * 48 - 8);
  // Boxes may reach over the picture's edge.
  EXPECT_EQ(calc_pixel_difference(make_pattern(), got, 3, {{60, 40, 40, 40}}).compared, 64 * 48 - 32);
}

TEST(StructureDifference, EqualPicturesAreAlike) {
  EXPECT_EQ(calc_structure_difference(make_pattern(), make_pattern()).worst, 1.0);
}

TEST(StructureDifference, ASlightlyOtherTintIsStillAlikeAndALostPatchIsNot) {
  Image tinted = make_pattern(), lost = make_pattern();
  for (std::uint8_t& byte : tinted.rgba) byte = static_cast<std::uint8_t>(std::min(255, byte + 3));
  EXPECT_GT(calc_structure_difference(make_pattern(), tinted).worst, 0.99);
  for (int y = 20; y < 25; ++y)
    for (int x = 20; x < 25; ++x) lost.pixel(x, y)[1] = 30;
  const StructureDifference d = calc_structure_difference(make_pattern(), lost);
  EXPECT_LT(d.worst, 0.1);
  EXPECT_NEAR(d.x, 20, kWindow);
  EXPECT_NEAR(d.y, 20, kWindow);
}

TEST(StructureDifference, HueCountsNotOnlyLightness) {
  // Two colours of one lightness: a grey picture would not show the change.
  const Image a = make_image(32, 32, {200, 100, 100});
  const Image b = make_image(32, 32, {100, 151, 100});
  EXPECT_LT(calc_structure_difference(a, b).worst, 0.9);
}

TEST(DifferencePicture, ShowsTheDifferenceAmplified) {
  const Image a = make_image(8, 8, {12, 12, 12});
  Image b = a;
  b.pixel(3, 3)[0] = 17;
  b.pixel(4, 4)[1] = 255;
  const Image picture = make_difference_picture(a, b);
  EXPECT_EQ(picture.pixel(0, 0)[0], 3);
  EXPECT_EQ(picture.pixel(3, 3)[0], 3 + 8 * 5);
  EXPECT_EQ(picture.pixel(4, 4)[1], 255);
}

TEST(BlankPicture, IsTheGroundAlone) {
  Image image = make_image(20, 20, {0, 0, 0});
  lay_on_ground(image, {250, 250, 250}, {10, 20, 30});
  for (int y = 0; y < 20; ++y)  // a ground that runs from top to bottom
    for (int x = 0; x < 20; ++x) image.pixel(x, y)[0] = static_cast<std::uint8_t>(10 * y);
  EXPECT_TRUE(is_blank(image));
  image.pixel(5, 5)[0] = 255;
  EXPECT_FALSE(is_blank(image));
  EXPECT_TRUE(is_blank(image, {{5, 5, 1, 1}})) << "lettering does not make a picture";
}

TEST(ImageDifference, NeedsOneSize) {
  EXPECT_THROW(calc_pixel_difference(make_pattern(), make_image(64, 47, {0, 0, 0}), 3), ContractError);
  EXPECT_THROW(calc_structure_difference(make_pattern(), make_image(63, 48, {0, 0, 0})), ContractError);
}

}  // namespace
}  // namespace hydroscope
