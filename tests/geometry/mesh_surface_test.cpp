// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/mesh_surface.h"

#include <gtest/gtest.h>

#include "solver/base/error.h"
#include "solver/geometry/analytic_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::at;
using test::Dice;

FootPoint look_up(const ToolSurface& tool, const Vec3& x) {
  SearchHint hint;
  return tool.find_foot_point(x, 1e3, 1e3, hint).value();
}

void expect_same(const FootPoint& a, const FootPoint& b) {
  EXPECT_EQ(a.facet, b.facet);
  EXPECT_EQ(a.gap, b.gap);
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.normal_gradient, b.normal_gradient);
  EXPECT_EQ(a.gap_gradient, b.gap_gradient);
}

/// Walks along a line in `steps` and returns the largest change of gap and normal beyond what the
/// gradients of both ends allow, over one step.
struct Jump {
  double gap = 0.0, normal = 0.0;
  int crossings = 0;
};
Jump march(const ToolSurface& tool, const Vec3& from, const Vec3& to, int steps) {
  SearchHint hint;
  FootPoint last = *tool.find_foot_point(from, 1e3, 1e3, hint);
  Jump jump;
  for (int i = 1; i <= steps; ++i) {
    const Vec3 x = from + (to - from) * i / steps;
    const FootPoint here = *tool.find_foot_point(x, 1e3, 1e3, hint);
    const double step = (to - from).norm() / steps;
    const double gap_rate = std::max(here.gap_gradient.norm(), last.gap_gradient.norm());
    const double turn_rate = std::max(here.normal_gradient.norm(), last.normal_gradient.norm());
    jump.gap = std::max(jump.gap, std::abs(here.gap - last.gap) - 1.01 * gap_rate * step);
    jump.normal = std::max(jump.normal, (here.normal - last.normal).norm() - 1.01 * turn_rate * step);
    jump.crossings += here.facet != last.facet ? 1 : 0;
    last = here;
  }
  return jump;
}

TEST(MeshSurface, GapAndNormalAreContinuousThroughConvexAndConcaveEdges) {
  for (bool is_concave : {false, true}) {
    TriangleMesh mesh = test::make_icosphere(10, 1);
    if (is_concave) flip_mesh(mesh);
    const MeshSurface tool(mesh, {NormalRule::area, 60.0});
    Dice dice(1);
    for (int i = 0; i < 20; ++i) {
      const Vec3 from = dice.number(8.5, 11.5) * dice.direction();
      const Vec3 to = from + 3.0 * dice.direction();
      const Jump jump = march(tool, from, to, 20000);
      EXPECT_LT(jump.gap, 1e-10);
      EXPECT_LT(jump.normal, 1e-10);
    }
    EXPECT_GT(march(tool, Vec3(0, 1, 10), Vec3(9, 1, 2), 1000).crossings, 2);
  }
}

TEST(MeshSurface, CrossesAnEdgeWithoutAJump) {
  // A point exactly on the ruled face between two prisms, and its two neighbours 1e-13 apart.
  const TriangleMesh mesh = test::make_icosphere(10, 1);
  const MeshSurface tool(mesh);
  const auto& normals = tool.display_normals();
  const TriangleMesh& shown = tool.display_mesh();
  const int a = shown.triangles[0][0];
  const int b = shown.triangles[0][1];
  for (double g : {-1.5, -1e-6, 0.0, 1e-6, 1.5}) {
    const Vec3 on =
        0.4 * (shown.points[at(a)] + g * normals[at(a)]) + 0.6 * (shown.points[at(b)] + g * normals[at(b)]);
    const Vec3 across = (shown.points[at(b)] - shown.points[at(a)]).cross(normals[at(a)]).normalized();
    const FootPoint left = look_up(tool, on - 1e-12 * across);
    const FootPoint right = look_up(tool, on + 1e-12 * across);
    EXPECT_NEAR(left.gap, right.gap, 1e-12);
    EXPECT_LT((left.normal - right.normal).norm(), 1e-11);
    EXPECT_LT((left.point - right.point).norm(), 1e-11);
  }
}

TEST(MeshSurface, FollowingANodeGivesTheSameBitsAsANewSearch) {
  for (bool is_concave : {false, true}) {
    TriangleMesh mesh = test::make_torus(30, 10, 48, 32);
    if (is_concave) flip_mesh(mesh);
    const MeshSurface tool(mesh);
    Dice dice(2);
    Vec3 x(40.2, 0, 0);
    SearchHint hint;
    for (int i = 0; i < 20000; ++i) {
      // Mostly short slides, now and then a leap to the other side.
      x += (i % 500 == 0 ? 20.0 : 0.5) * dice.direction();
      const FootPoint surface = look_up(tool, x);
      if (std::abs(surface.gap) > 2.0) x -= surface.gap * surface.normal;
      SearchHint none;
      const auto cold = tool.find_foot_point(x, 6, 6, none);
      const auto warm = tool.find_foot_point(x, 6, 6, hint);
      ASSERT_EQ(cold.has_value(), warm.has_value());
      if (cold) expect_same(*cold, *warm);
    }
  }
}

TEST(MeshSurface, AWrongHintDoesNoHarm) {
  const MeshSurface tool(test::make_icosphere(10, 2));
  Dice dice(4);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 x = dice.number(9, 11) * dice.direction();
    SearchHint hint;
    hint.facet = static_cast<int>(dice.number(-3, 400));  // even one that does not exist
    const auto found = tool.find_foot_point(x, 2, 2, hint);
    ASSERT_TRUE(found);
    expect_same(*found, look_up(tool, x));
  }
}

TEST(MeshSurface, TiesGoToTheLowestFacet) {
  const TriangleMesh mesh = test::make_icosphere(10, 1);
  const MeshSurface tool(mesh);
  const MeshTopology& topology = tool.topology();
  for (int p = 0; p < static_cast<int>(mesh.points.size()); ++p) {
    const int lowest = topology.ring[at(topology.ring_start[at(p)])];
    for (double g : {-0.5, 0.0, 0.5}) {
      EXPECT_EQ(look_up(tool, mesh.points[at(p)] * (1 + g / 10)).facet, lowest);
    }
  }
}

TEST(MeshSurface, DegeneratePositionsAreFound) {
  const TriangleMesh mesh = test::make_icosphere(10, 1);
  const MeshSurface tool(mesh, {NormalRule::area, 60.0});
  Dice dice(5);
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& corner = mesh.points[at(t[k])];
      const Vec3 middle = 0.5 * (corner + mesh.points[at(t[(k + 1) % 3])]);
      for (const Vec3& place : {corner, middle}) {
        for (double off : {0.0, 1e-15, 1e-12, -1e-12, 1e-9}) {
          const Vec3 x = place + off * dice.direction();
          const FootPoint foot = look_up(tool, x);
          EXPECT_LE(std::abs(foot.gap), 1.1 * std::abs(off) + 2e-14);  // facets lean against the normal
          EXPECT_LT((foot.point - place).norm(), 1e-8);
          EXPECT_EQ(foot.beyond_edge, 0.0);
          EXPECT_TRUE(foot.normal_gradient.allFinite());
          EXPECT_LT(foot.normal_gradient.norm(), 0.3);
        }
      }
    }
  }
}

TEST(MeshSurface, WindowKeepsOnlyWhatIsNear) {
  const MeshSurface tool(test::make_icosphere(10, 3));
  SearchHint hint;
  EXPECT_TRUE(tool.find_foot_point(Vec3(0, 0, 10.9), 1.0, 0.5, hint));
  EXPECT_FALSE(tool.find_foot_point(Vec3(0, 0, 11.1), 1.0, 0.5, hint));
  EXPECT_TRUE(tool.find_foot_point(Vec3(0, 0, 9.6), 1.0, 0.5, hint));
  EXPECT_FALSE(tool.find_foot_point(Vec3(0, 0, 9.4), 1.0, 0.5, hint));
}

TEST(MeshSurface, ClearanceIsTrueAndNeverHidesContact) {
  const MeshSurface tool(test::make_icosphere(10, 3));
  SearchHint hint;
  EXPECT_FALSE(tool.find_foot_point(Vec3(0, 0, 13), 1.0, 1.0, hint));
  EXPECT_GT(hint.clearance, 2.9);
  EXPECT_LE(hint.clearance, 3.001);
  const SearchHint far_hint = hint;
  EXPECT_FALSE(tool.find_foot_point(Vec3(0, 0, 12.5), 1.0, 1.0, hint));  // skipped
  EXPECT_EQ(hint.position, far_hint.position);
  EXPECT_TRUE(tool.find_foot_point(Vec3(0, 0, 10.9), 1.0, 1.0, hint));
  // Very far: only a lower bound of the distance is looked for.
  EXPECT_FALSE(tool.find_foot_point(Vec3(0, 0, 500), 1.0, 1.0, hint));
  EXPECT_LE(hint.clearance, 490.0);
  EXPECT_GE(hint.clearance, 4.0);
  EXPECT_TRUE(tool.find_foot_point(Vec3(0, 0, 10.9), 1.0, 1.0, hint));
}

TEST(MeshSurface, NotANumberFindsNothing) {
  const MeshSurface tool(test::make_icosphere(10, 1));
  SearchHint hint;
  EXPECT_FALSE(tool.find_foot_point(Vec3::Constant(std::nan("")), 1.0, 1.0, hint));
  EXPECT_TRUE(tool.find_foot_point(Vec3(0, 0, 10), 1.0, 1.0, hint));
}

TEST(MeshSurface, PointsBeyondAnOpenRimAreClampedToIt) {
  const TriangleMesh sheet = make_grid_mesh(5, 5, [](int i, int j) { return Vec3(i, j, 0); });
  const MeshSurface tool(sheet);
  EXPECT_EQ(look_up(tool, Vec3(3.9, 2, 0.1)).beyond_edge, 0.0);
  const FootPoint beside = look_up(tool, Vec3(4.5, 2.3, 0.2));
  EXPECT_NEAR(beside.beyond_edge, 0.5, 1e-12);
  EXPECT_NEAR(beside.gap, 0.2, 1e-12);
  EXPECT_LT((beside.point - Vec3(4, 2.3, 0)).norm(), 1e-12);
  const FootPoint corner = look_up(tool, Vec3(4.3, 4.4, -0.2));
  EXPECT_NEAR(corner.beyond_edge, 0.5, 1e-12);
  EXPECT_NEAR(corner.gap, -0.2, 1e-12);
}

TEST(MeshSurface, RimContinuesTheSurfaceWithoutAStep) {
  // A quarter of a cylinder: its rims are straight and curved, with normals that lean.
  const TriangleMesh part = make_grid_mesh(10, 6, [](int i, int j) {
    const double a = i * 0.17;
    return Vec3(10 * std::cos(a) * (1 - 0.03 * j), 10 * std::sin(a), 3.0 * j);
  });
  const MeshSurface tool(part);
  Dice dice(6);
  for (int i = 0; i < 30; ++i) {
    const double a = dice.number(0, 1.5);
    const Vec3 inside(dice.number(9, 11) * std::cos(a), dice.number(9, 11) * std::sin(a), 2.0);
    const Vec3 outside = inside - Vec3(0, 0, 4.0);
    const Jump jump = march(tool, inside, outside, 20000);
    EXPECT_LT(jump.gap, 1e-9);
    EXPECT_LT(jump.normal, 1e-9);
  }
  Vec3 x(10.3 * std::cos(0.4), 10.3 * std::sin(0.4), -0.7);
  EXPECT_GT(look_up(tool, x).beyond_edge, 0.3);
  const test::GradientError error = test::measure_gradients(tool, x, 1e-5);
  EXPECT_LT(error.gap, 1e-6);
  EXPECT_LT(error.normal, 1e-6);
}

TEST(MeshSurface, SeamsThatWereNotWeldedLoseNothing) {
  // Two halves of a cylinder that touch, but share no points, and with T-joints.
  TriangleMesh mesh;
  for (int half : {0, 1}) {
    const int rows = half == 0 ? 7 : 5;
    const TriangleMesh part = make_grid_mesh(13, rows, [&](int i, int j) {
      const double a = 0.1 * (i - 12 + 12 * half);
      return Vec3(10 * std::cos(a), 10 * std::sin(a), 12.0 * j / (rows - 1));
    });
    const int offset = static_cast<int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
    for (auto t : part.triangles) mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  const MeshSurface tool(mesh);
  Dice dice(7);
  for (int i = 0; i < 2000; ++i) {
    const double a = dice.number(-0.12, 0.12);
    const double r = dice.number(8, 12);
    const FootPoint foot = look_up(tool, Vec3(r * std::cos(a), r * std::sin(a), dice.number(1, 11)));
    EXPECT_NEAR(foot.gap, r - 10, 0.02 + 0.01 * std::abs(r - 10));
    EXPECT_LT(foot.beyond_edge, 0.21);  // the wedge that leaning normals leave open: 2 mm x sin 5.8 deg
  }
}

TEST(MeshSurface, WhatAPrismHoldsIsNotBeyondASeam) {
  // A bumpy sheet, cut along x = 0 and not welded: rim normals lean every way there.
  Dice dice(11);
  std::vector<double> bumps;
  for (int i = 0; i < 17 * 33; ++i) bumps.push_back(dice.number(-0.12, 0.12));
  TriangleMesh mesh;
  for (int half : {0, 1}) {
    const TriangleMesh part = make_grid_mesh(9, 33, [&](int i, int j) {
      const int column = i + 8 * half;
      return Vec3(column - 8, j, bumps[at(17 * j + column)]);
    });
    const int offset = static_cast<int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
    for (auto t : part.triangles) mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  const MeshSurface tool(mesh, {NormalRule::area, 60.0});
  int held = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 x(dice.number(-0.2, 0.2), dice.number(2, 30), dice.number(-1, 1));
    if (tool.list_prisms_at(x, 1.2 * std::abs(x.z()) + 0.2).empty()) continue;
    ++held;
    EXPECT_EQ(look_up(tool, x).beyond_edge, 0.0);
  }
  EXPECT_GT(held, 3000);
}

TEST(MeshSurface, ConvergesToTheAnalyticSurface) {
  const Vec3 x(10.5 * std::cos(0.733), 10.5 * std::sin(0.733), 0.37);
  const CylinderSurface exact(Pose{}, 10.0, Side::outside, 5.0);
  double last_gap = 0.0;
  for (int facets : {40, 80, 160}) {
    double worst = 0.0;
    double worst_normal = 0.0;
    const MeshSurface tool(make_grid_mesh(facets + 1, 5, [&](int i, int j) {
      const double a = 2 * std::numbers::pi * (i % facets) / facets;
      return Vec3(10 * std::cos(a), 10 * std::sin(a), 5.0 * (j - 2));
    }));
    for (int i = 0; i < 100; ++i) {
      const double a = 0.01 * i;
      const Vec3 y(10.5 * std::cos(a), 10.5 * std::sin(a), 0.37);
      worst = std::max(worst, std::abs(look_up(tool, y).gap - look_up(exact, y).gap));
      worst_normal = std::max(worst_normal, (look_up(tool, y).normal - look_up(exact, y).normal).norm());
    }
    const double theta = 2 * std::numbers::pi / facets;
    EXPECT_LT(worst, 1.05 * 10 * theta * theta / 8);  // the sagitta, mechanics 6.2
    EXPECT_LT(worst_normal, 0.02 * theta);  // equal facets: the normal errs by its interpolation only
    if (last_gap > 0.0) {
      EXPECT_NEAR(last_gap / worst, 4.0, 0.1);
    }
    last_gap = worst;
  }
}

TEST(MeshSurface, FacetRuleJumpsButLosesNothing) {
  const MeshSurface tool(test::make_icosphere(10, 1), {NormalRule::facet, 60.0});
  const Jump jump = march(tool, Vec3(0, 0, 10.5), Vec3(8, 0, 8), 20000);
  EXPECT_GT(jump.normal, 0.1);
  Dice dice(8);
  for (int i = 0; i < 1000; ++i) {
    SearchHint hint;
    const Vec3 x = dice.number(8.5, 11.5) * dice.direction();
    const auto foot = tool.find_foot_point(x, 4, 4, hint);
    ASSERT_TRUE(foot);
    EXPECT_NEAR(foot->gap, x.norm() - 10,
                0.7);  // sagitta of 36 degree facets, and the distance to their edges
    EXPECT_EQ(foot->beyond_edge, 0.0);
    EXPECT_EQ(foot->normal_gradient, Mat3::Zero());
    EXPECT_EQ(foot->gap_gradient, foot->normal);
  }
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

TEST(SmoothFacets, ErrFarLessThanFlatOnes) {
  // Mechanics 6.2: the sagitta R theta^2 / 8 of flat facets becomes R theta^4 / 128.
  const CylinderSurface exact(Pose{}, 10.0, Side::outside, 5.0);
  double last = 0.0;
  for (int facets : {24, 48}) {
    const TriangleMesh mesh = make_grid_mesh(facets + 1, 5, [&](int i, int j) {
      const double a = 2 * std::numbers::pi * (i % facets) / facets;
      return Vec3(10 * std::cos(a), 10 * std::sin(a), 2.0 * (j - 2));
    });
    const MeshSurface tool(mesh, {.is_smooth = true});
    double worst = 0.0;
    for (int i = 0; i < 500; ++i) {
      const double a = 0.005 * i;
      for (double r : {9.5, 10.0, 10.5}) {
        const Vec3 x(r * std::cos(a), r * std::sin(a), 0.3);
        worst = std::max(worst, std::abs(look_up(tool, x).gap - look_up(exact, x).gap));
      }
    }
    const double theta = 2 * std::numbers::pi / facets;
    EXPECT_LT(worst, 0.05 * 10 * theta * theta / 8);
    if (last > 0.0) {
      EXPECT_GT(last / worst, 12.0);
    }
    last = worst;
  }
}

TEST(SmoothFacets, GapIsContinuousOverEdgesAndRims) {
  const MeshSurface tool(make_barrel(10, 6), {.is_smooth = true});
  Dice dice(9);
  for (int i = 0; i < 20; ++i) {
    const double a = dice.number(0.2, 1.3);
    const double r = dice.number(9.5, 10.5);
    const Vec3 from(r * std::cos(a), r * std::sin(a), -2.0);
    const Jump jump = march(tool, from, from + Vec3(0.5, -0.8, 7.0), 20000);
    EXPECT_LT(jump.gap, 1e-9);
    EXPECT_GT(jump.crossings, 2);
  }
}

TEST(SmoothFacets, GradientsAgreeWithDifferences) {
  const MeshSurface tool(make_barrel(10, 6), {.is_smooth = true});
  Dice dice(10);
  const double step = 1e-5;
  int inside = 0;
  int beyond = 0;
  for (int i = 0; i < 500; ++i) {
    const double a = dice.number(0.1, 1.4);
    const double r = dice.number(9, 11);
    const Vec3 x(r * std::cos(a), r * std::sin(a), dice.number(-5, 5));
    const FootPoint here = look_up(tool, x);
    bool is_inside = true;
    for (int k = 0; k < 6; ++k) {
      const FootPoint there = look_up(tool, x + (k < 3 ? 2 : -2) * step * Vec3::Unit(k % 3));
      is_inside = is_inside && there.facet == here.facet && (there.beyond_edge > 0) == (here.beyond_edge > 0);
    }
    if (!is_inside) continue;
    ++(here.beyond_edge > 0 ? beyond : inside);
    const test::GradientError error = test::measure_gradients(tool, x, step);
    EXPECT_LT(error.gap, 1e-6);
    EXPECT_LT(error.normal, 1e-6);
  }
  EXPECT_GT(inside, 300);
  EXPECT_GT(beyond, 50);
}

TEST(SmoothFacets, StayClosedAtCreases) {
  const MeshSurface tool(test::make_cube(1, 4), {.is_smooth = true});
  EXPECT_NEAR(look_up(tool, Vec3(1.2, 0.1, 1.3)).gap, std::hypot(0.2, 0.3), 1e-12);
  EXPECT_NEAR(look_up(tool, Vec3(0.3, 0.1, 1.3)).gap, 0.3, 1e-12);
}

TEST(MeshSurface, DisplayMeshKeepsFacetNumbers) {
  const TriangleMesh cube = test::make_cube(1, 2);
  const MeshSurface tool(cube);
  ASSERT_EQ(tool.display_mesh().triangles.size(), cube.triangles.size());
  EXPECT_EQ(tool.display_mesh().points.size(), tool.display_normals().size());
  for (std::size_t f = 0; f < cube.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(tool.display_mesh().points[at(tool.display_mesh().triangles[f][k])],
                cube.points[at(cube.triangles[f][k])]);
    }
  }
}

TEST(MeshSurface, RefusesFacetsWithoutArea) {
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_THROW(MeshSurface{mesh}, ContractError);
}

}  // namespace
}  // namespace hydroscope
