// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/pose.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

/// Quarter turns are exact, so that a tool turned by 90 degrees stays on its grid.
Mat3 make_turn(double degrees, int axis) {
  const double quarters = degrees / 90.0;
  double c = std::cos(degrees * std::numbers::pi / 180.0);
  double s = std::sin(degrees * std::numbers::pi / 180.0);
  if (quarters == std::round(quarters)) {
    c = std::round(c);
    s = std::round(s);
  }
  const int i = (axis + 1) % 3;
  const int j = (axis + 2) % 3;
  Mat3 turn = Mat3::Identity();
  turn(i, i) = c;
  turn(i, j) = -s;
  turn(j, i) = s;
  turn(j, j) = c;
  return turn;
}

}  // namespace

Pose make_pose(const std::array<double, 3>& rotation_deg, const std::array<double, 3>& position) {
  Pose pose;
  pose.rotation =
      make_turn(rotation_deg[2], 2) * make_turn(rotation_deg[1], 1) * make_turn(rotation_deg[0], 0);
  pose.position = Vec3(position[0], position[1], position[2]);
  return pose;
}

Mat3 make_frame(const Vec3& direction) {
  require(direction.norm() > 0.0, "a frame needs a direction that is not zero");
  const Vec3 axis = direction.normalized();
  // The coordinate axis that leans least towards `axis` gives the best conditioned cross product.
  int smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  Mat3 frame;
  frame.col(2) = axis;
  frame.col(0) = Vec3::Unit(smallest).cross(axis).normalized();
  frame.col(1) = axis.cross(frame.col(0));
  return frame;
}

FootPoint place_foot_point(const Pose& pose, FootPoint foot) {
  foot.point = pose.place_point(foot.point);
  foot.normal = pose.place_direction(foot.normal);
  foot.gap_gradient = pose.place_direction(foot.gap_gradient);
  foot.normal_gradient = pose.rotation * foot.normal_gradient * pose.rotation.transpose();
  return foot;
}

void place_mesh(const Pose& pose, TriangleMesh& mesh) {
  for (Vec3& point : mesh.points) point = pose.place_point(point);
}

void flip_mesh(TriangleMesh& mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

}  // namespace hydroscope
