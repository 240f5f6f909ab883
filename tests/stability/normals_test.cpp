// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/stability/gallery.h"

namespace hydroscope::stability {
namespace {

constexpr double kPulled = 0.2;  // [s]: from here on the tension at the start is constant

// Without friction the tension is the same on both sides; the chords of a strip that is not limp
// cost 0.6 to 0.9 %. A normal that is wrong by half a facet, 7.5 degrees, acts like friction of
// tan 7.5 = 0.13 on whoever is near an edge, one way or the other.
TEST(StabilityNormals, FacetNormalsActAsFriction) {
  const History naive =
      run_gallery("coarse-drum.toml", {"tool.drum.surface=facets", "tool.drum.normals=facet"});
  ASSERT_EQ(naive.summary.outcome, Outcome::kCompleted) << naive.summary.message;
  const Range swing = calc_range(naive, "force_ratio", kPulled);
  EXPECT_LT(swing.low, 0.95);
  EXPECT_GT(swing.high, 1.05);

  for (const char* surface : {"smooth", "facets", "nagata"}) {  // averaged normals on the same facets
    const History averaged = run_gallery("coarse-drum.toml", {"tool.drum.surface=" + std::string(surface)});
    ASSERT_EQ(averaged.summary.outcome, Outcome::kCompleted) << averaged.summary.message;
    const Range steady = calc_range(averaged, "force_ratio", kPulled);
    EXPECT_GT(steady.low, 1.003) << surface;
    EXPECT_LT(steady.high, 1.015) << surface;
    RecordProperty(std::string("ratio_") + surface,
                   std::to_string(steady.low) + " to " + std::to_string(steady.high));
  }
  RecordProperty("ratio_facet_normals", std::to_string(swing.low) + " to " + std::to_string(swing.high));
}

/// Distance of a point from the rounded box of sharp-corner.toml, positive outside [mm].
double calc_distance_from_die(const Vec3& x) {
  constexpr double kCentreX = 10.5, kCentreY = 15.1501, kFlat = 13.5, kFillet = 1.5;
  const double dx = std::abs(x[0] - kCentreX) - kFlat, dy = std::abs(x[1] - kCentreY) - kFlat;
  const double outside = std::hypot(std::max(dx, 0.0), std::max(dy, 0.0));
  return outside + std::min(std::max(dx, dy), 0.0) - kFillet;
}

/// How deep the strip's inner face cuts into the die between its nodes, over all states kept [mm].
double calc_cut(const History& history) {
  double deepest = 0.0;
  for (const auto& state : history.states) {
    const std::size_t nodes =
        state->points.size() / 2;  // of one edge of the strip, from its start to its end
    const auto face = [&](std::size_t i) -> Vec3 {
      return state->points[i] - 0.5 * state->thickness[i] * state->directors[i];
    };
    for (std::size_t i = 0; i + 1 < nodes; ++i) {
      for (int k = 0; k <= 20; ++k) {
        const double share = k / 20.0;
        const Vec3 x = (1.0 - share) * face(i) + share * face(i + 1);
        deepest = std::max(deepest, -calc_distance_from_die(x));
      }
    }
  }
  return deepest;
}

History run_sharp_corner(int lead_in, int arc, int lead_out) {
  return run_gallery("sharp-corner.toml", {"strip.elements_lead_in=" + std::to_string(lead_in),
                                           "strip.elements_arc=" + std::to_string(arc),
                                           "strip.elements_lead_out=" + std::to_string(lead_out)});
}

// The fillet is 2.4 mm long. Whatever the treatment, contact is between nodes and tool: elements of 3 mm
// cut the corner off, and the pull that is needed swings as one node after the other jumps around it.
// Five elements over the fillet see it.
TEST(StabilityNormals, ElementsLongerThanAFilletCutThroughIt) {
  const History coarse = run_sharp_corner(8, 1, 3), fine = run_sharp_corner(48, 6, 18);
  ASSERT_EQ(coarse.summary.outcome, Outcome::kCompleted) << coarse.summary.message;
  ASSERT_EQ(fine.summary.outcome, Outcome::kCompleted) << fine.summary.message;
  const Range swing = calc_range(coarse, "force_ratio", 0.3), steady = calc_range(fine, "force_ratio", 0.3);
  EXPECT_GT(calc_cut(coarse), 0.5);
  EXPECT_GT(swing.width(), 1.0);
  EXPECT_LT(calc_cut(fine), 0.03);
  EXPECT_LT(steady.width(), 0.12);
  RecordProperty("cut_coarse_fine", std::to_string(calc_cut(coarse)) + " " + std::to_string(calc_cut(fine)));
  RecordProperty("swing_coarse_fine", std::to_string(swing.width()) + " " + std::to_string(steady.width()));
}

}  // namespace
}  // namespace hydroscope::stability
