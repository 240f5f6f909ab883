// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/shape/clip_mesh.h"

#include <cmath>
#include <map>
#include <utility>

namespace hydroscope {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

class Clipper {
 public:
  Clipper(TriangleMesh& mesh, std::vector<Vec3>& normals, const Plane& plane, double tolerance)
      : mesh_(mesh), normals_(normals) {
    for (const Vec3& x : mesh.points) {
      const double s = plane.normal.dot(x - plane.point);
      distance_.push_back(std::abs(s) < tolerance ? 0.0 : s);
    }
  }

  void clip() {
    std::vector<std::array<int, 3>> kept;
    for (const auto& facet : mesh_.triangles) {
      std::vector<int> polygon;
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = facet[k], b = facet[(k + 1) % 3];
        if (distance_[at(a)] <= 0.0) polygon.push_back(a);
        if (distance_[at(a)] * distance_[at(b)] < 0.0) polygon.push_back(find_cut_point(a, b));
      }
      for (std::size_t k = 2; k < polygon.size(); ++k)
        kept.push_back({polygon[0], polygon[k - 1], polygon[k]});
    }
    mesh_.triangles = std::move(kept);
    drop_unused_points();
  }

 private:
  int find_cut_point(int a, int b) {
    // From the same end on both sides of an edge, so that neighbours share the point exactly.
    const auto [low, high] = std::minmax(a, b);
    const auto [place, is_new] = cut_points_.try_emplace({low, high}, static_cast<int>(mesh_.points.size()));
    if (is_new) {
      const double w = distance_[at(low)] / (distance_[at(low)] - distance_[at(high)]);
      mesh_.points.push_back((1.0 - w) * mesh_.points[at(low)] + w * mesh_.points[at(high)]);
      const Vec3 normal = (1.0 - w) * normals_[at(low)] + w * normals_[at(high)];
      normals_.push_back(normal.norm() > 0.0 ? Vec3(normal.normalized()) : normals_[at(low)]);
    }
    return place->second;
  }

  void drop_unused_points() {
    std::vector<int> new_index(mesh_.points.size(), -1);
    std::vector<Vec3> points, normals;
    for (auto& facet : mesh_.triangles)
      for (int& point : facet) {
        int& index = new_index[at(point)];
        if (index < 0) {
          index = static_cast<int>(points.size());
          points.push_back(mesh_.points[at(point)]);
          normals.push_back(normals_[at(point)]);
        }
        point = index;
      }
    mesh_.points = std::move(points);
    normals_ = std::move(normals);
  }

  TriangleMesh& mesh_;
  std::vector<Vec3>& normals_;
  std::vector<double> distance_;  ///< of the given points
  std::map<std::pair<int, int>, int> cut_points_;
};

}  // namespace

void clip_mesh(TriangleMesh& mesh, std::vector<Vec3>& normals, const Plane& plane, double tolerance) {
  Clipper(mesh, normals, plane, tolerance).clip();
}

}  // namespace hydroscope
