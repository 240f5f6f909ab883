// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/tool_shape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "render/shape/clip_mesh.h"
#include "render/shape/sheet_shape.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

Bounds calc_mesh_bounds(const TriangleMesh& mesh) {
  Bounds bounds;
  for (const Vec3& x : mesh.points) bounds.include(x);
  return bounds;
}

}  // namespace

double calc_angle(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::numbers::pi;
}

ToolShape::ToolShape(const SnapshotModel::Tool& tool, const std::vector<Plane>& mirrors)
    : mesh_(tool.mesh), normals_(tool.normals) {
  if (normals_.size() != mesh_.points.size())
    throw ContractError("tool '" + tool.name + "': one normal a point is needed");
  for (const auto& facet : mesh_.triangles)
    for (int point : facet)
      if (point < 0 || at(point) >= mesh_.points.size())
        throw ContractError("tool '" + tool.name + "': a facet names a point that is not there");
  const double size = mesh_.points.empty() ? 0.0 : calc_mesh_bounds(mesh_).diagonal();
  const std::vector<Plane> open_mirrors = find_open_mirrors(mirrors, mesh_.points);
  for (const Plane& plane : open_mirrors) clip_mesh(mesh_, normals_, plane, 1e-4 * size);
  reflections_ = calc_reflections(open_mirrors);
  for (const auto& facet : mesh_.triangles) {
    const Vec3& x0 = mesh_.points[at(facet[0])];
    const Vec3 area = (mesh_.points[at(facet[1])] - x0).cross(mesh_.points[at(facet[2])] - x0);
    facet_normals_.push_back(area.norm() > 0.0 ? Vec3(area.normalized()) : normals_[at(facet[0])]);
  }
  for (double angle : calc_facet_angles()) largest_angle_ = std::max(largest_angle_, angle);
  find_edges(open_mirrors, 1e-4 * size);
}

void ToolShape::find_edges(const std::vector<Plane>& seams, double tolerance) {
  const auto is_on_seam = [&](int a, int b) {
    return std::any_of(seams.begin(), seams.end(), [&](const Plane& plane) {
      const auto distance = [&](int i) {
        return std::abs(plane.normal.dot(mesh_.points[at(i)] - plane.point));
      };
      return distance(a) < tolerance && distance(b) < tolerance;
    });
  };
  std::map<std::pair<int, int>, std::vector<std::size_t>> owners;
  for (std::size_t f = 0; f < mesh_.triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k)
      owners[std::minmax(mesh_.triangles[f][k], mesh_.triangles[f][(k + 1) % 3])].push_back(f);
  for (const auto& [nodes, facets] : owners) {
    edges_.push_back({nodes.first, nodes.second});
    const bool is_sharp =
        facets.size() != 2 || calc_angle(facet_normals_[facets[0]], facet_normals_[facets[1]]) > kCrease;
    // A seam between two mirrored copies is no edge of the tool.
    if (is_sharp && !is_on_seam(nodes.first, nodes.second)) sharp_edges_.push_back(edges_.back());
  }
}

double ToolShape::corner_angle(std::size_t facet, std::size_t corner) const {
  return calc_angle(facet_normals_[facet], normals_[at(mesh_.triangles[facet][corner])]);
}

std::vector<double> ToolShape::calc_facet_angles() const {
  std::vector<double> angles;
  for (std::size_t f = 0; f < mesh_.triangles.size(); ++f)
    angles.push_back(std::max({corner_angle(f, 0), corner_angle(f, 1), corner_angle(f, 2)}));
  return angles;
}

std::vector<Vec3> ToolShape::calc_facet_centres() const {
  std::vector<Vec3> centres;
  for (const auto& facet : mesh_.triangles)
    centres.push_back((mesh_.points[at(facet[0])] + mesh_.points[at(facet[1])] + mesh_.points[at(facet[2])]) /
                      3.0);
  return centres;
}

double ToolShape::calc_facet_area(std::size_t facet) const {
  const auto x = [&](std::size_t k) { return mesh_.points[at(mesh_.triangles[facet][k])]; };
  return 0.5 * (x(1) - x(0)).cross(x(2) - x(0)).norm();
}

Surface ToolShape::make_surface(const Vec3& translation, double set_back) const {
  Surface piece;
  for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
    std::array<int, 4> polygon{-1, -1, -1, -1};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t point = at(mesh_.triangles[f][k]);
      const double angle = corner_angle(f, k);
      polygon[k] = piece.add_point(mesh_.points[point] + translation - set_back * normals_[point],
                                   angle > kCrease ? facet_normals_[f] : normals_[point]);
      piece.values.push_back(static_cast<float>(angle));
    }
    piece.polygons.push_back(polygon);
  }
  return calc_reflected(piece, reflections_);
}

LineSet ToolShape::make_edges(const Vec3& translation) const {
  LineSet piece;
  for (const auto& edge : sharp_edges_)
    piece.add_line(mesh_.points[at(edge[0])] + translation, mesh_.points[at(edge[1])] + translation);
  return calc_reflected(piece, reflections_);
}

LineSet ToolShape::make_facet_edges(const Vec3& translation) const {
  LineSet piece;
  for (const auto& edge : edges_)
    piece.add_line(mesh_.points[at(edge[0])] + translation, mesh_.points[at(edge[1])] + translation);
  return calc_reflected(piece, reflections_);
}

LineSet ToolShape::make_section(const Vec3& translation, const Plane& plane) const {
  LineSet section;
  for (const Reflection& reflection : reflections_) {
    for (const auto& facet : mesh_.triangles) {
      std::array<Vec3, 3> x;
      std::array<double, 3> s;
      for (std::size_t k = 0; k < 3; ++k) {
        x[k] = reflection.point(mesh_.points[at(facet[k])] + translation);
        s[k] = plane.normal.dot(x[k] - plane.point);
      }
      std::array<Vec3, 3> hits;
      std::size_t count = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        // Half-open, so that a corner in the plane is hit once, not twice.
        if ((s[k] < 0.0) != (s[next] < 0.0))
          hits[count++] = x[k] + s[k] / (s[k] - s[next]) * (x[next] - x[k]);
      }
      if (count == 2) section.add_line(hits[0], hits[1]);
    }
  }
  return section;
}

}  // namespace hydroscope
