// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/analytic_surface.h"

#include <gtest/gtest.h>

#include <memory>

#include "solver/base/error.h"
#include "solver/geometry/mesh_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::Dice;

Pose make_some_pose() { return make_pose({20, -35, 50}, {1, -2, 3}); }

FootPoint look_up(const ToolSurface& tool, const Vec3& x) {
  SearchHint hint;
  return tool.find_foot_point(x, 1e3, 1e3, hint).value();
}

std::vector<std::shared_ptr<const ToolSurface>> make_all(const Pose& pose) {
  return {
      std::make_shared<PlaneSurface>(pose, 50.0),
      std::make_shared<CylinderSurface>(pose, 30.0, Side::inside, 40.0),
      std::make_shared<CylinderSurface>(pose, 30.0, Side::outside, 40.0),
      std::make_shared<RoundedBoxSurface>(pose, RoundedBoxSurface::Section{36, 30, 12}, Side::inside, 40.0),
      std::make_shared<RoundedBoxSurface>(pose, RoundedBoxSurface::Section{36, 30, 12}, Side::outside, 40.0),
      std::make_shared<TorusSurface>(pose, 40.0, 10.0, Side::inside),
      std::make_shared<TorusSurface>(pose, 40.0, 10.0, Side::outside)};
}

/// Points near the surface: those of its display mesh, moved along their normals.
std::vector<Vec3> list_near_points(const ToolSurface& tool, double farthest, unsigned seed) {
  Dice dice(seed);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < tool.display_mesh().points.size(); i += 7) {
    const Vec3 shift = 0.3 * dice.direction();
    points.push_back(tool.display_mesh().points[i] +
                     dice.number(-farthest, farthest) * tool.display_normals()[i] + shift);
  }
  return points;
}

TEST(AnalyticSurface, DisplayMeshLiesOnTheSurfaceWithItsNormals) {
  for (const auto& tool : make_all(make_some_pose())) {
    const TriangleMesh& mesh = tool->display_mesh();
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
      const FootPoint foot = look_up(*tool, mesh.points[i]);
      EXPECT_NEAR(foot.gap, 0.0, 1e-12);
      EXPECT_LT((foot.normal - tool->display_normals()[i]).norm(), 1e-9);
    }
    // Facets wind counter-clockwise seen from the free side.
    const auto facet_normals = calc_facet_normals(mesh);
    for (std::size_t f = 0; f < facet_normals.size(); ++f) {
      const auto corner = static_cast<std::size_t>(mesh.triangles[f][0]);
      EXPECT_GT(facet_normals[f].dot(tool->display_normals()[corner]), 0.95);
    }
  }
}

TEST(AnalyticSurface, FootPointFitsGapAndNormal) {
  for (const auto& tool : make_all(make_some_pose())) {
    for (const Vec3& x : list_near_points(*tool, 4.0, 1)) {
      const FootPoint foot = look_up(*tool, x);
      EXPECT_LT((foot.point + foot.gap * foot.normal - x).norm(), 1e-12);
      EXPECT_NEAR(look_up(*tool, foot.point).gap, 0.0, 1e-12);
      EXPECT_NEAR(foot.normal.norm(), 1.0, 1e-14);
    }
  }
}

TEST(AnalyticSurface, GradientsAgreeWithDifferences) {
  const double step = 1e-5;
  for (const auto& tool : make_all(make_some_pose())) {
    int tested = 0;
    for (const Vec3& x : list_near_points(*tool, 4.0, 2)) {
      SearchHint hint;
      bool is_inside = true;
      for (int k = 0; k < 6; ++k) {
        const auto there =
            tool->find_foot_point(x + (k < 3 ? 2 : -2) * step * Vec3::Unit(k % 3), 1e3, 1e3, hint);
        is_inside = is_inside && there->facet == look_up(*tool, x).facet;
      }
      if (!is_inside) continue;
      ++tested;
      const test::GradientError error = test::measure_gradients(*tool, x, step);
      EXPECT_LT(error.normal, 1e-6);
      EXPECT_LT(error.gap, 1e-6);
    }
    EXPECT_GT(tested, 50);
  }
}

TEST(AnalyticSurface, CurvatureHasTheRightSignAndSize) {
  const CylinderSurface hill(Pose{}, 30.0, Side::outside, 40.0);
  const CylinderSurface hollow(Pose{}, 30.0, Side::inside, 40.0);
  const Mat3 around = Vec3::UnitY() * Vec3::UnitY().transpose();
  EXPECT_LT((look_up(hill, Vec3(30, 0, 5)).normal_gradient - around / 30).norm(), 1e-15);
  EXPECT_LT((look_up(hollow, Vec3(30, 0, 5)).normal_gradient + around / 30).norm(), 1e-15);
  EXPECT_EQ(look_up(hill, Vec3(31, 0, 5)).normal, Vec3(1, 0, 0));
  EXPECT_EQ(look_up(hollow, Vec3(29, 0, 5)).normal, Vec3(-1, 0, 0));
  EXPECT_NEAR(look_up(hollow, Vec3(29, 0, 5)).gap, 1.0, 1e-15);
  EXPECT_NEAR(look_up(hill, Vec3(29, 0, 5)).gap, -1.0, 1e-15);
  // On the inner side of a torus its two curvatures differ in sign.
  const TorusSurface ring(Pose{}, 40.0, 10.0, Side::outside);
  const Mat3 gradient = look_up(ring, Vec3(30, 0, 0)).normal_gradient;
  EXPECT_NEAR(gradient(2, 2), 1.0 / 10, 1e-15);
  EXPECT_NEAR(gradient(1, 1), -1.0 / 30, 1e-15);
}

TEST(RoundedBox, GapAndNormalAreContinuousAllAround) {
  for (Side side : {Side::inside, Side::outside}) {
    const RoundedBoxSurface box(Pose{}, {36, 30, 12}, side, 40.0);
    for (double offset : {-3.0, 0.0, 3.0}) {
      const RoundedBoxSurface path(Pose{}, {36 + offset, 30 + offset, 12 + offset}, side, 40.0);
      FootPoint last = look_up(box, look_up(path, Vec3(50, 0, 0)).point);
      for (int i = 1; i <= 36000; ++i) {
        const double a = 2 * std::numbers::pi * i / 36000;
        const FootPoint here = look_up(box, look_up(path, Vec3(50 * std::cos(a), 50 * std::sin(a), 0)).point);
        EXPECT_NEAR(std::abs(here.gap), std::abs(offset), 1e-12);
        EXPECT_LT((here.normal - last.normal).norm(), 1.2e-3);  // 3 steps' turn in the sharpest corner
        last = here;
      }
    }
  }
}

TEST(RoundedBox, PatchesAreNumberedAround) {
  const RoundedBoxSurface box(Pose{}, {36, 30, 12}, Side::inside, 40.0);
  EXPECT_EQ(look_up(box, Vec3(35, 0, 0)).facet, 0);
  EXPECT_EQ(look_up(box, Vec3(0, 29, 0)).facet, 1);
  EXPECT_EQ(look_up(box, Vec3(-35, 0, 0)).facet, 2);
  EXPECT_EQ(look_up(box, Vec3(0, -29, 0)).facet, 3);
  EXPECT_EQ(look_up(box, Vec3(32, 26, 0)).facet, 4);
  EXPECT_EQ(look_up(box, Vec3(-32, 26, 0)).facet, 5);
  EXPECT_EQ(look_up(box, Vec3(-32, -26, 0)).facet, 6);
  EXPECT_EQ(look_up(box, Vec3(32, -26, 0)).facet, 7);
}

TEST(RoundedBox, FarPointsMeetTheNearerFlat) {
  const RoundedBoxSurface box(Pose{}, {36, 36, 12}, Side::inside, 40.0);
  const FootPoint foot = look_up(box, Vec3(21, 20, 0));  // beyond the corner's centre of curvature
  EXPECT_NEAR(foot.gap, 15.0, 1e-12);
  EXPECT_EQ(foot.normal, Vec3(-1, 0, 0));
}

TEST(AnalyticSurface, CentresGiveNoNonsense) {
  const Pose pose;
  const CylinderSurface hollow(pose, 30.0, Side::inside, 40.0);
  const RoundedBoxSurface box(pose, {36, 36, 12}, Side::inside, 40.0);
  const TorusSurface torus(pose, 40.0, 10.0, Side::inside);
  for (double off : {0.0, 1e-12, 1e-6}) {
    for (const ToolSurface* tool :
         {static_cast<const ToolSurface*>(&hollow), static_cast<const ToolSurface*>(&box),
          static_cast<const ToolSurface*>(&torus)}) {
      for (const Vec3& x : {Vec3(off, 0, 3), Vec3(24 + off, 24 + off, 1), Vec3(40 + off, 0, off)}) {
        const FootPoint foot = look_up(*tool, x);
        EXPECT_TRUE(foot.normal.allFinite());
        EXPECT_NEAR(foot.normal.norm(), 1.0, 1e-12);
        EXPECT_TRUE(foot.normal_gradient.allFinite());
        EXPECT_TRUE(std::isfinite(foot.gap));
      }
    }
  }
  // Past the axis it is the other wall that is near, never a gap beyond the radius.
  EXPECT_NEAR(look_up(hollow, Vec3(-1, 0, 0)).gap, 29.0, 1e-12);
  EXPECT_GT(look_up(hollow, Vec3(-1, 0, 0)).normal.x(), 0.99);
  SearchHint hint;
  EXPECT_FALSE(hollow.find_foot_point(Vec3(1, 0, 0), 5.0, 2.0, hint));
}

TEST(AnalyticSurface, PoseMovesEverything) {
  const Pose pose = make_some_pose();
  const auto placed = make_all(pose);
  const auto own = make_all(Pose{});
  for (std::size_t i = 0; i < own.size(); ++i) {
    for (const Vec3& x : list_near_points(*own[i], 3.0, 4)) {
      const FootPoint a = look_up(*own[i], x);
      const FootPoint b = look_up(*placed[i], pose.place_point(x));
      EXPECT_NEAR(a.gap, b.gap, 1e-12);
      EXPECT_LT((pose.place_direction(a.normal) - b.normal).norm(), 1e-12);
      EXPECT_LT((pose.place_point(a.point) - b.point).norm(), 1e-11);
      const Mat3 turned = pose.rotation * a.normal_gradient * pose.rotation.transpose();
      EXPECT_LT((turned - b.normal_gradient).norm(), 1e-12);
    }
  }
}

TEST(Pose, TurnsAboutXThenYThenZ) {
  const Pose pose = make_pose({90, 0, 90}, {1, 2, 3});
  // y goes to z about x, and stays there about z; z goes to -y, then to x.
  EXPECT_EQ(pose.place_direction(Vec3::UnitY()), Vec3::UnitZ());
  EXPECT_EQ(pose.place_direction(Vec3::UnitZ()), Vec3::UnitX());
  EXPECT_EQ(pose.place_point(Vec3::Zero()), Vec3(1, 2, 3));
  EXPECT_NEAR(make_some_pose().rotation.determinant(), 1.0, 1e-14);
}

TEST(Pose, FramesAreRightHandedForEveryDirection) {
  Dice dice(5);
  for (int i = 0; i < 100; ++i) {
    const Vec3 d = i < 6 ? Vec3((i < 3 ? 1 : -1) * Vec3::Unit(i % 3)) : Vec3(3.0 * dice.direction());
    const Mat3 frame = make_frame(d);
    EXPECT_LT((frame.col(2) - d.normalized()).norm(), 1e-14);
    EXPECT_NEAR(frame.determinant(), 1.0, 1e-14);
    EXPECT_LT((frame.transpose() * frame - Mat3::Identity()).norm(), 1e-14);
  }
}

TEST(AnalyticSurface, AgreesWithItsOwnDisplayMesh) {
  for (const auto& tool : make_all(make_some_pose())) {
    const MeshSurface mesh(tool->display_mesh());
    for (const Vec3& x : list_near_points(*tool, 2.0, 6)) {
      const FootPoint exact = look_up(*tool, x);
      SearchHint hint;
      const auto foot = mesh.find_foot_point(x, 10, 10, hint);
      ASSERT_TRUE(foot);
      if (foot->beyond_edge > 0.0) continue;
      EXPECT_NEAR(foot->gap, exact.gap, 0.02);  // sagitta of 5 degree facets at R 10: 0.01 mm
      EXPECT_LT((foot->normal - exact.normal).norm(), 0.04);
    }
  }
}

TEST(AnalyticSurface, RefusesImpossibleSizes) {
  EXPECT_THROW(CylinderSurface(Pose{}, 0.0, Side::inside, 1.0), ContractError);
  EXPECT_THROW(RoundedBoxSurface(Pose{}, {10, 10, 11}, Side::inside, 1.0), ContractError);
  EXPECT_THROW(TorusSurface(Pose{}, 5.0, 6.0, Side::inside), ContractError);
}

}  // namespace
}  // namespace hydroscope
