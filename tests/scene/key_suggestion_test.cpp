// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/key_suggestion.h"

#include <gtest/gtest.h>

namespace hydroscope {
namespace {

TEST(KeySuggestion, DistanceCountsEdits) {
  EXPECT_EQ(calc_edit_distance("friction", "friction"), 0);
  EXPECT_EQ(calc_edit_distance("Friction", "friction"), 0);
  EXPECT_EQ(calc_edit_distance("frction", "friction"), 1);
  EXPECT_EQ(calc_edit_distance("frcition", "friction"), 1);
  EXPECT_EQ(calc_edit_distance("", "abc"), 3);
}

TEST(KeySuggestion, StripsOurUnitsAndOthers) {
  EXPECT_EQ(strip_unit("thickness_mm"), "thickness");
  EXPECT_EQ(strip_unit("thickness_m"), "thickness");
  EXPECT_EQ(strip_unit("tension_N_per_mm"), "tension");
  EXPECT_EQ(strip_unit("pressure_mpa"), "pressure");
  EXPECT_EQ(strip_unit("friction"), "friction");
}

TEST(KeySuggestion, UnitAloneDiffers) {
  const std::vector<std::string> known = {"radius_mm", "pressure_MPa", "thickness_mm"};
  EXPECT_EQ(find_nearest_name("pressure_bar", known), "pressure_MPa");
  EXPECT_EQ(find_nearest_name("thickness", known), "thickness_mm");
  EXPECT_EQ(find_nearest_name("Radius_inch", known), "radius_mm");
}

TEST(KeySuggestion, SaysNothingWhenNothingIsNear) {
  EXPECT_EQ(find_nearest_name("colour", {"radius_mm", "pressure_MPa"}), "");
  EXPECT_EQ(find_nearest_name("x", {"of"}), "");
}

}  // namespace
}  // namespace hydroscope
