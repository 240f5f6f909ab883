// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/generators/die_meshes.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "solver/base/error.h"
#include "solver/geometry/analytic_surface.h"
#include "solver/geometry/mesh_surface.h"
#include "solver/import/mesh_statistics.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::at;

FootPoint look_up(const ToolSurface& tool, const Vec3& x) {
  SearchHint hint;
  return tool.find_foot_point(x, 1e3, 1e3, hint).value();
}

/// Sound: one part, no flaw, borders only where the die ends, facets turning gently.
void expect_sound(const TriangleMesh& mesh, double largest_angle, std::size_t rims) {
  const MeshStatistics statistics = measure_mesh(mesh, 40.0);
  EXPECT_EQ(statistics.parts, 1);
  EXPECT_EQ(statistics.non_manifold_edges, 0);
  EXPECT_EQ(statistics.flipped_edges, 0);
  EXPECT_EQ(statistics.creases, 0);
  EXPECT_EQ(statistics.slivers, 0);
  EXPECT_EQ(statistics.t_joints, 0);
  EXPECT_EQ(statistics.rim_lengths.size(), rims);
  EXPECT_LE(statistics.largest_facet_angle, largest_angle);
}

/// Facets as sets of exact corners, to compare with a reflection.
std::set<std::set<std::array<double, 3>>> list_facets(const TriangleMesh& mesh, const Mat3& reflection) {
  std::set<std::set<std::array<double, 3>>> facets;
  for (const auto& t : mesh.triangles) {
    std::set<std::array<double, 3>> facet;
    for (int p : t) {
      const Vec3 x = reflection * mesh.points[at(p)];
      facet.insert({x.x() + 0.0, x.y() + 0.0, x.z() + 0.0});
    }
    facets.insert(facet);
  }
  return facets;
}

TEST(SquareDie, IsSoundInEveryCoverage) {
  for (Coverage coverage : {Coverage::octant, Coverage::quarter, Coverage::full}) {
    SquareDie die;
    die.coverage = coverage;
    expect_sound(make_square_die(die), 7.0, coverage == Coverage::full ? 2 : 1);
  }
}

TEST(SquareDie, LiesOnItsSectionAndFacesTheTube) {
  const SquareDie die;
  const TriangleMesh mesh = make_square_die(die);
  const RoundedBoxSurface exact(Pose{}, {die.half_width, die.half_width, die.corner_radius}, Side::inside,
                                1.0);
  for (const Vec3& p : mesh.points) EXPECT_NEAR(look_up(exact, p).gap, 0.0, 1e-12);
  const auto normals = calc_facet_normals(mesh);
  for (std::size_t f = 0; f < normals.size(); ++f) {
    EXPECT_GT(normals[f].dot(look_up(exact, mesh.points[at(mesh.triangles[f][0])]).normal), 0.99);
  }
}

TEST(SquareDie, AveragedNormalsAreRightAtTangentLines) {
  const SquareDie die;
  const MeshSurface tool(make_square_die(die));
  const RoundedBoxSurface exact(Pose{}, {die.half_width, die.half_width, die.corner_radius}, Side::inside,
                                1.0);
  const auto& points = tool.display_mesh().points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(points[i].z()) > 19.0) continue;  // rims average over one side only
    const double error = (tool.display_normals()[i] - look_up(exact, points[i]).normal).norm();
    // Graded flats: a quarter of the facet angle of 6.4 degrees at tangent lines, nothing elsewhere.
    EXPECT_LT(error, 0.0285);
  }
}

TEST(SquareDie, TouchesTheTubeAndReachesBeyondTheSymmetryPlanes) {
  const MeshSurface tool(make_square_die({}));
  for (int i = 0; i <= 90; ++i) {
    const double a = i * std::numbers::pi / 180;
    const FootPoint foot = look_up(tool, Vec3(30.75 * std::cos(a), 30.75 * std::sin(a), 0.5));
    EXPECT_GT(foot.gap, -1e-12);
    EXPECT_EQ(foot.beyond_edge, 0.0);
  }
}

TEST(SquareBulgeDie, IsSoundAndOfAFewThousandFacets) {
  SquareBulgeDie die;
  EXPECT_GT(make_square_bulge_die(die).triangles.size(), 2000u);
  EXPECT_LT(make_square_bulge_die(die).triangles.size(), 8000u);
  for (Coverage coverage : {Coverage::octant, Coverage::quarter, Coverage::full}) {
    for (bool is_half : {true, false}) {
      die.coverage = coverage;
      die.is_half_length = is_half;
      expect_sound(make_square_bulge_die(die), 7.0, coverage == Coverage::full ? 2 : 1);
    }
  }
}

TEST(SquareBulgeDie, IsRoundInTheGuideAndSquareInTheMiddle) {
  const SquareBulgeDie die;
  const TriangleMesh mesh = make_square_bulge_die(die);
  const RoundedBoxSurface square(Pose{}, {die.half_width, die.half_width, die.corner_radius}, Side::inside,
                                 1.0);
  int in_guide = 0;
  for (const Vec3& p : mesh.points) {
    if (std::abs(p.z()) <= die.square_end) {
      EXPECT_NEAR(look_up(square, p).gap, 0.0, 1e-12);
    } else if (p.z() >= die.round_start) {
      EXPECT_NEAR(std::hypot(p.x(), p.y()), die.guide_radius, 1e-12);
      ++in_guide;
    } else {
      EXPECT_GE(std::hypot(p.x(), p.y()), die.guide_radius - 1e-12);
      EXPECT_GE(look_up(square, p).gap, -1e-12);
    }
  }
  EXPECT_GT(in_guide, 100);
}

TEST(SquareBulgeDie, TubeFitsWithClearanceAndSeesTheFreeSide) {
  const MeshSurface tool(make_square_bulge_die({}));
  for (int i = 0; i <= 90; ++i) {
    for (int j = 0; j <= 90; ++j) {
      const double a = i * std::numbers::pi / 180;
      const FootPoint foot = look_up(tool, Vec3(30.75 * std::cos(a), 30.75 * std::sin(a), j));
      EXPECT_GT(foot.gap, 0.04);  // facets take 0.005 mm of the guide's clearance of 0.05
      EXPECT_LT(foot.gap, 15.5);
      EXPECT_EQ(foot.beyond_edge, 0.0);
    }
  }
}

TEST(SquareBulgeDie, MirrorsExactly) {
  SquareBulgeDie die;
  die.coverage = Coverage::full;
  die.is_half_length = false;
  const TriangleMesh mesh = make_square_bulge_die(die);
  const auto facets = list_facets(mesh, Mat3::Identity());
  for (const Vec3& signs : {Vec3(-1, 1, 1), Vec3(1, -1, 1), Vec3(1, 1, -1)}) {
    EXPECT_TRUE(list_facets(mesh, signs.asDiagonal()) == facets) << signs.transpose();
  }
  Mat3 diagonal = Mat3::Zero();
  diagonal(0, 1) = diagonal(1, 0) = diagonal(2, 2) = 1;
  EXPECT_TRUE(list_facets(mesh, diagonal) == facets);
}

TEST(SquareBulgeDie, NormalsOnSymmetryPlanesLieInThem) {
  const MeshSurface tool(make_square_bulge_die({}));
  const auto& points = tool.display_mesh().points;
  int on_planes = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(points[i][axis]) > 1e-12) continue;
      EXPECT_NEAR(tool.display_normals()[i][axis], 0.0, 1e-12);
      ++on_planes;
    }
  }
  EXPECT_GT(on_planes, 100);
}

TEST(SquareBulgeDie, NormalsPointAtTheAxisInTheGuide) {
  // Equal facets: averaging does not lean.
  const SquareBulgeDie die;
  const MeshSurface tool(make_square_bulge_die(die));
  const auto& points = tool.display_mesh().points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_in_guide = points[i].z() > die.round_start + 2 && points[i].z() < die.half_length - 1;
    if (!is_in_guide || points[i].x() < -1 || points[i].y() < -1) continue;
    const Vec3 inward = -Vec3(points[i].x(), points[i].y(), 0).normalized();
    EXPECT_LT((tool.display_normals()[i] - inward).norm(), 1e-9);
  }
}

TEST(SquareBulgeDie, TransitionHasNoKinkAtItsEnds) {
  const SquareBulgeDie die;
  std::map<double, double> ridge;  // radius over z on the 45 degree line, the deepest of all
  for (const Vec3& p : make_square_bulge_die(die).points) {
    if (p.x() == p.y()) ridge[p.z()] = std::hypot(p.x(), p.y());
  }
  // Half a cosine wave: the slope changes by at most pi^2/2 x height / length^2 a mm.
  const double loft = die.round_start - die.square_end;
  const double height = ridge[0.0] - die.guide_radius;
  const double step = loft / die.loft_rows;
  const double largest = std::numbers::pi * std::numbers::pi / 2 * height / (loft * loft) * step;
  double slope = 0.0;
  int bends = 0;
  for (auto next = std::next(ridge.find(0.0)), here = ridge.find(0.0); next != ridge.end(); here = next++) {
    const double new_slope = (next->second - here->second) / (next->first - here->first);
    EXPECT_LT(std::abs(new_slope - slope), 1.01 * largest) << here->first;
    bends += new_slope != slope ? 1 : 0;
    slope = new_slope;
  }
  EXPECT_GT(bends, 30);
}

TEST(PunchMesh, IsSoundAndConvex) {
  const Punch punch;
  const TriangleMesh mesh = make_punch(punch);
  expect_sound(mesh, 3.0 + 1e-9, 1);
  const auto normals = calc_facet_normals(mesh);
  for (std::size_t f = 0; f < normals.size(); ++f) {
    const Vec3& p = mesh.points[at(mesh.triangles[f][0])];
    EXPECT_NEAR(std::hypot(p.x(), p.y()), punch.radius, 1e-12);
    EXPECT_GT(normals[f].dot(Vec3(p.x(), p.y(), 0)), 0.0);
  }
  Punch whole;
  whole.start = 0.0;
  whole.end = 360.0;
  expect_sound(make_punch(whole), 3.0 + 1e-9, 2);
}

TEST(Dies, RefuseImpossibleSizes) {
  SquareDie square;
  square.corner_radius = 31;
  EXPECT_THROW(make_square_die(square), InputError);
  square = {};
  square.corner_facets = 13;
  EXPECT_THROW(make_square_die(square), InputError);
  SquareBulgeDie bulge;
  bulge.round_start = 20;
  EXPECT_THROW(make_square_bulge_die(bulge), InputError);
  Punch punch;
  punch.end = punch.start;
  EXPECT_THROW(make_punch(punch), InputError);
}

}  // namespace
}  // namespace hydroscope
