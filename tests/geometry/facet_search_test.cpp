// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/facet_search.h"

#include <gtest/gtest.h>

#include <set>

#include "solver/base/error.h"
#include "solver/geometry/facet_grid.h"
#include "solver/geometry/mesh_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::at;
using test::Dice;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Facets of very different sizes: two large flats and a fine fillet between them.
TriangleMesh make_fillet_between_flats() {
  return make_grid_mesh(33, 9, [](int i, int j) {
    const double z = 5.0 * j;
    if (i <= 1) return Vec3(40.0 * (i - 1), 0, z);
    if (i >= 31) return Vec3(2, -2 - 40.0 * (i - 31), z);
    const double a = 0.5 * std::numbers::pi * (i - 1) / 30;
    return Vec3(2 * std::sin(a), 2 * std::cos(a) - 2, z);
  });
}

std::vector<TriangleMesh> make_meshes() {
  TriangleMesh single;
  single.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  single.triangles = {{0, 1, 2}};
  return {test::make_icosphere(10, 2), test::make_torus(20, 5, 40, 24), make_fillet_between_flats(),
          test::make_cube(1, 4), single};
}

/// Corners, middles of edges and facets, places between cells, the axis, and points far outside.
std::vector<Vec3> list_places(const TriangleMesh& mesh, const FacetGrid& grid, Dice& dice) {
  std::vector<Vec3> places{Vec3::Zero(), Vec3(1e7, 0, 0), Vec3(-300, 200, -1e3), grid.low(), grid.high()};
  for (int i = 0; i < 300; ++i) {
    const auto& t =
        mesh.triangles[at(static_cast<int>(dice.number(0, static_cast<double>(mesh.triangles.size()))))];
    const Vec3& a = mesh.points[at(t[0])];
    const Vec3& b = mesh.points[at(t[1])];
    const Vec3 middle = (a + b + mesh.points[at(t[2])]) / 3.0;
    for (double off : {0.0, 1e-15, -1e-12, 1e-9}) {
      for (const Vec3& place : {a, Vec3(0.5 * (a + b)), middle})
        places.push_back(place + off * dice.direction());
    }
    const Vec3 border = grid.low() + grid.cell_size() * Vec3(i % 5, i % 7, i % 3);
    places.insert(places.end(), {border, Vec3(middle * dice.number(0, 2))});
    places.push_back(1.3 * (grid.high() - grid.low()).norm() * dice.number(0, 1) * dice.direction());
  }
  return places;
}

TEST(FacetSearch, AllRulesGiveTheSamePairs) {
  Dice dice(31);
  for (const TriangleMesh& mesh : make_meshes()) {
    const auto all = make_facet_search(mesh, SearchRule::all);
    const auto tree = make_facet_search(mesh, SearchRule::tree);
    const auto grid = make_facet_search(mesh, SearchRule::grid);
    for (const Vec3& x : list_places(mesh, FacetGrid(mesh), dice)) {
      // Without a bound, with a wide and a narrow one, and from some facet on.
      const int other = static_cast<int>(dice.number(0, static_cast<double>(mesh.triangles.size())));
      for (const FacetSearch::Nearest start :
           {FacetSearch::Nearest{-1, kInfinity}, FacetSearch::Nearest{-1, 1.0},
            FacetSearch::Nearest{other, all->calc_distance2(x, other)}}) {
        const auto wanted = all->find_nearest(x, start);
        for (const auto* rule : {tree.get(), grid.get()}) {
          const auto found = rule->find_nearest(x, start);
          ASSERT_EQ(found.facet, wanted.facet) << x.transpose();
          ASSERT_EQ(found.distance2, wanted.distance2) << x.transpose();
        }
      }
    }
  }
}

TEST(FacetSearch, AllRulesVisitTheSameFacetsOnce) {
  Dice dice(32);
  for (const TriangleMesh& mesh : make_meshes()) {
    const auto all = make_facet_search(mesh, SearchRule::all);
    for (SearchRule rule : {SearchRule::tree, SearchRule::grid}) {
      const auto search = make_facet_search(mesh, rule);
      for (int i = 0; i < 100; ++i) {
        const Vec3 x = 30.0 * dice.number(0, 1) * dice.direction();
        const double radius = i % 10 == 0 ? 0.0 : dice.number(0, 12);
        std::set<int> wanted, found;
        all->visit_within(x, radius, [&](int f) { wanted.insert(f); });
        search->visit_within(x, radius, [&](int f) { EXPECT_TRUE(found.insert(f).second) << f; });
        ASSERT_EQ(found, wanted);
      }
    }
  }
}

/// The same foot points, to the last bit, over a surface with creases, rims and facets of all sizes.
TEST(FacetSearch, FootPointsDoNotDependOnTheRule) {
  Dice dice(33);
  for (const TriangleMesh& mesh : {make_fillet_between_flats(), test::make_cube(10, 4)}) {
    const MeshSurface tree(mesh, {.is_smooth = true, .search = SearchRule::tree});
    const MeshSurface grid(mesh, {.is_smooth = true, .search = SearchRule::grid});
    const MeshSurface all(mesh, {.is_smooth = true, .search = SearchRule::all});
    int found = 0;
    for (int i = 0; i < 3000; ++i) {
      const Vec3& corner =
          mesh.points[at(static_cast<int>(dice.number(0, static_cast<double>(mesh.points.size()))))];
      const Vec3 x = corner + dice.number(0, 4) * dice.direction();
      SearchHint hints[3];
      const auto wanted = all.find_foot_point(x, 3, 3, hints[0]);
      for (const MeshSurface* other : {&tree, &grid}) {
        const auto foot = other->find_foot_point(x, 3, 3, hints[other == &tree ? 1 : 2]);
        ASSERT_EQ(foot.has_value(), wanted.has_value());
        if (!foot) continue;
        ++found;
        EXPECT_EQ(foot->facet, wanted->facet);
        EXPECT_EQ(foot->gap, wanted->gap);
        EXPECT_EQ(foot->normal, wanted->normal);
        EXPECT_EQ(foot->gap_gradient, wanted->gap_gradient);
        EXPECT_EQ(foot->beyond_edge, wanted->beyond_edge);
      }
      EXPECT_EQ(hints[0].clearance, hints[1].clearance);
      EXPECT_EQ(hints[0].clearance, hints[2].clearance);
    }
    EXPECT_GT(found, 3000);
  }
}

TEST(FacetSearch, NotANumberIsNearNothing) {
  const TriangleMesh mesh = test::make_icosphere(10, 1);
  for (SearchRule rule : {SearchRule::tree, SearchRule::grid, SearchRule::all}) {
    EXPECT_EQ(make_facet_search(mesh, rule)->find_nearest(Vec3::Constant(std::nan("")), {-1, 4.0}).facet, -1);
  }
}

TEST(FacetGrid, KeepsItsCellsWithinBounds) {
  // A small ball in a large plate: cells of the size of its facets would be a hundred million.
  TriangleMesh mesh = test::make_icosphere(0.01, 2);
  mesh.points.insert(mesh.points.end(), {{-500, -500, -1}, {500, -500, -1}, {0, 500, 1}});
  const int n = static_cast<int>(mesh.points.size());
  mesh.triangles.push_back({n - 3, n - 2, n - 1});
  const FacetGrid grid(mesh);
  EXPECT_GT(grid.cell_size(), 5.0);
  EXPECT_EQ(grid.find_nearest(Vec3(400, -450, 3), {-1, kInfinity}).facet, 320);
  EXPECT_LT(grid.find_nearest(Vec3(0, 0, 0.02), {-1, kInfinity}).facet, 320);
}

TEST(FacetSearch, RulesHaveNames) {
  EXPECT_EQ(parse_search_rule("grid"), SearchRule::grid);
  EXPECT_EQ(parse_search_rule("all"), SearchRule::all);
  EXPECT_EQ(parse_search_rule("tree"), SearchRule::tree);
  EXPECT_THROW(parse_search_rule("octree"), InputError);
}

}  // namespace
}  // namespace hydroscope
