// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/sheet_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "solver/base/error.h"
#include "solver/session/vtu_file.h"

namespace hydroscope {

namespace {

std::set<int> find_border(const QuadMesh& mesh) {
  std::map<std::pair<int, int>, int> count;
  for (const auto& quad : mesh.quads) {
    for (std::size_t a = 0; a < 4; ++a) ++count[std::minmax(quad[a], quad[(a + 1) % 4])];
  }
  std::set<int> border;
  for (const auto& [edge, faces] : count) {
    if (faces == 1) border.insert({edge.first, edge.second});
  }
  return border;
}

void add_directors(SheetMesh& m) {
  m.directors.assign(m.mesh.points.size(), Vec3::Zero());
  double outward = 0.0;
  for (const auto& quad : m.mesh.quads) {
    std::array<Vec3, 4> x;
    for (std::size_t a = 0; a < 4; ++a) x[a] = m.mesh.points[static_cast<std::size_t>(quad[a])];
    const Vec3 normal = (x[2] - x[0]).cross(x[3] - x[1]);
    outward += normal.head<2>().dot((x[0] + x[2]).head<2>());
    for (const int i : quad) m.directors[static_cast<std::size_t>(i)] += normal;
  }
  for (auto& quad : m.mesh.quads) {
    if (outward < 0.0) std::swap(quad[1], quad[3]);
  }
  for (Vec3& d : m.directors) d = (outward < 0.0 ? -d : d).normalized();
}

}  // namespace

SheetMesh read_sheet_mesh(const Scene& scene) {
  const std::string file = (std::filesystem::path(scene.directory) / scene.mesh.file).string();
  SheetMesh m;
  m.mesh = read_vtu_quads(file);
  for (Vec3& x : m.mesh.points) x *= scene.mesh.unit_scale;
  if (m.mesh.quads.size() < 2) throw InputError(file + ": a mesh of one element; expected at least two");
  add_directors(m);
  const std::set<int> border = find_border(m.mesh);
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Vec3& x : m.mesh.points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  const double tolerance = 1e-6 * (high - low).norm();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(low[axis]) > tolerance) continue;  // the mesh does not begin at this plane
    SheetMesh::SymmetryPlane plane{Vec3::Unit(axis), {}};
    for (const int i : border) {
      Vec3& x = m.mesh.points[static_cast<std::size_t>(i)];
      Vec3& d = m.directors[static_cast<std::size_t>(i)];
      if (std::abs(x[axis]) > tolerance) continue;
      x[axis] = d[axis] = 0.0;
      d.normalize();
      plane.nodes.push_back(i);
    }
    if (plane.nodes.empty()) continue;
    m.symmetry.push_back(plane);
    m.mirrors.push_back({Vec3::Zero(), -Vec3::Unit(axis)});
  }
  const bool is_half = std::abs(low[2]) <= tolerance;
  for (const int i : border) {
    const double z = m.mesh.points[static_cast<std::size_t>(i)][2];
    if (std::abs(z - high[2]) <= tolerance) m.end_nodes.push_back(i);
    if (!is_half && std::abs(z - low[2]) <= tolerance) m.start_nodes.push_back(i);
  }
  m.width = high[2] - low[2];
  return m;
}

}  // namespace hydroscope
