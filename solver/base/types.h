// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <array>
#include <vector>

namespace hydroscope {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat2 = Eigen::Matrix2d;
using Mat3 = Eigen::Matrix3d;

/// Surface of flat triangles. `points` [mm]; each triangle lists three point
/// indices, counter-clockwise seen from the free (sheet) side of a tool.
struct TriangleMesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Surface of four-node quadrilaterals. `points` [mm]; nodes counter-clockwise
/// seen from outside (g1 x g2 points along the director).
struct QuadMesh {
  std::vector<Vec3> points;
  std::vector<std::array<int, 4>> quads;
};

/// Plane through `point` [mm] with unit `normal`.
struct Plane {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
};

}  // namespace hydroscope
