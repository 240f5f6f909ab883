// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/facet_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "solver/geometry/closest_point.h"

namespace hydroscope {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Vec3 calc_area_vector(const TriangleMesh& mesh, const std::array<int, 3>& facet) {
  const Vec3& a = mesh.points[at(facet[0])];
  return 0.5 * (mesh.points[at(facet[1])] - a).cross(mesh.points[at(facet[2])] - a);
}

}  // namespace

ToolForm find_tool_form(const std::string& shape, const std::string& surface) {
  if (shape == "points") return ToolForm::kOther;
  if (shape != "mesh") return ToolForm::kExact;
  if (surface == "facets" || surface == "quads") return ToolForm::kFlat;
  return surface == "smooth" || surface == "nagata" ? ToolForm::kBent : ToolForm::kOther;
}

FacetTool::FacetTool(TriangleMesh mesh, ToolForm form, double crease_angle)
    : form_(form), mesh_(std::move(mesh)), bends_(mesh_.triangles.size()) {
  if (form_ == ToolForm::kExact || form_ == ToolForm::kOther) return;
  std::map<std::pair<int, int>, std::vector<std::size_t>> edges;
  for (std::size_t f = 0; f < mesh_.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      edges[std::minmax(mesh_.triangles[f][k], mesh_.triangles[f][(k + 1) % 3])].push_back(f);
  for (const auto& [edge, facets] : edges) {
    if (facets.size() != 2) continue;
    const Vec3 a = calc_area_vector(mesh_, mesh_.triangles[facets[0]]);
    const Vec3 b = calc_area_vector(mesh_, mesh_.triangles[facets[1]]);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    const double length = (mesh_.points[at(edge.second)] - mesh_.points[at(edge.first)]).norm();
    if (!(angle <= crease_angle * kDegree) || !(length > 0.0)) continue;
    const Bend bend{angle, (a.norm() + b.norm()) / length};  // mean of the two heights, 2 area / length
    for (const std::size_t f : facets)
      if (bend.angle > bends_[f].angle) bends_[f] = bend;
  }
}

std::size_t FacetTool::find_nearest(const Vec3& x) const {
  std::vector<double> distance2;
  for (const auto& facet : mesh_.triangles)
    distance2.push_back(find_closest_point(x, mesh_.points[at(facet[0])], mesh_.points[at(facet[1])],
                                           mesh_.points[at(facet[2])])
                            .distance2);
  const auto least = std::min_element(distance2.begin(), distance2.end());
  auto nearest = static_cast<std::size_t>(least - distance2.begin());
  // On an edge both facets are equally near: the more bent one says more.
  const double near = *least * (1.0 + 1e-9) + 1e-18;
  for (std::size_t f = 0; f < distance2.size(); ++f)
    if (distance2[f] <= near && bends_[f].angle > bends_[nearest].angle) nearest = f;
  return nearest;
}

FacetNoise FacetTool::estimate(const Vec3& x, double thickness, double modulus) const {
  FacetNoise noise;
  if (form_ == ToolForm::kExact) return {0.0, 0.0, 0.0};
  if (form_ == ToolForm::kOther || mesh_.triangles.empty()) return noise;
  const Bend& bend = bends_[find_nearest(x)];
  noise.angle = bend.angle / kDegree;
  if (bend.angle == 0.0) return {0.0, 0.0, 0.0};
  const double radius = bend.width / bend.angle, square = bend.angle * bend.angle;
  const double sagitta = form_ == ToolForm::kFlat ? square / 8.0 : square * square / 128.0;  // over R
  noise.pressure = modulus * thickness / radius * sagitta;
  noise.sagitta = radius * sagitta;
  return noise;
}

}  // namespace hydroscope
