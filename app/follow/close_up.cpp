// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/follow/close_up.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace hydroscope {
namespace {

// Of the picture's width and height, what the patch takes: title and legend stand beside it.
constexpr double kWidth = 0.62, kHeight = 0.55;
// By how much of them its middle lies left of and below the picture's.
constexpr double kLeft = 0.10, kBelow = 0.05;
constexpr double kLeastHeight = 6.0;  // half height of the picture in wall thicknesses
constexpr double kAbove = 0.42;       // sine of the angle between line of sight and tangent plane
constexpr double kAside = 0.22;       // the same to the side: for depth

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// From the sheet to the tool; where a node does not touch, out of the face that the others touch with.
class Sides {
 public:
  Sides(const Snapshot& snapshot, const std::vector<int>& nodes) : snapshot_(snapshot) {
    double sum = 0.0;
    for (const int node : nodes) sum -= snapshot.tool_normal[at(node)].dot(snapshot.directors[at(node)]);
    if (sum < 0.0) face_ = -1.0;
  }
  Vec3 find_outward(int node) const {
    const Vec3& n = snapshot_.tool_normal[at(node)];
    return n.norm() > 0.5 ? Vec3(-n) : Vec3(face_ * snapshot_.directors[at(node)]);
  }
  Vec3 find_place(int node) const {
    return snapshot_.points[at(node)] +
           0.5 * face_ * snapshot_.thickness[at(node)] * snapshot_.directors[at(node)];
  }

 private:
  const Snapshot& snapshot_;
  double face_ = 1.0;  ///< +1: the outer face, -1: the inner one
};

/// Least and greatest of the patch along a direction.
std::array<double, 2> calc_extent(const Snapshot& s, const std::vector<int>& nodes, const Vec3& direction) {
  const Sides sides(s, nodes);
  std::array<double, 2> extent{1e300, -1e300};
  for (const int node : nodes) {
    const double place = direction.dot(sides.find_place(node));
    extent = {std::min(extent[0], place), std::max(extent[1], place)};
  }
  return extent;
}

double calc_thickness(const Snapshot& s, const std::vector<int>& nodes) {
  double sum = 0.0;
  for (const int node : nodes) sum += s.thickness[at(node)];
  return sum / static_cast<double>(nodes.size());
}

double calc_longest_edge(const Snapshot& s, const std::vector<int>& nodes) {
  std::vector<char> is_in(s.points.size(), 0);
  for (const int node : nodes) is_in[at(node)] = 1;
  double longest = 0.0;
  for (const auto& quad : s.model->quads)
    for (std::size_t k = 0; k < 4; ++k)
      if (is_in[at(quad[k])] != 0)
        longest = std::max(longest, (s.points[at(quad[(k + 1) % 4])] - s.points[at(quad[k])]).norm());
  return longest;
}

}  // namespace

PatchAxes find_patch_axes(const Snapshot& before, const std::vector<int>& nodes, int node,
                          const Vec3& towards_viewer) {
  PatchAxes axes;
  const Sides sides(before, nodes);
  Vec3 mean = Vec3::Zero();
  for (const int k : nodes) mean += sides.find_outward(k) / static_cast<double>(nodes.size());
  axes.outward = mean.norm() > 0.3 ? mean.normalized() : sides.find_outward(node).normalized();
  Mat3 spread = Mat3::Zero();
  std::vector<char> is_in(before.points.size(), 0);
  for (const int k : nodes) is_in[at(k)] = 1;
  // With their neighbours, so that one node has a direction, too.
  for (const auto& quad : before.model->quads) {
    if (std::none_of(quad.begin(), quad.end(), [&](int k) { return is_in[at(k)] != 0; })) continue;
    for (const int k : quad) {
      const Vec3 turn = before.directors[at(k)] - before.directors[at(quad[0])];
      spread += turn * turn.transpose();
    }
  }
  const Mat3 tangent = Mat3::Identity() - axes.outward * axes.outward.transpose();
  const Mat3 in_plane = tangent * spread * tangent;
  Vec3 along = tangent * towards_viewer;
  if (along.norm() < 0.05) along = axes.outward.unitOrthogonal();
  if (in_plane.norm() > 1e-9) {
    // The normal itself must not count as the direction without bending.
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(in_plane + 10.0 * in_plane.norm() * axes.outward *
                                                                    axes.outward.transpose());
    const Vec3 least = solver.eigenvectors().col(0);
    along = least.dot(along) >= 0.0 ? least : Vec3(-least);
  }
  axes.along = (tangent * along).normalized();
  axes.across = axes.outward.cross(axes.along);
  return axes;
}

CloseUp aim_at_patch(const Snapshot& before, const std::vector<int>& nodes, int node, const PatchAxes& axes,
                     double aspect, double zoom) {
  CloseUp close;
  const Vec3 direction = (std::sqrt(1.0 - kAbove * kAbove - kAside * kAside) * axes.along +
                          kAbove * axes.outward + kAside * axes.across)
                             .normalized();
  close.pose.up = axes.outward;
  const Vec3 right = close.pose.up.cross(direction).normalized(), upright = direction.cross(right);
  const auto width = calc_extent(before, nodes, right), height = calc_extent(before, nodes, upright),
             depth = calc_extent(before, nodes, direction);
  Vec3 middle = 0.5 * ((width[0] + width[1]) * right + (height[0] + height[1]) * upright +
                       (depth[0] + depth[1]) * direction);
  if (zoom > 1.0) middle = Sides(before, nodes).find_place(node);
  close.pose.scale =
      std::max({0.5 * (height[1] - height[0]) / kHeight, 0.5 * (width[1] - width[0]) / (kWidth * aspect),
                kLeastHeight * calc_thickness(before, nodes)}) /
      zoom;
  close.pose.focal = middle + 2.0 * close.pose.scale * (kLeft * aspect * right + kBelow * upright);
  for (const int k : nodes) close.bounds.include(Sides(before, nodes).find_place(k));
  close.pose.position =
      close.pose.focal + 4.0 * std::max(close.bounds.diagonal(), close.pose.scale) * direction;
  close.cut = {middle, axes.along};
  return close;
}

std::shared_ptr<const SnapshotModel> crop_to_patch(const Snapshot& before, const std::vector<int>& nodes,
                                                   const PatchAxes& axes, const CloseUp& close_up,
                                                   double aspect) {
  const double edge = calc_longest_edge(before, nodes), scale = close_up.pose.scale;
  const auto take = [&](const Vec3& axis, double margin) {
    auto extent = calc_extent(before, nodes, axis);
    return std::array<double, 2>{extent[0] - margin, extent[1] + margin};
  };
  const std::array<Vec3, 3> directions{axes.along, axes.across, axes.outward};
  const std::array<std::array<double, 2>, 3> box{take(axes.along, 2.5 * edge),
                                                 take(axes.across, 1.2 * scale * aspect + edge),
                                                 take(axes.outward, 1.5 * scale + edge)};
  const auto is_near = [&](int node) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double place = directions[k].dot(before.points[at(node)]);
      if (place < box[k][0] || place > box[k][1]) return false;
    }
    return true;
  };
  auto cropped = std::make_shared<SnapshotModel>(*before.model);
  std::erase_if(cropped->quads,
                [&](const auto& quad) { return std::none_of(quad.begin(), quad.end(), is_near); });
  return cropped;
}

}  // namespace hydroscope
