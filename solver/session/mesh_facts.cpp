// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/mesh_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "solver/geometry/mesh_topology.h"
#include "solver/geometry/pose.h"
#include "solver/import/make_tool.h"

namespace hydroscope {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kAlike = 1e-4;     // of the mesh's size: STL has single precision
constexpr double kUpright = 1e-3;   // of a normal along z
constexpr double kFlat = 0.2;       // [deg]: below, two facets are one plane
constexpr double kOutliers = 0.05;  // share of the edges that may bend sharper

/// Height of a facet over one of its edges [mm].
double calc_height(const TriangleMesh& mesh, std::size_t facet, std::size_t edge) {
  const auto corner = [&](std::size_t k) {
    return mesh.points[static_cast<std::size_t>(mesh.triangles[facet][k % 3])];
  };
  const Vec3 along = corner(edge + 2) - corner(edge + 1), to = corner(edge) - corner(edge + 1);
  return along.cross(to).norm() / along.norm();
}

/// Radii along all edges that bend, ascending: the narrower facet's height over the angle [mm].
std::vector<double> list_radii(const TriangleMesh& mesh, const std::vector<Vec3>& normals, double crease,
                               double& facet_angle) {
  const MeshTopology topology = make_topology(mesh);
  std::vector<double> radii;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const MeshTopology::Side& side = topology.sides[f][k];
      if (side.facet <= static_cast<int>(f)) continue;  // open, or seen from the other side
      const auto g = static_cast<std::size_t>(side.facet);
      const double angle = std::acos(std::clamp(normals[f].dot(normals[g]), -1.0, 1.0)) / kDegree;
      if (angle < kFlat || angle > crease) continue;
      const double width =
          std::min(calc_height(mesh, f, k), calc_height(mesh, g, static_cast<std::size_t>(side.edge)));
      radii.push_back(width / (angle * kDegree));
      facet_angle = std::max(facet_angle, angle);
    }
  }
  std::sort(radii.begin(), radii.end());
  return radii;
}

using Cell = std::array<long, 3>;

Cell find_cell(const Vec3& x, double size) {
  return {std::lround(x[0] / size), std::lround(x[1] / size), std::lround(x[2] / size)};
}

bool is_near(const std::set<Cell>& cells, const Cell& at) {
  for (long i = -1; i <= 1; ++i) {
    for (long j = -1; j <= 1; ++j) {
      for (long k = -1; k <= 1; ++k) {
        if (cells.count({at[0] + i, at[1] + j, at[2] + k}) > 0) return true;
      }
    }
  }
  return false;
}

}  // namespace

MeshFacts inspect_mesh(const TriangleMesh& mesh, double crease_angle) {
  MeshFacts facts;
  facts.mesh = mesh;
  const std::vector<Vec3> normals = calc_facet_normals(mesh);
  facts.is_prismatic =
      std::all_of(normals.begin(), normals.end(), [](const Vec3& n) { return std::abs(n.z()) < kUpright; });
  facts.low_z = std::numeric_limits<double>::infinity();
  facts.high_z = -facts.low_z;
  for (const Vec3& x : mesh.points) {
    facts.low_z = std::min(facts.low_z, x.z());
    facts.high_z = std::max(facts.high_z, x.z());
  }
  const std::vector<double> radii = list_radii(mesh, normals, crease_angle, facts.facet_angle);
  if (!radii.empty())
    facts.least_radius = radii[static_cast<std::size_t>(kOutliers * static_cast<double>(radii.size()))];
  return facts;
}

MeshFacts inspect_mesh(const ToolScene& tool, const std::string& name, const std::string& directory) {
  TriangleMesh mesh = read_tool_mesh(find_tool_file(tool, name, directory), tool.unit_scale).mesh;
  place_mesh(make_pose(tool.rotation, tool.position), mesh);
  return inspect_mesh(mesh, tool.crease_angle);
}

bool is_mirrored(const TriangleMesh& mesh, const Vec3& normal) {
  double extent = 0.0;
  for (const Vec3& x : mesh.points) extent = std::max(extent, x.cwiseAbs().maxCoeff());
  const double size = kAlike * std::max(extent, 1e-9);
  std::set<Cell> cells;
  for (const Vec3& x : mesh.points) cells.insert(find_cell(x, size));
  return std::all_of(mesh.points.begin(), mesh.points.end(), [&](const Vec3& x) {
    return is_near(cells, find_cell(x - 2.0 * normal.dot(x) * normal, size));
  });
}

}  // namespace hydroscope
