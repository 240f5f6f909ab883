// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/poly_data.h"

#include <vtkCellArray.h>          // VTK::CommonDataModel
#include <vtkDoubleArray.h>        // VTK::CommonCore
#include <vtkFloatArray.h>         // VTK::CommonCore
#include <vtkIntArray.h>           // VTK::CommonCore
#include <vtkNew.h>                // VTK::CommonCore
#include <vtkPointData.h>          // VTK::CommonDataModel
#include <vtkPoints.h>             // VTK::CommonCore
#include <vtkPolyData.h>           // VTK::CommonDataModel
#include <vtkUnsignedCharArray.h>  // VTK::CommonCore

#include <cstring>

#include "render/shape/sheet_shape.h"

namespace hydroscope {
namespace {

vtkIdType count_of(const auto& values) { return static_cast<vtkIdType>(values.size()); }

/// Copies packed triples into a VTK array in one go.
template <typename Array, typename T>
vtkSmartPointer<Array> make_triples(const std::vector<T>& values, const char* name) {
  static_assert(sizeof(T) == 3 * sizeof(typename Array::ValueType), "triples lie without gaps");
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(count_of(values));
  if (!values.empty()) std::memcpy(array->GetPointer(0), values.data(), values.size() * sizeof(T));
  return array;
}

vtkSmartPointer<vtkPolyData> make_points(const std::vector<Vec3f>& values) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  const vtkNew<vtkPoints> points;
  points->SetData(make_triples<vtkFloatArray>(values, "points"));
  data->SetPoints(points);
  return data;
}

void add_scalars(vtkPolyData& data, const Snapshot& s, std::size_t copies) {
  const auto add = [&](const char* name, const auto& value_of) {
    const vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (std::size_t copy = 0; copy < copies; ++copy)
      for (std::size_t node = 0; node < s.points.size(); ++node) array->InsertNextValue(value_of(node));
    data.GetPointData()->AddArray(array);
  };
  add("thickness_mm", [&](std::size_t i) { return s.thickness[i]; });
  add("plastic_strain", [&](std::size_t i) { return s.plastic_strain[i]; });
  add("gap_mm", [&](std::size_t i) { return s.gap[i]; });
  add("contact_pressure_MPa", [&](std::size_t i) { return s.contact_pressure[i]; });
  const vtkNew<vtkIntArray> states, ids;
  states->SetName("contact_state");
  ids->SetName("node_id");
  for (std::size_t copy = 0; copy < copies; ++copy)
    for (std::size_t node = 0; node < s.points.size(); ++node) {
      states->InsertNextValue(static_cast<int>(s.contact_state[node]));
      ids->InsertNextValue(static_cast<int>(node));
    }
  data.GetPointData()->AddArray(states);
  data.GetPointData()->AddArray(ids);
}

void add_vectors(vtkPolyData& data, const char* name, const std::vector<Vec3>& values,
                 const std::vector<Reflection>& reflections) {
  std::vector<Vec3> all;
  for (const Reflection& reflection : reflections)
    for (const Vec3& v : values) all.push_back(reflection.vector(v));
  data.GetPointData()->AddArray(make_triples<vtkDoubleArray>(all, name));
}

}  // namespace

vtkSmartPointer<vtkPolyData> make_poly_data(const Surface& surface,
                                            const std::vector<std::array<int, 4>>& polygons_wanted) {
  auto data = make_points(surface.points);
  auto normals = make_triples<vtkFloatArray>(surface.normals, "Normals");
  data->GetPointData()->SetNormals(normals);
  const vtkNew<vtkCellArray> polygons;
  polygons->AllocateEstimate(count_of(polygons_wanted), 4);
  for (const auto& polygon : polygons_wanted) {
    const vtkIdType ids[4] = {polygon[0], polygon[1], polygon[2], polygon[3]};
    polygons->InsertNextCell(polygon[3] < 0 ? 3 : 4, ids);
  }
  data->SetPolys(polygons);
  if (!surface.colours.empty())
    data->GetPointData()->SetScalars(make_triples<vtkUnsignedCharArray>(surface.colours, "colour"));
  if (!surface.values.empty()) {
    const vtkNew<vtkFloatArray> values;
    values->SetName("value");
    values->SetNumberOfValues(count_of(surface.values));
    std::memcpy(values->GetPointer(0), surface.values.data(), surface.values.size() * sizeof(float));
    data->GetPointData()->SetScalars(values);
  }
  return data;
}

vtkSmartPointer<vtkPolyData> make_poly_data(const LineSet& lines) {
  auto data = make_points(lines.points);
  const vtkNew<vtkCellArray> cells;
  cells->AllocateEstimate(count_of(lines.lines), 2);
  for (const auto& line : lines.lines) {
    const vtkIdType ids[2] = {line[0], line[1]};
    cells->InsertNextCell(2, ids);
  }
  data->SetLines(cells);
  return data;
}

vtkSmartPointer<vtkPolyData> make_poly_data(const Snapshot& snapshot, bool is_mirrored) {
  check_snapshot(snapshot);
  const auto reflections = calc_reflections(is_mirrored ? snapshot.model->mirrors : std::vector<Plane>{});
  Surface mid_surface;
  for (const Vec3& x : snapshot.points) mid_surface.add_point(x, Vec3::UnitZ());
  mid_surface.polygons = snapshot.model->quads;
  for (std::size_t i = 0; i < snapshot.points.size(); ++i)
    mid_surface.normals[i] = snapshot.directors[i].cast<float>();
  const Surface whole = calc_reflected(mid_surface, reflections);
  auto data = make_poly_data(whole, whole.polygons);
  add_scalars(*data, snapshot, reflections.size());
  add_vectors(*data, "contact_force_N", snapshot.contact_force, reflections);
  add_vectors(*data, "tool_normal", snapshot.tool_normal, reflections);
  add_vectors(*data, "slip_mm", snapshot.slip, reflections);
  add_vectors(*data, "slip_increment_mm", snapshot.slip_increment, reflections);
  return data;
}

}  // namespace hydroscope
