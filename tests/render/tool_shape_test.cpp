// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/tool_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/error.h"
#include "tests/render/synthetic.h"

namespace hydroscope {
namespace {

/// Two triangles folded along the y axis by `fold` degrees in all.
SnapshotModel::Tool make_fold(double fold) {
  const double half = 0.5 * fold * std::numbers::pi / 180.0;
  SnapshotModel::Tool tool;
  tool.name = "fold";
  tool.mesh.points = {Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(std::cos(half), 0, -std::sin(half)),
                      Vec3(-std::cos(half), 0, -std::sin(half))};
  tool.mesh.triangles = {{0, 2, 1}, {0, 1, 3}};
  const Vec3 right(std::sin(half), 0, std::cos(half)), left(-std::sin(half), 0, std::cos(half));
  tool.normals = {Vec3::UnitZ(), Vec3::UnitZ(), right, left};
  return tool;
}

TEST(ToolShape, ColoursByTheAngleBetweenFacetAndContinuousNormal) {
  const ToolShape shape(make_fold(20.0), {});
  EXPECT_NEAR(shape.largest_angle(), 10.0, 1e-10);
  const Surface surface = shape.make_surface(Vec3::Zero());
  ASSERT_EQ(surface.values.size(), 6u);
  EXPECT_NEAR(surface.values[0], 10.0f, 1e-5);  // on the fold
  EXPECT_NEAR(surface.values[1], 0.0f, 1e-5);   // at the free corner
}

TEST(ToolShape, AFlippedContinuousNormalShowsAs180Degrees) {
  auto tool = make_fold(0.0);
  tool.normals[2] = -tool.normals[2];
  EXPECT_NEAR(ToolShape(tool, {}).largest_angle(), 180.0, 1e-10);
}

TEST(ToolShape, LightsSharpEdgesFlatAndSmoothOnesRound) {
  // Half of the fold lies between a facet and the normal on the edge.
  EXPECT_TRUE(ToolShape(make_fold(40.0), {}).make_surface(Vec3::Zero()).normals[0].isApprox(Vec3f::UnitZ()));
  const Surface sharp = ToolShape(make_fold(80.0), {}).make_surface(Vec3::Zero());
  EXPECT_NEAR(sharp.normals[0].z(), std::cos(40.0 * std::numbers::pi / 180.0), 1e-6);
}

TEST(ToolShape, SharpAndOpenEdgesAreLines) {
  EXPECT_EQ(ToolShape(make_fold(20.0), {}).make_edges(Vec3::Zero()).lines.size(), 4u);
  EXPECT_EQ(ToolShape(make_fold(80.0), {}).make_edges(Vec3::Zero()).lines.size(), 5u);
}

TEST(ToolShape, TheSeamOfAMirroredToolIsNoEdge) {
  SnapshotModel::Tool half = make_fold(80.0);
  half.mesh.triangles.pop_back();
  half.mesh.points.pop_back();
  half.normals.pop_back();
  const ToolShape shape(half, {{Vec3::Zero(), Vec3::UnitX()}});
  EXPECT_EQ(shape.reflections().size(), 2u);
  EXPECT_EQ(shape.make_edges(Vec3::Zero()).lines.size(), 2u * 2u);
}

TEST(ToolShape, IsDrawnWhereItHasMovedTo) {
  const Surface moved = ToolShape(make_fold(20.0), {}).make_surface(Vec3(1, 2, 3));
  EXPECT_TRUE(moved.points[0].isApprox(Vec3f(1, 2, 3)));
  // The mirror image of a moved tool moves the other way.
  const SnapshotModel::Tool quarter = make_fold(20.0);
  const ToolShape mirrored(quarter, {{Vec3::Zero(), Vec3::UnitZ()}});
  const Surface both = mirrored.make_surface(Vec3(0, 0, -3));
  EXPECT_FLOAT_EQ(both.points[0].z(), -3.0f);
  EXPECT_FLOAT_EQ(both.points[6].z(), 3.0f);
}

TEST(ToolShape, WhatReachesOverAMirrorIsCutOff) {
  SnapshotModel::Tool plate;
  plate.name = "plate";
  plate.mesh.points = {Vec3(-1, 0, 0), Vec3(9, 0, 0), Vec3(9, 6, 0), Vec3(-1, 6, 0)};
  plate.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  plate.normals.assign(4, Vec3::UnitZ());
  const ToolShape shape(plate, {{Vec3::Zero(), Vec3::UnitX()}});
  double area = 0.0;
  for (std::size_t f = 0; f < shape.mesh().triangles.size(); ++f) {
    area += shape.calc_facet_area(f);
    EXPECT_NEAR(shape.facet_normals()[f].z(), 1.0, 1e-12) << "facets keep their side";
  }
  EXPECT_NEAR(area, 54.0, 1e-12);
  for (const Vec3& x : shape.mesh().points) EXPECT_GE(x.x(), -1e-12);
  EXPECT_EQ(shape.reflections().size(), 2u);
  EXPECT_EQ(shape.make_edges(Vec3::Zero()).lines.size(), 2u * 3u) << "the cut is a seam";
}

TEST(ToolShape, AWholeDieIsNotDoubled) {
  SyntheticBulge bulge;
  const auto eighth = bulge.make_model();
  EXPECT_EQ(ToolShape(eighth->tools[0], eighth->mirrors).reflections().size(), 8u);
  bulge.is_whole_die = true;
  const auto whole = bulge.make_model();
  EXPECT_EQ(ToolShape(whole->tools[0], whole->mirrors).reflections().size(), 1u);
}

TEST(ToolShape, SectionRunsOnceAcrossTheFacets) {
  const LineSet section =
      ToolShape(make_fold(20.0), {}).make_section(Vec3::Zero(), {Vec3(0, 0.25, 0), Vec3::UnitY()});
  ASSERT_EQ(section.lines.size(), 2u);
  for (const Vec3f& x : section.points) EXPECT_FLOAT_EQ(x.y(), 0.25f);
}

TEST(ToolShape, MissingNormalsAreRefused) {
  auto tool = make_fold(20.0);
  tool.normals.pop_back();
  EXPECT_THROW(ToolShape(tool, {}), ContractError);
}

}  // namespace
}  // namespace hydroscope
