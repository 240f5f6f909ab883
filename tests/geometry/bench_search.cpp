// SPDX-License-Identifier: GPL-3.0-or-later
// Prints what a look-up costs with each global search and tool form against the number of facets.
#include <chrono>
#include <cstdio>
#include <memory>

#include "solver/geometry/height_surface.h"
#include "solver/geometry/mesh_surface.h"
#include "solver/geometry/nagata_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::at;
using test::Dice;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Points near the surface: over random places of it, up to 1 mm off.
std::vector<Vec3> scatter(const TriangleMesh& mesh, int count) {
  Dice dice(1);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const auto& t =
        mesh.triangles[at(static_cast<int>(dice.number(0, static_cast<double>(mesh.triangles.size()))))];
    const double l = dice.number(0, 1);
    points.push_back(l * mesh.points[at(t[0])] + (1 - l) * mesh.points[at(t[1])] +
                     dice.number(0, 1) * dice.direction());
  }
  return points;
}

/// A fine fillet of radius 2 between two flats that reach 200 mm, in a few long facets each.
TriangleMesh make_mixed(int corner_facets) {
  return make_grid_mesh(corner_facets + 3, corner_facets / 2 + 2, [&](int i, int j) {
    const double z = 20.0 * j / (corner_facets / 2 + 1);
    if (i == 0) return Vec3(-200, 0, z);
    if (i == corner_facets + 2) return Vec3(2, -202, z);
    const double a = 0.5 * std::numbers::pi * (i - 1) / corner_facets;
    return Vec3(2 * std::sin(a), 2 * std::cos(a) - 2, z);
  });
}

/// Nanoseconds a look-up of the nearest facet, without a hint.
double time_search(const FacetSearch& search, const std::vector<Vec3>& points, std::size_t count) {
  const auto start = Clock::now();
  int sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += search.find_nearest(points[i], {-1, 1e30}).facet;
  const double time = seconds_since(start) / static_cast<double>(count);
  if (sum == -1) std::puts("");  // the loop has a use
  return 1e9 * time;
}

double time_surface(const ToolSurface& tool, const std::vector<Vec3>& points, bool has_hints) {
  std::vector<SearchHint> hints(points.size());
  double best = 1e30;
  for (int pass = 0; pass < 3; ++pass) {
    if (!has_hints) hints.assign(points.size(), {});
    const auto start = Clock::now();
    for (std::size_t i = 0; i < points.size(); ++i) tool.find_foot_point(points[i], 5.0, 5.0, hints[i]);
    if (pass > 0) best = std::min(best, seconds_since(start) / static_cast<double>(points.size()));
  }
  return 1e9 * best;
}

void bench_searches(const char* name, const std::vector<TriangleMesh>& meshes) {
  std::printf("\n%s: build [ms] and nearest facet [ns a look-up, no hint]\n", name);
  std::printf("%10s %18s %18s %18s\n", "facets", "tree", "grid", "all");
  for (const TriangleMesh& mesh : meshes) {
    const std::vector<Vec3> points = scatter(mesh, 20000);
    std::printf("%10zu", mesh.triangles.size());
    for (SearchRule rule : {SearchRule::tree, SearchRule::grid, SearchRule::all}) {
      const auto start = Clock::now();
      const auto search = make_facet_search(mesh, rule);
      const double build = 1e3 * seconds_since(start);
      // Trying all is slow: as many look-ups as take about a second.
      const std::size_t most =
          rule == SearchRule::all ? 20'000'000 / mesh.triangles.size() + 1 : points.size();
      std::printf(" %8.2f %9.0f", build, time_search(*search, points, std::min(most, points.size())));
    }
    std::printf("\n");
  }
}

void bench_forms() {
  const TriangleMesh mesh = test::make_torus(60, 20, 240, 80);
  const std::vector<Vec3> points = scatter(mesh, 20000);
  std::printf("\nforms on a torus of %zu facets: foot point [ns a look-up]\n", mesh.triangles.size());
  std::printf("%12s %10s %10s\n", "form", "no hint", "followed");
  MeshSurfaceOptions quads;
  for (int f = 0; f + 1 < static_cast<int>(mesh.triangles.size()); f += 2) quads.quads.push_back({f, f + 1});
  MeshSurfaceOptions orthogonal;
  orthogonal.projection = Projection::orthogonal;
  const std::pair<const char*, std::shared_ptr<const ToolSurface>> tools[] = {
      {"facets", std::make_shared<MeshSurface>(mesh)},
      {"orthogonal", std::make_shared<MeshSurface>(mesh, orthogonal)},
      {"smooth", std::make_shared<MeshSurface>(mesh, MeshSurfaceOptions{.is_smooth = true})},
      {"quads", std::make_shared<MeshSurface>(mesh, quads)},
      {"nagata", std::make_shared<NagataSurface>(mesh)}};
  for (const auto& [name, tool] : tools) {
    std::printf("%12s %10.0f %10.0f\n", name, time_surface(*tool, points, false),
                time_surface(*tool, points, true));
  }
  // Of the point set, a bowl with as many cells as the torus has quads.
  HeightField field;
  field.columns = field.rows = 99;
  field.origin = Vec2(-49, -49);
  for (int i = 0; i < 99 * 99; ++i) {
    const double x = i % 99 - 49, y = i / 99 - 49;
    field.heights.push_back(0.01 * (x * x + y * y));
  }
  const HeightSurface bowl(field, Pose{});
  const std::vector<Vec3> over = scatter(bowl.display_mesh(), 20000);
  std::printf("%12s %10.0f %10.0f\n", "points", time_surface(bowl, over, false),
              time_surface(bowl, over, true));
}

void run() {
  std::vector<TriangleMesh> even, mixed;
  for (int n : {16, 32, 64, 128, 256, 512}) {
    even.push_back(test::make_torus(60, 20, 2 * n, n / 2));
    mixed.push_back(make_mixed(n));
  }
  bench_searches("facets of like size (torus)", even);
  bench_searches("fine fillet between large flats", mixed);
  bench_forms();
}

}  // namespace
}  // namespace hydroscope

int main() { hydroscope::run(); }
