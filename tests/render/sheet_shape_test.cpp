// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/sheet_shape.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "render/image/colour_map.h"
#include "solver/base/error.h"
#include "tests/render/synthetic.h"

namespace hydroscope {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Two quads side by side in the x-y plane, 1 mm thick, mirrored about x = 0.
std::shared_ptr<Snapshot> make_two_quads() {
  auto model = std::make_shared<SnapshotModel>();
  model->quads = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  model->mirrors = {{Vec3::Zero(), Vec3::UnitX()}};
  auto s = std::make_shared<Snapshot>();
  s->model = model;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 3; ++i) s->points.emplace_back(i, j, 0.0);
  s->directors.assign(6, Vec3::UnitZ());
  s->thickness.assign(6, 1.0);
  s->plastic_strain.assign(6, 0.0);
  s->contact_state.assign(6, ContactClass::kFree);
  s->contact_tool.assign(6, -1);
  s->gap.assign(6, 0.0);
  s->contact_pressure.assign(6, 0.0);
  for (auto* vectors : {&s->contact_force, &s->tool_normal, &s->slip, &s->slip_increment})
    vectors->assign(6, Vec3::Zero());
  return s;
}

double calc_volume(const Surface& surface) {
  double volume = 0.0;
  for (const auto& p : surface.polygons) {
    const auto x = [&](std::size_t k) -> Vec3 { return surface.points[at(p[k])].cast<double>(); };
    volume += (x(0).dot(x(1).cross(x(2))) + x(0).dot(x(2).cross(x(3)))) / 6.0;
  }
  return volume;
}

TEST(SheetShape, WallIsAClosedSolidOfTheSheetsVolume) {
  const auto s = make_two_quads();
  // Divergence theorem: only a closed surface with all faces outward gives area * thickness.
  EXPECT_NEAR(calc_volume(SheetShape(*s, false).make_wall(*s, std::nullopt)), 2.0, 1e-6);
  EXPECT_NEAR(calc_volume(SheetShape(*s, true).make_wall(*s, std::nullopt)), 4.0, 1e-6);
}

TEST(SheetShape, SplittingQuadsKeepsTheWallClosed) {
  const auto s = make_two_quads();
  s->contact_state[1] = ContactClass::kStick;
  const Surface wall = SheetShape(*s, true).make_wall(*s, NodePaint{{}, s->contact_state});
  EXPECT_NEAR(calc_volume(wall), 4.0, 1e-6);
}

TEST(SheetShape, AMeshListedInsideOutIsTurnedRound) {
  const auto s = make_two_quads();
  auto turned = std::make_shared<SnapshotModel>(*s->model);
  for (auto& quad : turned->quads) std::swap(quad[1], quad[3]);
  s->model = turned;
  EXPECT_NEAR(calc_volume(SheetShape(*s, false).make_wall(*s, std::nullopt)), 2.0, 1e-6);
}

TEST(SheetShape, NoRimWhereTheMirrorImageContinues) {
  const auto s = make_two_quads();
  // Two faces of a rim edge; 6 edges around the two quads, 1 on the plane x = 0.
  EXPECT_EQ(SheetShape(*s, false).make_rim(*s).lines.size(), 2u * 6u);
  EXPECT_EQ(SheetShape(*s, true).make_rim(*s).lines.size(), 2u * 2u * 5u);
}

TEST(SheetShape, ASectorWhoseCopiesDoNotCloseIsClosedByItsRim) {
  // Mirrored about x = 0 and then about x = 2: four copies side by side, from -2 to 6.
  const auto s = make_two_quads();
  auto model = std::make_shared<SnapshotModel>(*s->model);
  model->mirrors.push_back({Vec3(2, 0, 0), Vec3::UnitX()});
  s->model = model;
  const SheetShape shape(*s, true);
  EXPECT_NEAR(calc_volume(shape.make_wall(*s, std::nullopt)), 8.0, 1e-6);
  EXPECT_EQ(shape.make_rim(*s).lines.size(), 2u * (2u * 8u + 2u));
}

TEST(SheetShape, EveryNodeOwnsItsQuarterOfAMixedQuad) {
  const auto s = make_two_quads();
  s->contact_state[1] = ContactClass::kSlip;
  const Surface wall = SheetShape(*s, false).make_wall(*s, NodePaint{{}, s->contact_state});
  ASSERT_EQ(wall.colours.size(), wall.points.size());
  std::map<Rgb, double> area;  // of the outer face, by colour
  for (const auto& p : wall.polygons) {
    if (wall.normals[at(p[0])].z() < 0.5f) continue;
    for (int corner : p)
      EXPECT_EQ(wall.colours[at(corner)], wall.colours[at(p[0])]) << "one colour a polygon";
    const auto x = [&](std::size_t k) { return wall.points[at(p[k])]; };
    area[wall.colours[at(p[0])]] += 0.5 * (x(2) - x(0)).cross(x(3) - x(1)).norm();
  }
  EXPECT_NEAR(area[class_colour(ContactClass::kSlip)], 0.5, 1e-6);  // a quarter of each quad
  EXPECT_NEAR(area[class_colour(ContactClass::kFree)], 1.5, 1e-6);
  EXPECT_EQ(area.size(), 2u);
}

TEST(SheetShape, ANodeWithoutValueNeverMixesWithItsNeighbours) {
  const auto s = make_two_quads();
  s->gap = {1.0, std::nan(""), 3.0, 4.0, 5.0, 6.0};
  const Surface wall = SheetShape(*s, false).make_wall(*s, NodePaint{s->gap, {}});
  ASSERT_EQ(wall.values.size(), wall.points.size());
  int without = 0;
  for (const auto& p : wall.polygons) {
    int nan_corners = 0;
    for (int corner : p) nan_corners += std::isnan(wall.values[at(corner)]) ? 1 : 0;
    EXPECT_TRUE(nan_corners == 0 || nan_corners == 4);
    without += nan_corners / 4;
  }
  EXPECT_EQ(without, 2 * 2 + 2);  // two quarters on each face, and halves of two rim edges
}

TEST(SheetShape, SeamsOfTheMirroredTubeHaveNoCrease) {
  const SyntheticBulge bulge;
  const auto s = bulge.make_snapshot(bulge.make_model(), 0.6, 3);
  const auto normals = SheetShape(*s, true).calc_normals(*s);
  for (std::size_t node = 0; node < s->points.size(); ++node)
    for (const Plane& plane : s->model->mirrors)
      if (std::abs(plane.normal.dot(s->points[node])) < 1e-9) {
        EXPECT_NEAR(plane.normal.dot(normals[node]), 0.0, 1e-12);
      }
}

TEST(SheetShape, PlacesThatAreNoNumbersAreRefused) {
  const auto s = make_two_quads();
  s->points[4].y() = std::numeric_limits<double>::quiet_NaN();
  try {
    SheetShape shape(*s, true);
    FAIL() << "accepted";
  } catch (const ContractError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("node 4"));
  }
}

TEST(SheetShape, ArraysOfAWrongLengthAreNamed) {
  const auto s = make_two_quads();
  s->thickness.pop_back();
  try {
    check_snapshot(*s);
    FAIL() << "accepted";
  } catch (const ContractError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("thickness has 5 entries for 6"));
  }
}

}  // namespace
}  // namespace hydroscope
