// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/vertex_normals.h"

#include <gtest/gtest.h>

#include "solver/base/error.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::at;

constexpr double kDegree = std::numbers::pi / 180.0;

double angle_deg(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)) / kDegree; }

CornerNormals calc_normals(const TriangleMesh& mesh, NormalRule rule) {
  return calc_corner_normals(mesh, make_topology(mesh), rule, 60 * kDegree);
}

double worst_on_sphere(int times, NormalRule rule) {
  const TriangleMesh mesh = test::make_icosphere(10, times);
  const CornerNormals normals = calc_normals(mesh, rule);
  double worst = 0.0;
  for (std::size_t i = 0; i < normals.normals.size(); ++i) {
    worst = std::max(worst, angle_deg(normals.normals[i], mesh.points[at(normals.points[i])]));
  }
  return worst;
}

/// Largest error in the middle of a closed cylinder whose facets turn by 3, 6, 9, 3, ... degrees.
double worst_on_cylinder(NormalRule rule) {
  std::vector<double> angles;
  for (int i = 0; i < 20; ++i) angles.insert(angles.end(), {18.0 * i, 18.0 * i + 3, 18.0 * i + 9});
  const TriangleMesh mesh = make_grid_mesh(61, 5, [&](int i, int j) {
    const double a = angles[at(i % 60)] * kDegree;
    return Vec3(10 * std::cos(a), 10 * std::sin(a), j);
  });
  const CornerNormals normals = calc_normals(mesh, rule);
  double worst = 0.0;
  for (std::size_t i = 0; i < normals.normals.size(); ++i) {
    const Vec3& x = mesh.points[at(normals.points[i])];
    if (x.z() != 2.0) continue;
    worst = std::max(worst, angle_deg(normals.normals[i], Vec3(x.x(), x.y(), 0)));
  }
  return worst;
}

/// Error at the tangent line where flat facets of `flat` mm meet a fillet of R 5 in 9 degree facets.
double error_at_tangent_line(double flat, NormalRule rule) {
  const TriangleMesh mesh = make_grid_mesh(11, 21, [&](int i, int j) {
    const double z = 0.8 * (j - 10);
    if (i <= 3) return Vec3(flat * (i - 3), 0, z);
    const double a = 9 * (i - 3) * kDegree;
    return Vec3(5 * std::sin(a), 5 * std::cos(a) - 5, z);
  });
  const CornerNormals normals = calc_normals(mesh, rule);
  for (std::size_t i = 0; i < normals.normals.size(); ++i) {
    const Vec3& x = mesh.points[at(normals.points[i])];
    if (std::abs(x.x()) < 1e-12 && std::abs(x.z()) < 1e-12) {
      return angle_deg(normals.normals[i], Vec3::UnitY() * (normals.normals[i].y() > 0 ? 1 : -1));
    }
  }
  return -1.0;
}

// The table of mechanics 6.1; its last digit is the tolerance.
TEST(VertexNormals, ErrorsOnIcosphereOf320) {
  EXPECT_NEAR(worst_on_sphere(2, NormalRule::plain), 0.76, 0.006);
  EXPECT_NEAR(worst_on_sphere(2, NormalRule::area), 1.35, 0.006);
  EXPECT_NEAR(worst_on_sphere(2, NormalRule::angle), 0.60, 0.006);
  EXPECT_LT(worst_on_sphere(2, NormalRule::max), 1e-6);
}

TEST(VertexNormals, ErrorsOnIcosphereOf1280) {
  EXPECT_NEAR(worst_on_sphere(3, NormalRule::plain), 0.47, 0.006);
  EXPECT_NEAR(worst_on_sphere(3, NormalRule::area), 0.68, 0.006);
  EXPECT_NEAR(worst_on_sphere(3, NormalRule::angle), 0.30, 0.006);
  EXPECT_LT(worst_on_sphere(3, NormalRule::max), 1e-6);
}

TEST(VertexNormals, ErrorsOnAnUnevenCylinder) {
  EXPECT_NEAR(worst_on_cylinder(NormalRule::plain), 1.50, 0.01);
  EXPECT_NEAR(worst_on_cylinder(NormalRule::area), 3.00, 0.02);
  EXPECT_NEAR(worst_on_cylinder(NormalRule::angle), 1.50, 0.01);
}

TEST(VertexNormals, ErrorsAtATangentLine) {
  EXPECT_NEAR(error_at_tangent_line(5.0, NormalRule::plain), 2.25, 0.01);
  EXPECT_NEAR(error_at_tangent_line(5.0, NormalRule::area), 0.61, 0.01);
  EXPECT_NEAR(error_at_tangent_line(5.0, NormalRule::angle), 2.25, 0.01);
  EXPECT_NEAR(error_at_tangent_line(0.8, NormalRule::plain), 2.25, 0.01);
  EXPECT_NEAR(error_at_tangent_line(0.8, NormalRule::area), 2.23, 0.01);
  EXPECT_NEAR(error_at_tangent_line(0.8, NormalRule::angle), 2.25, 0.01);
}

TEST(VertexNormals, MaxIsExactOnACylinderAndWorstWhereAFlatBegins) {
  EXPECT_NEAR(worst_on_cylinder(NormalRule::max), 0.0, 0.005);
  EXPECT_NEAR(error_at_tangent_line(5.0, NormalRule::max), 3.89, 0.01);
  EXPECT_NEAR(error_at_tangent_line(0.8, NormalRule::max), 2.27, 0.01);
}

TEST(VertexNormals, AreaWeightsByHand) {
  // Two facets over a ridge, areas 2 : 1, normals (0,0,1) and (1,0,0): their node gets (1,0,2)/sqrt 5.
  TriangleMesh mesh;
  mesh.points = {{0, 0, 0}, {0, 1, 0}, {-2, 0, 0}, {0, 0, -1}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  const auto topology = make_topology(mesh);
  const CornerNormals normals = calc_corner_normals(mesh, topology, NormalRule::area, 91 * kDegree);
  EXPECT_LT((normals.normals[at(normals.corners[0][0])] - Vec3(1, 0, 2).normalized()).norm(), 1e-14);
  EXPECT_EQ(normals.corners[0][0], normals.corners[1][1]);
}

TEST(VertexNormals, AreNotAveragedOverACrease) {
  const TriangleMesh cube = test::make_cube(1, 2);
  const CornerNormals normals =
      calc_corner_normals(cube, make_topology(cube), NormalRule::area, 40 * kDegree);
  const auto facet_normals = calc_facet_normals(cube);
  EXPECT_EQ(normals.normals.size(), 6u * 9u);  // every face its own nine
  for (std::size_t f = 0; f < cube.triangles.size(); ++f) {
    for (int id : normals.corners[f]) EXPECT_LT((normals.normals[at(id)] - facet_normals[f]).norm(), 1e-14);
  }
}

TEST(VertexNormals, FacetRuleKeepsEveryFacetsOwn) {
  const TriangleMesh mesh = test::make_icosphere(10, 1);
  const CornerNormals normals = calc_normals(mesh, NormalRule::facet);
  EXPECT_EQ(normals.normals.size(), 3 * mesh.triangles.size());
}

TEST(VertexNormals, RulesHaveNames) {
  EXPECT_EQ(parse_normal_rule("max"), NormalRule::max);
  EXPECT_THROW(parse_normal_rule("smooth"), InputError);
}

}  // namespace
}  // namespace hydroscope
