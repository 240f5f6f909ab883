// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

double luminance(Rgb c) {
  const auto linear = [](double v) { return std::pow(v / 255.0, 2.2); };
  return 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
}

TEST(ColourMap, LightnessIsMonotoneSoThatGreyPrintsAndColourBlindnessLeaveTheOrder) {
  for (const MapName name : {MapName::kSea, MapName::kDusk, MapName::kEmber}) {
    const ColourTable& table = colour_table(name);
    const double sign = name == MapName::kEmber ? -1.0 : 1.0;
    for (std::size_t i = 8; i < table.size(); i += 8)
      EXPECT_GT(sign * (luminance(table[i]) - luminance(table[i - 8])), 0.0) << i;
    EXPECT_GT(std::abs(luminance(table.back()) - luminance(table.front())), 0.4);
  }
}

TEST(ColourMap, TheMapOfTwoSidesIsPalestInItsMiddleAndEvenAtItsEnds) {
  const ColourTable& table = colour_table(MapName::kTide);
  for (std::size_t i = 8; i <= 120; i += 8) {
    EXPECT_GT(luminance(table[i]), luminance(table[i - 8])) << i;
    EXPECT_GT(luminance(table[255 - i]), luminance(table[255 - i + 8])) << i;
  }
  EXPECT_NEAR(luminance(table.front()), luminance(table.back()), 0.02);  // rounding to sRGB's colours
  EXPECT_GT(table.front()[0], table.front()[2]) << "red is below zero";
}

TEST(ColourMap, EndsContinueAndWhatIsNoNumberHasItsOwnColour) {
  const ColourTable& table = colour_table(MapName::kSea);
  EXPECT_EQ(map_colour(table, -5.0, 0.0, 1.0), table.front());
  EXPECT_EQ(map_colour(table, 5.0, 0.0, 1.0), table.back());
  EXPECT_EQ(map_colour(table, 0.5, 0.0, 1.0), table[128]);
  EXPECT_EQ(map_colour(table, std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0), kNoValueColour);
  for (const Rgb& c : table) EXPECT_NE(c, kNoValueColour);
}

TEST(ColourMap, ClassesDifferClearlyAlsoInLightness) {
  for (int a = 0; a < kContactClasses; ++a)
    for (int b = 0; b < a; ++b)
      EXPECT_GT(std::abs(luminance(class_colour(static_cast<ContactClass>(a))) -
                         luminance(class_colour(static_cast<ContactClass>(b)))),
                0.05)
          << a << " " << b;
}

TEST(ColourMap, UnknownThemeIsRefused) { EXPECT_THROW(theme("blue"), InputError); }

}  // namespace
}  // namespace hydroscope
