// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/poly_data.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

#include "tests/render/synthetic.h"

namespace hydroscope {
namespace {

class PolyDataOfBulge : public testing::Test {
 protected:
  double value(vtkPolyData* data, const char* name, std::size_t point, int component = 0) {
    vtkDataArray* array = data->GetPointData()->GetArray(name);
    EXPECT_NE(array, nullptr) << name;
    return array == nullptr ? 0.0 : array->GetComponent(static_cast<vtkIdType>(point), component);
  }

  SyntheticBulge bulge{.around = 6, .along = 5};
  std::shared_ptr<Snapshot> s = bulge.make_snapshot(bulge.make_model(), 0.7, 4);
  std::size_t nodes = s->points.size();
};

TEST_F(PolyDataOfBulge, CarriesEveryNodalArray) {
  const auto data = make_poly_data(*s, false);
  ASSERT_EQ(data->GetNumberOfPoints(), static_cast<vtkIdType>(nodes));
  ASSERT_EQ(data->GetNumberOfPolys(), 30);
  for (std::size_t i = 0; i < nodes; ++i) {
    EXPECT_EQ(value(data, "thickness_mm", i), s->thickness[i]);
    EXPECT_EQ(value(data, "plastic_strain", i), s->plastic_strain[i]);
    EXPECT_EQ(value(data, "contact_pressure_MPa", i), s->contact_pressure[i]);
    EXPECT_EQ(value(data, "contact_state", i), static_cast<double>(s->contact_state[i]));
    EXPECT_EQ(value(data, "node_id", i), static_cast<double>(i));
    EXPECT_EQ(std::isnan(value(data, "gap_mm", i)), std::isnan(s->gap[i]));
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(value(data, "contact_force_N", i, c), s->contact_force[i][c]);
      EXPECT_EQ(value(data, "tool_normal", i, c), s->tool_normal[i][c]);
      EXPECT_EQ(value(data, "slip_mm", i, c), s->slip[i][c]);
      EXPECT_EQ(value(data, "slip_increment_mm", i, c), s->slip_increment[i][c]);
    }
  }
}

TEST_F(PolyDataOfBulge, IsMirroredToTheWholePart) {
  const auto data = make_poly_data(*s, true);
  ASSERT_EQ(data->GetNumberOfPoints(), static_cast<vtkIdType>(8 * nodes));
  ASSERT_EQ(data->GetNumberOfPolys(), 8 * 30);
  // Copies are made plane by plane: bit 0 = x, bit 1 = y, bit 2 = z.
  Vec3 sum = Vec3::Zero();
  for (std::size_t copy = 0; copy < 8; ++copy)
    for (std::size_t i = 0; i < nodes; ++i) {
      const std::size_t point = copy * nodes + i;
      double x[3];
      data->GetPoint(static_cast<vtkIdType>(point), x);
      EXPECT_EQ(value(data, "thickness_mm", point), s->thickness[i]);
      for (int c = 0; c < 3; ++c) {
        const double sign = (copy >> c & 1u) != 0 ? -1.0 : 1.0;
        EXPECT_FLOAT_EQ(static_cast<float>(x[c]), static_cast<float>(sign * s->points[i][c]));
        EXPECT_DOUBLE_EQ(value(data, "slip_mm", point, c), sign * s->slip[i][c]);
        EXPECT_DOUBLE_EQ(value(data, "tool_normal", point, c), sign * s->tool_normal[i][c]);
        sum[c] += value(data, "contact_force_N", point, c);
      }
    }
  // A symmetric part is pushed nowhere; relative to the sum of one copy.
  EXPECT_LT(sum.norm(), 1e-9 * 1e5);
}

TEST_F(PolyDataOfBulge, MirroredQuadsStillFaceOutwards) {
  const auto data = make_poly_data(*s, true);
  vtkCellArray* polygons = data->GetPolys();
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    polygons->GetCellAtId(cell, count, ids);
    ASSERT_EQ(count, 4);
    Vec3 x[4];
    for (int k = 0; k < 4; ++k) data->GetPoint(ids[k], x[k].data());
    const Vec3 normal = (x[2] - x[0]).cross(x[3] - x[1]);
    const Vec3 outward(x[0].x() + x[2].x(), x[0].y() + x[2].y(), 0.0);
    EXPECT_GT(normal.dot(outward), 0.0) << cell;
  }
}

TEST(PolyData, TrianglesAndQuadsOfASurfaceStayApart) {
  Surface surface;
  for (int i = 0; i < 5; ++i) surface.add_point(Vec3(i, i * i, 0.0), Vec3::UnitZ());
  surface.values = {0, 1, 2, 3, 4};
  surface.polygons = {{0, 1, 2, 3}, {2, 3, 4, -1}};
  const auto data = make_poly_data(surface, surface.polygons);
  EXPECT_EQ(data->GetPolys()->GetCellSize(0), 4);
  EXPECT_EQ(data->GetPolys()->GetCellSize(1), 3);
  EXPECT_EQ(data->GetPointData()->GetScalars()->GetComponent(4, 0), 4.0);
}

}  // namespace
}  // namespace hydroscope
