// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/nagata_surface.h"

#include <gtest/gtest.h>

#include "solver/base/error.h"
#include "solver/geometry/mesh_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::at;
using test::Dice;

FootPoint look_up(const ToolSurface& tool, const Vec3& x) {
  SearchHint hint;
  return tool.find_foot_point(x, 1e3, 1e3, hint).value();
}

TriangleMesh make_cylinder(int facets) {
  return make_grid_mesh(facets + 1, 5, [&](int i, int j) {
    const double a = 2 * std::numbers::pi * (i % facets) / facets;
    return Vec3(10 * std::cos(a), 10 * std::sin(a), 5.0 * (j - 2));
  });
}

/// Part of a bulging barrel: curved both ways, with rims.
TriangleMesh make_barrel(int columns, int rows) {
  return make_grid_mesh(columns + 1, rows + 1, [&](int i, int j) {
    const double a = 1.5 * i / columns;
    const double z = 8.0 * j / rows - 4.0;
    const double r = 10.0 - 0.02 * z * z;
    return Vec3(r * std::cos(a), r * std::sin(a), z);
  });
}

Vec3 place_on_torus(Dice& dice, double gap) {
  const double a = dice.number(0, 6.2), t = dice.number(0, 6.2), r = 10 + gap;
  return {(30 + r * std::cos(t)) * std::cos(a), (30 + r * std::cos(t)) * std::sin(a), r * std::sin(t)};
}

// V21: the table of mechanics 6.2, closed forms R (1 - cos(theta/2)) for facets and
// R (1 - cos(theta/2))^2 / (2 cos(theta/2)) for patches, and its printed digits.
TEST(NagataAccuracy, OnACircularArcIsThatOfTheTable) {
  const struct {
    int facets;
    double flat, nagata;  // x R
  } rows[] = {{8, 7.61e-2, 3.14e-3},  {12, 3.41e-2, 6.01e-4}, {16, 1.92e-2, 1.88e-4}, {24, 8.56e-3, 3.69e-5},
              {36, 3.81e-3, 7.27e-6}, {48, 2.14e-3, 2.30e-6}, {72, 9.52e-4, 4.53e-7}};
  for (const auto& row : rows) {
    const TriangleMesh mesh = make_cylinder(row.facets);
    const double theta = 2 * std::numbers::pi / row.facets;
    const NagataSurface nagata(mesh, {NormalRule::area, 60.0, SearchRule::tree});
    const MeshSurface flat(mesh, {NormalRule::area, 60.0});
    double worst_flat = 0.0, worst = 0.0;
    for (int i = 0; i <= 200; ++i) {
      const double a = theta * i / 200;
      const Vec3 x(10 * std::cos(a), 10 * std::sin(a), 0.3);
      worst_flat = std::max(worst_flat, std::abs(look_up(flat, x).gap));
      worst = std::max(worst, std::abs(look_up(nagata, x).gap));
    }
    const double c = std::cos(theta / 2);
    // The parabola and the arc differ most in the middle, where gap and radial error are one.
    EXPECT_NEAR(worst / 10, (1 - c) * (1 - c) / (2 * c), 1e-3 * worst / 10 + 1e-13);
    EXPECT_NEAR(worst / 10, row.nagata, 0.005 * row.nagata);  // the table has three digits
    // The gap of a flat facet is measured along the interpolated normal: in the middle, radial.
    EXPECT_NEAR(worst_flat / 10, 1 - c, 1e-3 * (1 - c));
    EXPECT_NEAR(worst_flat / 10, row.flat, 0.005 * row.flat);
  }
}

TEST(NagataPatch, EdgeMeetsTheNormalsOfItsEnds) {
  Dice dice(1);
  for (int i = 0; i < 100; ++i) {
    // Two points of a sphere and its normals there.
    const Vec3 n0 = dice.direction();
    const Vec3 n1 = (n0 + 0.5 * dice.direction()).normalized();
    const Vec3 chord = 7.0 * (n1 - n0);
    const Vec3 bend = calc_edge_bend(chord, n0, n1);
    EXPECT_NEAR(n0.dot(chord - bend), 0.0, 1e-12);
    EXPECT_NEAR(n1.dot(chord + bend), 0.0, 1e-12);
    EXPECT_LT((calc_edge_bend(-chord, n1, n0) - bend).norm(), 1e-12);  // whichever way it is run along
  }
}

TEST(NagataPatch, EdgeThatCannotMeetItsNormalsStaysRegular) {
  // Both normals lean the same way against the chord: the parabola would stand still at one end.
  const Vec3 bend = calc_edge_bend(Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0.04, 0, 1).normalized());
  EXPECT_LT(bend.norm(), 0.03);
  EXPECT_EQ(calc_edge_bend(Vec3(1, 0, 0.1), Vec3(0, 0, 1), Vec3(0, 0, 1)).norm(), 0.0);
}

TEST(NagataPatch, DerivativesAgreeWithDifferences) {
  NagataPatch patch{{Vec3(0, 0, 0), Vec3(2, 0.2, 0.1), Vec3(0.3, 1.7, -0.2)},
                    {Vec3(0.1, 0.05, -0.2), Vec3(-0.03, 0.1, 0.15), Vec3(0, -0.1, 0.3)}};
  const double step = 1e-5;
  const PatchPlace here(patch, 0.3, 0.25);
  const PatchPlace up1(patch, 0.3 + step, 0.25), down1(patch, 0.3 - step, 0.25);
  const PatchPlace up2(patch, 0.3, 0.25 + step), down2(patch, 0.3, 0.25 - step);
  EXPECT_LT(((up1.point - down1.point) / (2 * step) - here.a).norm(), 1e-9);
  EXPECT_LT(((up2.point - down2.point) / (2 * step) - here.b).norm(), 1e-9);
  EXPECT_LT(((up1.a - down1.a) / (2 * step) - here.aa).norm(), 1e-9);
  EXPECT_LT(((up1.b - down1.b) / (2 * step) - here.ab).norm(), 1e-9);
  EXPECT_LT(((up2.b - down2.b) / (2 * step) - here.bb).norm(), 1e-9);
  for (int k = 0; k < 3; ++k) {
    const auto l = place_on_edge(k, 0.3);
    EXPECT_LT((PatchPlace(patch, l[0], l[1]).point - PatchEdge(patch, k, 0.3).point).norm(), 1e-14);
    EXPECT_NEAR(read_edge_parameter(k, l[0], l[1]), 0.3, 1e-15);
  }
}

TEST(NagataSurface, FootIsTheNearestPointOfAllPatches) {
  const TriangleMesh mesh = test::make_icosphere(10, 1);
  const NagataSurface tool(mesh, {NormalRule::area, 60.0, SearchRule::tree});
  Dice dice(2);
  for (int i = 0; i < 60; ++i) {
    const Vec3 x = dice.number(7, 13) * dice.direction();
    const FootPoint foot = look_up(tool, x);
    double sampled = 1e9;
    for (int f = 0; f < static_cast<int>(mesh.triangles.size()); ++f) {
      for (int a = 0; a <= 40; ++a) {
        for (int b = 0; a + b <= 40; ++b) {
          sampled = std::min(sampled, (x - tool.place_on_patch(f, a / 40.0, b / 40.0).point).norm());
        }
      }
    }
    EXPECT_NEAR((x - foot.point).norm(), std::abs(foot.gap), 1e-9);
    EXPECT_LE(std::abs(foot.gap), sampled + 1e-12);
    EXPECT_GT(std::hypot(foot.gap, 0.15), sampled);  // samples 0.15 mm apart
    if (std::abs(x.norm() - 10) > 0.2) {
      EXPECT_EQ(foot.gap > 0.0, x.norm() > 10);
    }
  }
}

TEST(NagataSurface, TellsItselfFromBentAndFlatFacets) {
  const TriangleMesh mesh = test::make_torus(30, 10, 20, 12);
  const NagataSurface nagata(mesh);
  const MeshSurface bent(mesh, {.is_smooth = true});
  const MeshSurface flat(mesh);
  Dice dice(3);
  double to_bent = 0.0, to_flat = 0.0, normal = 0.0;
  double worst[3] = {};
  for (int i = 0; i < 500; ++i) {
    const Vec3 x = place_on_torus(dice, 0.0);
    const FootPoint foot = look_up(nagata, x);
    to_bent = std::max(to_bent, std::abs(foot.gap - look_up(bent, x).gap));
    to_flat = std::max(to_flat, std::abs(foot.gap - look_up(flat, x).gap));
    normal = std::max(normal, (foot.normal - look_up(bent, x).normal).norm());
    worst[0] = std::max(worst[0], std::abs(foot.gap));
    worst[1] = std::max(worst[1], std::abs(look_up(bent, x).gap));
    worst[2] = std::max(worst[2], std::abs(look_up(flat, x).gap));
  }
  EXPECT_GT(to_bent, 1e-3);
  EXPECT_GT(to_flat, 0.1);
  EXPECT_GT(normal, 1e-3);
  EXPECT_LT(worst[0], 0.2 * worst[2]);
  EXPECT_LT(worst[1], 0.2 * worst[2]);
}

class NagataGradients : public testing::TestWithParam<bool> {};

TEST_P(NagataGradients, AgreeWithDifferencesAndAreSymmetric) {
  TriangleMesh mesh = test::make_torus(30, 10, 48, 32);
  if (GetParam()) flip_mesh(mesh);
  const NagataSurface tool(mesh);
  Dice dice(4);
  const double step = 1e-5;
  int inside = 0;
  for (int i = 0; i < 1500; ++i) {
    const Vec3 x = place_on_torus(dice, i % 4 == 0 ? 0.0 : dice.number(-2, 2));
    const FootPoint here = look_up(tool, x);
    EXPECT_EQ(here.gap_gradient, here.normal);  // the gap is a distance
    EXPECT_LT((here.normal_gradient - here.normal_gradient.transpose()).norm(), 1e-12);
    EXPECT_LT((here.normal.transpose() * here.normal_gradient).norm(), 1e-9);
    bool is_inside = true;  // well within one patch: over its edges the curvature jumps
    for (int k = 0; k < 6; ++k) {
      const Vec3 y = x + (k < 3 ? 3e-3 : -3e-3) * Vec3::Unit(k % 3);
      is_inside = is_inside && look_up(tool, y).facet == here.facet;
    }
    if (!is_inside) continue;
    ++inside;
    const test::GradientError error = test::measure_gradients(tool, x, step);
    EXPECT_LT(error.normal, 1e-6);
    EXPECT_LT(error.gap, 1e-6);
  }
  EXPECT_GT(inside, 1400);
}

INSTANTIATE_TEST_SUITE_P(ConvexAndConcave, NagataGradients, testing::Bool());

TEST(NagataSurface, GradientsBeyondARimAgreeWithDifferences) {
  const NagataSurface tool(make_barrel(10, 6));
  Dice dice(5);
  int beyond = 0;
  for (int i = 0; i < 300; ++i) {
    const double a = dice.number(0.1, 1.4), r = dice.number(9, 11);
    const Vec3 x(r * std::cos(a), r * std::sin(a), dice.number(4.1, 5) * (i % 2 == 0 ? 1 : -1));
    const FootPoint here = look_up(tool, x);
    bool is_inside = here.beyond_edge > 1e-3;
    for (int k = 0; k < 6; ++k) {
      is_inside =
          is_inside && look_up(tool, x + (k < 3 ? 1e-3 : -1e-3) * Vec3::Unit(k % 3)).facet == here.facet;
    }
    if (!is_inside) continue;
    ++beyond;
    EXPECT_NEAR(here.beyond_edge, std::abs(x.z()) - 4, 0.2);
    const test::GradientError error = test::measure_gradients(tool, x, 1e-5);
    EXPECT_LT(error.gap, 1e-6);
    EXPECT_LT(error.normal, 1e-6);
  }
  EXPECT_GT(beyond, 150);
}

TEST(NagataSurface, GapIsContinuousAndNormalsNearlySo) {
  for (bool is_concave : {false, true}) {
    TriangleMesh mesh = test::make_torus(30, 10, 32, 20);
    if (is_concave) flip_mesh(mesh);
    const NagataSurface tool(mesh);
    Dice dice(6);
    double worst = 0.0;
    int crossings = 0;
    for (int i = 0; i < 20; ++i) {
      const Vec3 from = place_on_torus(dice, dice.number(-1, 1));
      const Vec3 step = 1e-3 * dice.direction();
      SearchHint hint;
      FootPoint last = *tool.find_foot_point(from, 1e3, 1e3, hint);
      for (int k = 1; k <= 5000; ++k) {
        const FootPoint here = *tool.find_foot_point(from + k * step, 1e3, 1e3, hint);
        if (std::abs(here.gap) > 3.0) break;
        ASSERT_LT(std::abs(here.gap - last.gap), 1e-3 + 1e-10);  // a distance: no steeper than one
        ASSERT_EQ(here.beyond_edge, 0.0);
        worst = std::max(worst, (here.normal - last.normal).norm());
        crossings += here.facet != last.facet ? 1 : 0;
        last = here;
      }
    }
    EXPECT_GT(crossings, 30);
    // Facets turn by 18 degrees = 0.31; patches by less than a thirtieth of it, sliding over their edges.
    EXPECT_LT(worst, 0.01);
  }
}

TEST(NagataSurface, RimContinuesTheSurface) {
  const NagataSurface tool(make_barrel(10, 6));
  for (double a : {0.31, 0.77, 1.2}) {
    SearchHint hint;
    const auto place = [&](double z) { return Vec3(10.2 * std::cos(a), 10.2 * std::sin(a), z); };
    FootPoint last = *tool.find_foot_point(place(3.5), 1e3, 1e3, hint);
    for (int i = 1; i <= 4000; ++i) {
      const FootPoint here = *tool.find_foot_point(place(3.5 + i * 2.5e-4), 1e3, 1e3, hint);
      ASSERT_LT(std::abs(here.gap - last.gap), 2.5e-4);
      ASSERT_LT((here.normal - last.normal).norm(), 5e-4);
      ASSERT_LT(std::abs(here.beyond_edge - last.beyond_edge), 3e-4);
      last = here;
    }
    EXPECT_NEAR(last.beyond_edge, 0.5, 0.1);
  }
}

TEST(NagataSurface, SphereHasItsCurvature) {
  for (bool is_concave : {false, true}) {
    TriangleMesh mesh = test::make_icosphere(10, 3);
    if (is_concave) flip_mesh(mesh);
    const NagataSurface tool(mesh, {NormalRule::max, 60.0, SearchRule::tree});
    const double sign = is_concave ? -1.0 : 1.0;
    Dice dice(7);
    for (int i = 0; i < 200; ++i) {
      const double r = dice.number(9, 11);
      const FootPoint foot = look_up(tool, r * dice.direction());
      EXPECT_NEAR(foot.gap, sign * (r - 10), 2e-4);  // R theta^4 / 128 with facets of 9 degrees
      EXPECT_NEAR(foot.normal_gradient.trace() * r, 2 * sign, 0.05);
    }
  }
}

TEST(NagataSurface, CubeKeepsItsCreases) {
  const NagataSurface tool(test::make_cube(1, 4));
  EXPECT_EQ(tool.crease_edges(), 48);
  Dice dice(8);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 x = dice.number(1.0, 2.4) * dice.direction();
    const Vec3 q = x.cwiseAbs() - Vec3::Ones();
    const FootPoint foot = look_up(tool, x);
    EXPECT_NEAR(foot.gap, q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0), 1e-9);
    EXPECT_EQ(foot.beyond_edge, 0.0);
  }
  for (const Vec3& x : {Vec3(1.2, 0.13, 1.3), Vec3(1.25, 1.3, 1.4), Vec3(-1.5, -1.2, 0.4)}) {
    const test::GradientError error = test::measure_gradients(tool, x, 1e-5);
    EXPECT_LT(error.gap, 1e-8);
    EXPECT_LT(error.normal, 1e-7);
  }
  TriangleMesh inside = test::make_cube(1, 4);
  flip_mesh(inside);
  EXPECT_NEAR(look_up(NagataSurface(inside), Vec3(1.1, 1.1, 0.3)).gap, -std::hypot(0.1, 0.1), 1e-9);
}

TEST(NagataSurface, CurvedCreaseIsClosedAndRound) {
  // A round punch with a flat bottom: 20 degree facets around, a crease of 90 degrees at its edge.
  TriangleMesh mesh;
  const int n = 18;
  for (int j : {0, 1}) {
    for (int i = 0; i < n; ++i) {
      const double a = 2 * std::numbers::pi * i / n;
      mesh.points.emplace_back(10 * std::cos(a), 10 * std::sin(a), 6.0 * j);
    }
  }
  mesh.points.emplace_back(0, 0, 6);
  for (int i = 0; i < n; ++i) {
    const int k = (i + 1) % n;
    mesh.triangles.insert(mesh.triangles.end(), {{i, k, n + k}, {i, n + k, n + i}, {n + i, n + k, 2 * n}});
  }
  // By angle: at the edge, one triangle meets two, and areas would turn the normals by 3 degrees.
  const NagataSurface tool(mesh, {NormalRule::angle, 40.0, SearchRule::tree});
  EXPECT_EQ(tool.crease_edges(), n);
  double worst = 0.0;
  for (int i = 0; i < 360; ++i) {
    const double a = i * std::numbers::pi / 180;
    // Out from the edge at 45 degrees: no hole there, and the circle instead of the polygon.
    for (double g : {0.0, 1e-3, 0.5}) {
      const Vec3 out(std::cos(a), std::sin(a), 1.0);
      const FootPoint foot = look_up(tool, Vec3(10 * std::cos(a), 10 * std::sin(a), 6) + g * out);
      worst = std::max(worst, std::abs(foot.gap - g * std::numbers::sqrt2));
    }
  }
  EXPECT_LT(worst, 0.002);  // facets: 10 (1 - cos 10) = 0.15 mm
}

TEST(NagataSurface, DoesNotDependOnHintAndSearch) {
  const TriangleMesh mesh = test::make_torus(30, 10, 32, 20);
  const NagataSurface tool(mesh), grid(mesh, {.search = SearchRule::grid}),
      all(mesh, {.search = SearchRule::all});
  Dice dice(9);
  SearchHint hint;
  Vec3 x(40.2, 0, 0);
  for (int i = 0; i < 3000; ++i) {
    x += (i % 300 == 0 ? 20.0 : 0.5) * dice.direction();
    const FootPoint surface = look_up(tool, x);
    if (std::abs(surface.gap) > 2.0) x -= surface.gap * surface.normal;
    SearchHint cold, of_grid, of_all;
    const auto wanted = tool.find_foot_point(x, 6, 6, cold);
    ASSERT_TRUE(wanted);
    for (const auto& foot : {tool.find_foot_point(x, 6, 6, hint), grid.find_foot_point(x, 6, 6, of_grid),
                             all.find_foot_point(x, 6, 6, of_all)}) {
      ASSERT_TRUE(foot);
      EXPECT_EQ(foot->facet, wanted->facet);
      EXPECT_EQ(foot->gap, wanted->gap);
      EXPECT_EQ(foot->normal, wanted->normal);
      EXPECT_EQ(foot->normal_gradient, wanted->normal_gradient);
    }
  }
}

TEST(NagataSurface, WindowKeepsOnlyWhatIsNear) {
  const NagataSurface tool(test::make_icosphere(10, 3));
  SearchHint hint;
  EXPECT_TRUE(tool.find_foot_point(Vec3(0, 0, 10.9), 1.0, 0.5, hint));
  EXPECT_FALSE(tool.find_foot_point(Vec3(0, 0, 11.1), 1.0, 0.5, hint));
  EXPECT_FALSE(tool.find_foot_point(Vec3(0, 0, 9.4), 1.0, 0.5, hint));
  EXPECT_FALSE(tool.find_foot_point(Vec3(0, 0, 14), 1.0, 0.5, hint));
  EXPECT_GT(hint.clearance, 3.8);
  EXPECT_TRUE(tool.find_foot_point(Vec3(0, 0, 10.9), 1.0, 0.5, hint));
  EXPECT_FALSE(tool.find_foot_point(Vec3::Constant(std::nan("")), 1.0, 1.0, hint));
}

TEST(NagataSurface, NeedsAveragedNormals) {
  EXPECT_THROW(NagataSurface(make_cylinder(12), {NormalRule::facet, 40.0, SearchRule::tree}), ContractError);
}

}  // namespace
}  // namespace hydroscope
