// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/height_surface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/base/error.h"
#include "solver/geometry/analytic_surface.h"
#include "solver/geometry/mesh_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

using test::Dice;
using testing::AllOf;
using testing::HasSubstr;

FootPoint look_up(const ToolSurface& tool, const Vec3& x) {
  SearchHint hint;
  return tool.find_foot_point(x, 1e3, 1e3, hint).value();
}

template <class Height>
HeightField make_field(int columns, int rows, double pitch, Height&& height) {
  HeightField field;
  field.columns = columns;
  field.rows = rows;
  field.origin = Vec2(-0.5 * pitch * (columns - 1), -0.5 * pitch * (rows - 1));
  field.pitch = Vec2(pitch, pitch);
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      field.heights.push_back(height(field.origin.x() + i * pitch, field.origin.y() + j * pitch));
    }
  }
  return field;
}

double bump(double x, double y) { return 2.0 * std::sin(0.3 * x) * std::cos(0.25 * y); }

template <class Act>
std::string catch_error(Act&& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(HeightSurface, BilinearHeightsAreMetExactly) {
  const HeightSurface tool(make_field(5, 7, 2.0, [](double x, double y) { return x * y / 5 + 1; }), Pose{});
  Dice dice(1);
  for (int i = 0; i < 300; ++i) {
    const double x = dice.number(-3.5, 3.5), y = dice.number(-5.5, 5.5);
    const FootPoint foot = look_up(tool, Vec3(x, y, x * y / 5 + 1));
    EXPECT_NEAR(foot.gap, 0.0, 1e-12);
    EXPECT_EQ(foot.beyond_edge, 0.0);
  }
}

TEST(HeightSurface, ConvergesToTheAnalyticSurface) {
  // A cylinder of radius 20 lying along y, seen from above.
  Pose lying;
  lying.rotation = make_frame(Vec3::UnitY());
  const CylinderSurface exact(lying, 20.0, Side::outside, 10.0);
  double last = 0.0;
  for (int columns : {21, 41, 81}) {
    const double pitch = 20.0 / (columns - 1);
    const HeightSurface tool(
        make_field(columns, columns, pitch, [](double x, double) { return std::sqrt(400 - x * x); }), Pose{});
    double worst = 0.0, worst_normal = 0.0;
    for (int i = 0; i <= 200; ++i) {
      const double a = 0.002 * (i - 100);
      const Vec3 x(20.4 * std::sin(a), 1.3, 20.4 * std::cos(a));
      worst = std::max(worst, std::abs(look_up(tool, x).gap - look_up(exact, x).gap));
      worst_normal = std::max(worst_normal, (look_up(tool, x).normal - look_up(exact, x).normal).norm());
    }
    EXPECT_LT(worst, 1.2 * pitch * pitch / (8 * 20));  // the sagitta
    EXPECT_LT(worst_normal, 0.2 * pitch * pitch / 20);
    if (last > 0.0) {
      EXPECT_NEAR(last / worst, 4.0, 0.3);
    }
    last = worst;
  }
}

TEST(HeightSurface, GradientsAgreeWithDifferences) {
  const HeightSurface tool(make_field(31, 27, 0.7, bump), make_pose({20, 30, 40}, {1, 2, 3}));
  const Pose pose = make_pose({20, 30, 40}, {1, 2, 3});
  Dice dice(2);
  int inside = 0;
  for (int i = 0; i < 600; ++i) {
    const double x = dice.number(-10, 10), y = dice.number(-8.5, 8.5);
    const Vec3 p = pose.place_point(Vec3(x, y, bump(x, y) + dice.number(-1, 1)));
    const FootPoint here = look_up(tool, p);
    EXPECT_NEAR(here.normal.dot(here.gap_gradient), 1.0, 1e-12);
    EXPECT_LT((here.normal.transpose() * here.normal_gradient).norm(), 1e-12);
    bool is_inside = true;
    for (int k = 0; k < 6; ++k) {
      const FootPoint there = look_up(tool, p + (k < 3 ? 1e-3 : -1e-3) * Vec3::Unit(k % 3));
      is_inside = is_inside && there.facet == here.facet;
    }
    if (!is_inside) continue;
    ++inside;
    const test::GradientError error = test::measure_gradients(tool, p, 1e-5);
    EXPECT_LT(error.normal, 1e-6);
    EXPECT_LT(error.gap, 1e-6);
  }
  EXPECT_GT(inside, 500);
}

TEST(HeightSurface, GapAndNormalAreContinuous) {
  const HeightSurface tool(make_field(31, 27, 0.7, bump), Pose{});
  Dice dice(3);
  int crossings = 0;
  for (int i = 0; i < 20; ++i) {
    const double x = dice.number(-6, 6), y = dice.number(-5, 5);
    const Vec3 from(x, y, bump(x, y) + dice.number(-1, 1));
    const Vec3 step = 1e-3 * dice.direction();
    SearchHint hint;
    FootPoint last = *tool.find_foot_point(from, 1e3, 1e3, hint);
    for (int k = 1; k <= 3000; ++k) {
      const FootPoint here = *tool.find_foot_point(from + k * step, 1e3, 1e3, hint);
      if (std::abs(here.gap) > 2.0) break;
      ASSERT_LT(std::abs(here.gap - last.gap), 1.2e-3);
      ASSERT_LT((here.normal - last.normal).norm(), 2e-3);
      crossings += here.facet != last.facet ? 1 : 0;
      last = here;
    }
  }
  EXPECT_GT(crossings, 50);
}

/// A floor and a wall with a draft of ten degrees from x = 0 on, sharp where they meet.
double drafted_wall(double x, double) {
  return std::max(0.0, std::min(x, 1.5) / std::tan(10 * std::numbers::pi / 180));
}

TEST(HeightSurface, TheNearestWallAnswersNotTheCellBelow) {
  const HeightSurface tool(make_field(41, 9, 0.25, drafted_wall), Pose{});
  // High over the floor, just beside the wall.
  const Vec3 x(0.3, 0.1, 5.0);
  const FootPoint foot = look_up(tool, x);
  EXPECT_NEAR(foot.gap,
              (5.0 - 0.3 / std::tan(10 * std::numbers::pi / 180)) * std::sin(10 * std::numbers::pi / 180),
              0.02);
  EXPECT_LT(foot.normal.x(), -0.9);
  EXPECT_GT(tool.sharp_edges(), 8);
  EXPECT_EQ(HeightSurface(make_field(31, 27, 0.7, bump), Pose{}).sharp_edges(), 0);
}

TEST(HeightSurface, HintsDoNotChangeTheAnswer) {
  const HeightSurface tool(make_field(41, 9, 0.25, drafted_wall), Pose{});
  Dice dice(4);
  SearchHint hint;
  for (int i = 0; i < 3000; ++i) {
    const double x = dice.number(-5.5, 5.5);
    const Vec3 p(x, dice.number(-1.2, 1.2), drafted_wall(x, 0) + dice.number(-1, 3));
    SearchHint none;
    const auto cold = tool.find_foot_point(p, 2, 1, none);
    const auto warm = tool.find_foot_point(p, 2, 1, hint);
    ASSERT_EQ(cold.has_value(), warm.has_value());
    if (!cold) continue;
    EXPECT_EQ(cold->gap, warm->gap);
    EXPECT_EQ(cold->facet, warm->facet);
    EXPECT_EQ(cold->normal, warm->normal);
  }
  EXPECT_FALSE(tool.find_foot_point(Vec3::Constant(std::nan("")), 1, 1, hint));
  EXPECT_FALSE(tool.find_foot_point(Vec3(0, 0, 1e9), 1, 1, hint));
}

TEST(HeightSurface, BeyondTheRimThePointIsClampedToIt) {
  const HeightSurface tool(make_field(5, 5, 1.0, [](double, double) { return 0.0; }), Pose{});
  EXPECT_EQ(look_up(tool, Vec3(1.9, 0.3, 0.1)).beyond_edge, 0.0);
  const FootPoint beside = look_up(tool, Vec3(2.5, 0.3, 0.2));
  EXPECT_NEAR(beside.beyond_edge, 0.5, 1e-12);
  EXPECT_NEAR(beside.gap, 0.2, 1e-12);
  const FootPoint corner = look_up(tool, Vec3(2.3, 2.4, -0.2));
  EXPECT_NEAR(corner.beyond_edge, 0.5, 1e-12);
  EXPECT_LT((corner.point - Vec3(2, 2, 0)).norm(), 1e-12);
}

TEST(HeightSurface, MissingPointsLeaveAHole) {
  HeightField field = make_field(9, 9, 1.0, [](double x, double y) {
    return std::abs(x) < 0.5 && std::abs(y) < 0.5 ? std::nan("") : 0.1 * x;
  });
  check_height_field(field, "t");
  const HeightSurface tool(std::move(field), Pose{});
  EXPECT_EQ(tool.display_mesh().triangles.size(), 2u * (64 - 4));
  EXPECT_GT(look_up(tool, Vec3(0.1, 0.2, 0.3)).beyond_edge, 0.7);
  EXPECT_NEAR(look_up(tool, Vec3(0.9, 0.3, 0.2)).beyond_edge, 0.1, 0.03);
  EXPECT_EQ(look_up(tool, Vec3(1.3, 0.3, 0.2)).beyond_edge, 0.0);
  // Along the whole border of the hole, on the surface's side nothing is lost.
  for (int i = 0; i < 100; ++i) {
    const double s = -1.4 + 0.028 * i;
    EXPECT_EQ(look_up(tool, Vec3(s, 1.02, 0.1 * s + 1e-3)).beyond_edge, 0.0) << s;
    EXPECT_EQ(look_up(tool, Vec3(-1.02, s, -0.1)).beyond_edge, 0.0) << s;
  }
}

TEST(HeightSurface, NormalRulesTellApart) {
  const HeightField field =
      make_field(9, 9, 1.0, [](double x, double y) { return 0.05 * x * x * x + 0.1 * y * y; });
  std::vector<Vec3> normals;
  const Vec3 x(1.3, 1.2, 0.5);
  for (NormalRule rule :
       {NormalRule::facet, NormalRule::plain, NormalRule::area, NormalRule::angle, NormalRule::max}) {
    normals.push_back(look_up(HeightSurface(field, Pose{}, rule), x).normal);
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT((normals[i] - normals[j]).norm(), 1e-6) << i << " " << j;
  }
}

TEST(HeightSurface, FacetNormalsJumpAndDoNotTurn) {
  // Flat cells: a roof of constant slopes.
  const HeightSurface tool(
      make_field(9, 5, 1.0, [](double x, double) { return -0.2 * x * std::round(std::abs(x) + 0.4); }),
      Pose{}, NormalRule::facet);
  const FootPoint left = look_up(tool, Vec3(0.9, 0.3, 0.0)), right = look_up(tool, Vec3(1.3, 0.3, -0.1));
  EXPECT_GT((left.normal - right.normal).norm(), 0.05);
  EXPECT_LT(left.normal_gradient.norm(), 1e-12);
  EXPECT_LT((left.gap_gradient - left.normal).norm(), 1e-12);
}

TEST(SampleHeights, GivesTheMeshBack) {
  const TriangleMesh mesh = make_grid_mesh(29, 25, [](int i, int j) {
    const double x = 0.75 * (i - 14), y = 0.75 * (j - 12);
    return Vec3(x, y, bump(x, y));
  });
  const HeightField field = sample_heights(mesh, 0.3, "t");
  EXPECT_LE(field.pitch.x(), 0.3);
  EXPECT_GT(field.pitch.x(), 0.29);
  EXPECT_EQ(field.origin, Vec2(-10.5, -9));
  for (int j = 0; j < field.rows; ++j) {
    for (int i = 0; i < field.columns; ++i) {
      ASSERT_TRUE(field.has_point(i, j)) << i << " " << j;
      EXPECT_NEAR(field.height(i, j), bump(field.point(i, j).x(), field.point(i, j).y()), 0.03);
    }
  }
  const HeightSurface tool(field, Pose{});
  const MeshSurface flat(mesh);
  Dice dice(5);
  double difference = 0.0;
  for (int i = 0; i < 300; ++i) {
    const Vec3 x(dice.number(-9, 9), dice.number(-8, 8), dice.number(-1, 3));
    EXPECT_NEAR(look_up(tool, x).gap, look_up(flat, x).gap, 0.03);
    difference = std::max(difference, std::abs(look_up(tool, x).gap - look_up(flat, x).gap));
  }
  EXPECT_GT(difference, 1e-3);  // a form of its own
}

TEST(SampleHeights, KeepsTheOutlineOfARoundPart) {
  TriangleMesh disc = make_grid_mesh(25, 2, [](int i, int j) {
    const double a = 2 * std::numbers::pi * (i % 24) / 24;
    return j == 0 ? Vec3(0, 0, 1) : Vec3(6 * std::cos(a), 6 * std::sin(a), 0);
  });
  flip_mesh(disc);
  const HeightField field = sample_heights(disc, 0.5, "t");
  EXPECT_FALSE(field.has_point(0, 0));
  EXPECT_TRUE(field.has_point(field.columns / 2, field.rows / 2));
  EXPECT_GT(look_up(HeightSurface(field, Pose{}), Vec3(5.5, 5.5, 0)).beyond_edge, 1.0);
}

TEST(SampleHeights, RefusesVerticalWallsAndOverhangs) {
  const auto step = [](double run) {
    return make_grid_mesh(4, 3, [&](int i, int j) {
      const double x[] = {-5, 0, run, 5}, z[] = {0, 0, 4, 4};
      return Vec3(x[i], j, z[i]);
    });
  };
  EXPECT_EQ(catch_error([&] { sample_heights(step(0.5), 0.2, "tool.die"); }), "");  // 7 degrees of draft
  EXPECT_THAT(
      catch_error([&] { sample_heights(step(0.0), 0.2, "tool.die"); }),
      AllOf(HasSubstr("tool.die"), HasSubstr("(0.000, "), HasSubstr("wall of 90.0 deg"), HasSubstr("draft")));
  EXPECT_THAT(catch_error([&] { sample_heights(step(-0.5), 0.2, "tool.die"); }), HasSubstr("overhangs"));
}

TEST(SampleHeights, RefusesTooManyPoints) {
  const TriangleMesh plate = make_grid_mesh(2, 2, [](int i, int j) { return Vec3(1000 * i, 1000 * j, 0); });
  EXPECT_THAT(catch_error([&] { sample_heights(plate, 0.01, "tool.die"); }), HasSubstr("pitch_mm"));
}

TEST(CheckHeightField, NamesWhatIsWrong) {
  HeightField field = make_field(3, 3, 1.0, [](double x, double) { return x; });
  EXPECT_EQ(catch_error([&] { check_height_field(field, "t"); }), "");
  field.heights[4] = 20.0;
  EXPECT_THAT(catch_error([&] { check_height_field(field, "t"); }), HasSubstr("wall of 8"));
  field.heights.pop_back();
  EXPECT_THAT(catch_error([&] { check_height_field(field, "t"); }), HasSubstr("8 heights"));
  HeightField empty = make_field(3, 3, 1.0, [](double, double) { return std::nan(""); });
  EXPECT_THAT(catch_error([&] { check_height_field(empty, "t"); }), HasSubstr("no four neighbouring"));
}

}  // namespace
}  // namespace hydroscope
