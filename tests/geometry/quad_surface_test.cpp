// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "solver/geometry/analytic_surface.h"
#include "solver/geometry/mesh_surface.h"
#include "solver/geometry/quad_prism.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::at;
using test::Dice;

FootPoint look_up(const ToolSurface& tool, const Vec3& x) {
  SearchHint hint;
  return tool.find_foot_point(x, 1e3, 1e3, hint).value();
}

/// Facets 2 k and 2 k + 1 of a grid mesh are the halves of one cell.
MeshSurfaceOptions as_quads(const TriangleMesh& mesh, MeshSurfaceOptions options = {}) {
  for (int f = 0; f + 1 < static_cast<int>(mesh.triangles.size()); f += 2)
    options.quads.push_back({f, f + 1});
  return options;
}

/// Twisted cells: neither flat nor rectangular, on a torus with rows that run askew.
TriangleMesh make_skew_torus(int around, int turns) {
  return make_grid_mesh(around + 1, turns + 1, [&](int i, int j) {
    const double t = 2 * std::numbers::pi * (j % turns) / turns;
    const double a = 2 * std::numbers::pi * ((i % around) + 0.25 * std::sin(2 * t)) / around;
    const double rho = 30 + 10 * std::cos(t);
    return Vec3(rho * std::cos(a), rho * std::sin(a), 10 * std::sin(t));
  });
}

Vec3 place_on_torus(Dice& dice, double gap) {
  const double a = dice.number(0, 6.2), t = dice.number(0, 6.2);
  const double r = 10 + gap;
  return {(30 + r * std::cos(t)) * std::cos(a), (30 + r * std::cos(t)) * std::sin(a), r * std::sin(t)};
}

TEST(QuadPrism, RecoversItsCoordinates) {
  // A strongly warped quad; from its corners, V = (a1 x a2) / |a1 x a2| (4.1).
  const std::array<Vec3, 4> x{Vec3(0, 0, 0), Vec3(2, 0.1, 0.3), Vec3(2.3, 1.9, -0.2), Vec3(-0.1, 1.6, 0.4)};
  std::array<Vec3, 4> v;
  for (std::size_t k = 0; k < 4; ++k)
    v[k] = (x[(k + 1) % 4] - x[k]).cross(x[(k + 3) % 4] - x[k]).normalized();
  const QuadPrism quad = make_quad_prism(x, v);
  Dice dice(1);
  for (int i = 0; i < 200; ++i) {
    const double xi = dice.number(0, 1), eta = dice.number(0, 1), g = dice.number(-0.5, 0.5);
    const double n[4] = {(1 - xi) * (1 - eta), xi * (1 - eta), xi * eta, (1 - xi) * eta};
    Vec3 point = Vec3::Zero(), m = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) {
      point += n[k] * x[k];
      m += n[k] * v[k];  // (4.2)
    }
    const QuadPoint place = locate_in_quad(quad, point + g * m);
    ASSERT_TRUE(place.is_valid);
    EXPECT_NEAR(place.xi, xi, 1e-9);
    EXPECT_NEAR(place.eta, eta, 1e-9);
    const FootPoint foot = make_foot_point(quad, place, point + g * m);
    EXPECT_LT((foot.normal - m.normalized()).norm(), 1e-9);
    EXPECT_NEAR(foot.gap, g * m.norm(), 1e-9);
    EXPECT_LT((foot.normal.transpose() * foot.normal_gradient).norm(), 1e-12);
    EXPECT_NEAR(foot.normal.dot(foot.gap_gradient), 1.0, 1e-12);
  }
}

TEST(QuadSurface, TellsItselfFromTriangles) {
  const TriangleMesh mesh = make_skew_torus(24, 16);
  const MeshSurface triangles(mesh);
  const MeshSurface quads(mesh, as_quads(mesh));
  EXPECT_EQ(triangles.quad_count(), 0);
  EXPECT_EQ(quads.quad_count(), 24 * 16);
  Dice dice(2);
  double difference = 0.0, turn = 0.0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 x = place_on_torus(dice, 0.3);
    difference = std::max(difference, std::abs(look_up(quads, x).gap - look_up(triangles, x).gap));
    turn = std::max(turn, (look_up(quads, x).normal - look_up(triangles, x).normal).norm());
  }
  EXPECT_GT(difference, 0.02);
  EXPECT_GT(turn, 0.01);
}

TEST(QuadSurface, BilinearPatchIsMetExactly) {
  // One quad z = x y / 5 with its exact normals at the corners would be exact; with (4.1) they are exact.
  TriangleMesh mesh;
  mesh.points = {{-1, -1, 0.2}, {1, -1, -0.2}, {1, 1, 0.2}, {-1, 1, -0.2}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const MeshSurface tool(mesh, as_quads(mesh));
  Dice dice(3);
  for (int i = 0; i < 200; ++i) {
    const double x = dice.number(-0.95, 0.95), y = dice.number(-0.95, 0.95);
    const FootPoint foot = look_up(tool, Vec3(x, y, x * y / 5));
    EXPECT_NEAR(foot.gap, 0.0, 1e-12);
    EXPECT_LT((foot.point - Vec3(x, y, x * y / 5)).norm(), 1e-12);
    EXPECT_LT(foot.normal.cross(Vec3(-y / 5, -x / 5, 1).normalized()).norm(), 2e-3);
  }
}

TEST(QuadSurface, HasNoDeadZones) {
  for (bool is_concave : {false, true}) {
    TriangleMesh mesh = make_skew_torus(30, 18);
    if (is_concave) flip_mesh(mesh);
    const MeshSurface tool(mesh, as_quads(mesh, {NormalRule::area, 60.0}));
    Dice dice(4);
    int without = 0, several = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 x = place_on_torus(dice, dice.number(-2, 2));
      // Points on the diagonal belong to both halves of a quad: the dice do not hit it.
      const auto prisms = tool.list_prisms_at(x, 2.5);
      without += prisms.empty() ? 1 : 0;
      several += prisms.size() > 1 ? 1 : 0;
    }
    EXPECT_EQ(without, 0);
    EXPECT_EQ(several, 0);
  }
}

TEST(QuadSurface, GapAndNormalAreContinuous) {
  const TriangleMesh mesh = make_skew_torus(24, 16);
  const MeshSurface tool(mesh, as_quads(mesh));
  Dice dice(5);
  int crossings = 0;
  for (int i = 0; i < 20; ++i) {
    const Vec3 from = place_on_torus(dice, dice.number(-1, 1));
    const Vec3 step = 1e-3 * dice.direction();
    SearchHint hint;
    FootPoint last = *tool.find_foot_point(from, 1e3, 1e3, hint);
    for (int k = 1; k <= 6000; ++k) {
      const FootPoint here = *tool.find_foot_point(from + k * step, 1e3, 1e3, hint);
      if (std::abs(here.gap) > 3.0) break;
      ASSERT_LT(std::abs(here.gap - last.gap), 1.1e-3);
      ASSERT_LT((here.normal - last.normal).norm(), 5e-4);
      crossings += here.facet != last.facet ? 1 : 0;
      last = here;
    }
  }
  EXPECT_GT(crossings, 20);
}

TEST(QuadSurface, GradientsAgreeWithDifferences) {
  for (NormalRule rule : {NormalRule::area, NormalRule::facet}) {
    const TriangleMesh mesh = make_skew_torus(40, 28);
    const MeshSurface tool(mesh, as_quads(mesh, {rule, 60.0}));
    Dice dice(6);
    const double step = 1e-5;
    int inside = 0;
    for (int i = 0; i < 600; ++i) {
      const Vec3 x = place_on_torus(dice, rule == NormalRule::facet ? 0.0 : dice.number(-2, 2));
      const FootPoint here = look_up(tool, x);
      bool is_inside = true;  // within one facet: over its edges the gradient jumps
      for (int k = 0; k < 6; ++k) {
        const FootPoint there = look_up(tool, x + (k < 3 ? 40 : -40) * step * Vec3::Unit(k % 3));
        is_inside = is_inside && there.facet == here.facet;
      }
      if (!is_inside) continue;
      ++inside;
      const test::GradientError error = test::measure_gradients(tool, x, step);
      EXPECT_LT(error.normal, 1e-6);
      EXPECT_LT(error.gap, 1e-6);
    }
    EXPECT_GT(inside, 500);
  }
}

TEST(QuadSurface, NormalsDoNotDependOnTheDiagonals) {
  // The same quads, each split the other way.
  const TriangleMesh rising = make_grid_mesh(
      9, 9, [](int i, int j) { return Vec3(i, 0.8 * j, 0.05 * i * i + 0.03 * i * j); },
      [](int, int) { return true; });
  const TriangleMesh falling = make_grid_mesh(
      9, 9, [](int i, int j) { return Vec3(i, 0.8 * j, 0.05 * i * i + 0.03 * i * j); },
      [](int i, int) { return i % 3 == 0; });
  for (NormalRule rule : {NormalRule::plain, NormalRule::area, NormalRule::angle, NormalRule::max}) {
    const MeshSurface a(rising, as_quads(rising, {rule, 60.0}));
    const MeshSurface b(falling, as_quads(falling, {rule, 60.0}));
    ASSERT_EQ(a.display_normals().size(), b.display_normals().size());
    for (std::size_t i = 0; i < a.display_normals().size(); ++i) {
      EXPECT_LT((a.display_normals()[i] - b.display_normals()[i]).norm(), 1e-12);
    }
    for (double x : {0.3, 2.6, 7.4}) {
      const FootPoint p = look_up(a, Vec3(x, 3.1, 0.4)), q = look_up(b, Vec3(x, 3.1, 0.4));
      EXPECT_NEAR(p.gap, q.gap, 1e-12);
      EXPECT_LT((p.normal_gradient - q.normal_gradient).norm(), 1e-10);
    }
  }
}

TEST(QuadSurface, FacetRuleKeepsEachQuadsOwnNormals) {
  // Flat quads of a prism: normals jump from one to the next, and do not turn within.
  const TriangleMesh mesh = make_grid_mesh(25, 3, [](int i, int j) {
    const double a = 2 * std::numbers::pi * (i % 24) / 24;
    return Vec3(10 * std::cos(a), 10 * std::sin(a), 5.0 * j);
  });
  const MeshSurface tool(mesh, as_quads(mesh, {NormalRule::facet, 60.0}));
  const auto facet_normals = calc_facet_normals(mesh);
  Dice dice(7);
  for (int i = 0; i < 300; ++i) {
    const double a = dice.number(0, 6.28);
    const FootPoint foot = look_up(tool, Vec3(10.5 * std::cos(a), 10.5 * std::sin(a), dice.number(1, 9)));
    EXPECT_LT((foot.normal - facet_normals[at(foot.facet)]).norm(), 1e-12);
    EXPECT_LT(foot.normal_gradient.norm(), 1e-12);
    EXPECT_LT((foot.gap_gradient - foot.normal).norm(), 1e-12);
    EXPECT_EQ(foot.beyond_edge, 0.0);
  }
  EXPECT_NEAR(look_up(tool, Vec3(10.5, 0.1, 12)).beyond_edge, 2.0, 1e-9);
}

TEST(QuadSurface, TrianglesAmongQuadsStayTriangles) {
  TriangleMesh mesh = make_grid_mesh(5, 5, [](int i, int j) { return Vec3(i, j, 0.03 * i * i); });
  MeshSurfaceOptions options = as_quads(mesh);
  options.quads.resize(8);
  const MeshSurface tool(mesh, options);
  EXPECT_EQ(tool.quad_count(), 8);
  Dice dice(8);
  for (int i = 0; i < 500; ++i) {
    const Vec3 x(dice.number(0.1, 3.9), dice.number(0.1, 3.9), 0.6);
    EXPECT_EQ(tool.list_prisms_at(x, 1.0).size(), 1u);
    EXPECT_EQ(look_up(tool, x).beyond_edge, 0.0);
  }
}

TEST(QuadSurface, CrookedQuadsStayTriangles) {
  // A dart: its third corner points inwards.
  TriangleMesh dart;
  dart.points = {{0, 0, 0}, {2, 0, 0}, {0.4, 0.4, 0}, {0, 2, 0}};
  dart.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_TRUE(cover_with_quads(dart, {{0, 1}}).quads.empty());
  dart.points[2] = {2, 2, 0};
  EXPECT_EQ(cover_with_quads(dart, {{0, 1}}).quads.size(), 1u);
  dart.triangles = {{0, 1, 2}, {0, 3, 2}};  // turned away from its other half
  EXPECT_TRUE(cover_with_quads(dart, {{0, 1}}).quads.empty());
}

}  // namespace
}  // namespace hydroscope
