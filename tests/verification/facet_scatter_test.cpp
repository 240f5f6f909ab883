// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/facet_scatter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace hydroscope::verification {
namespace {

constexpr double kPressure = 30.0, kMean = 30.0 - 16.9631;  // the tube of V9 hands on what is above its touch

void record(const std::string& name, const FacetScatter& s) {
  ::testing::Test::RecordProperty(name + "_" + std::to_string(std::lround(s.facet_angle)),
                                  "rms " + std::to_string(s.rms) + " bound " + std::to_string(s.bound));
}

/// Nodes and facets of one size, half a facet apart: every node has the same facet under it.
TEST(FacetScatter, NoneWhereEveryNodeMeetsTheSameFacet) {
  for (const int facets : {45, 23, 11}) {
    for (const char* surface : {"facets", "smooth", "nagata"}) {
      const FacetScatter s = measure_facet_scatter(surface, facets, facets, kPressure, false);
      EXPECT_EQ(s.message, "");
      EXPECT_EQ(s.free_nodes, 0);
      EXPECT_LT(s.rms, 0.01) << surface << " " << s.facet_angle;
      EXPECT_NEAR(s.mean, kMean, 0.01 * kMean) << surface << " " << s.facet_angle;
    }
  }
}

/// One element more than facets: nodes everywhere on their facets. On flat ones the radial error of up to
/// R theta^2/8 scatters the pressure, below E' (t/R) theta^2/8 (mechanics 6.3); bent ones err less by
/// theta^2/16.
TEST(FacetScatter, OfFlatFacetsIsBelowItsBoundAndOfBentOnesNothing) {
  for (const int facets : {45, 23, 11}) {
    const FacetScatter flat = measure_facet_scatter("facets", facets, facets + 1, kPressure, false);
    EXPECT_LT(flat.rms, flat.bound);
    EXPECT_GT(flat.rms, 0.2 * flat.bound);
    record("flat", flat);
    for (const char* surface : {"smooth", "nagata"}) {
      const FacetScatter bent = measure_facet_scatter(surface, facets, facets + 1, kPressure, false);
      EXPECT_LT(bent.rms, 0.01 * bent.bound) << surface;
      EXPECT_EQ(bent.free_nodes + bent.releases, 0) << surface;
      record(surface, bent);
    }
  }
}

/// Two elements a facet: one node in its middle, the next on its edge, radii +-a apart with 2 a the depth of
/// the facet. No fibre turns then, by symmetry; a wall of elements of length L takes +-a by shear alone,
/// 4 kappa G t / L^2 of pressure per mm, in series with its outer half's 2 E / t under the tool.
double calc_zigzag(double depth, double length, double t) {
  constexpr double kYoung = 206e3, kShear = kYoung / 2.6, kCorrection = 5.0 / 6.0;
  const double shear = 4.0 * kCorrection * kShear * t / (length * length), half_wall = 2.0 * kYoung / 1.5;
  return 0.5 * depth / (1.0 / shear + 1.0 / half_wall);
}

/// Flat facets are too deep for that: the node on the edge stays free and the other one carries it all.
TEST(FacetScatter, FinerWallsZigzagByShear) {
  constexpr double kRadius = 32.703915, kMid = 32.0, kWall = 1.408;
  for (const int facets : {45, 23, 11}) {
    const double theta = 0.5 * std::numbers::pi / facets, c = std::cos(0.5 * theta);
    const double depth = kRadius * (1.0 - c) * (1.0 - c) / (2.0 * c);  // of a Nagata patch, mechanics 6.2
    const double wanted = calc_zigzag(depth, kMid * 0.5 * theta, kWall);
    for (const char* surface : {"smooth", "nagata"}) {
      const FacetScatter s = measure_facet_scatter(surface, facets, 2 * facets, kPressure, false);
      EXPECT_NEAR(s.rms, wanted, 0.1 * wanted) << surface;
      EXPECT_EQ(s.free_nodes + s.releases, 0) << surface;
      record(surface + std::string("_fine"), s);
    }
    const FacetScatter flat = measure_facet_scatter("facets", facets, 2 * facets, kPressure, false);
    EXPECT_EQ(flat.free_nodes, facets);
    EXPECT_NEAR(flat.rms, flat.mean, 0.06 * flat.mean) << "all or nothing";
    record("flat_fine", flat);
  }
}

}  // namespace
}  // namespace hydroscope::verification
