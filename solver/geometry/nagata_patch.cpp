// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/nagata_patch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hydroscope {

namespace {

constexpr int kIterations = 20;
// Newton squares its error: a step below this leaves nothing but rounding.
constexpr double kLastStep = 1e-9;
constexpr double kEps = 1e-12;  // barycentric: still inside
// The edge's speed changes by twice this part of its chord at most, so that it never turns back.
constexpr double kLargestSkew = 0.4;
// Normals nearer to each other than 0.1 degrees say nothing about a crease's direction.
constexpr double kSameDirection = 2e-3;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Parameter of the point of edge `k` nearest to `x`, from 0 to 1.
double find_edge_parameter(const NagataPatch& patch, int k, const Vec3& x, double start) {
  double s = start;
  for (int i = 0; i < kIterations; ++i) {
    const PatchEdge edge(patch, k, s);
    const Vec3 rest = x - edge.point;
    const double slope = rest.dot(edge.tangent);
    const double speed2 = edge.tangent.squaredNorm();
    // Beyond the edge's focal point the nearest point is an end; without the second term the step goes there.
    const double stiff = std::max(speed2 - rest.dot(edge.second), 0.1 * speed2);
    const double next = std::clamp(s + slope / stiff, 0.0, 1.0);
    const bool is_done = std::abs(next - s) < kLastStep;
    s = next;
    if (is_done) break;
  }
  return s;
}

bool find_inside(const NagataPatch& patch, const Vec3& x, PatchFoot& foot) {
  for (int i = 0; i < kIterations; ++i) {
    const PatchPlace place(patch, foot.l1, foot.l2);
    const Vec3 rest = x - place.point;
    Mat2 stiff;  // of distance^2 / 2
    stiff(0, 0) = place.a.dot(place.a) - rest.dot(place.aa);
    stiff(0, 1) = stiff(1, 0) = place.a.dot(place.b) - rest.dot(place.ab);
    stiff(1, 1) = place.b.dot(place.b) - rest.dot(place.bb);
    const double det = stiff.determinant();
    if (!(det > 0.0) || !(stiff(0, 0) > 0.0)) return false;
    const Vec2 slope(rest.dot(place.a), rest.dot(place.b));
    const double d1 = (stiff(1, 1) * slope[0] - stiff(0, 1) * slope[1]) / det;
    const double d2 = (stiff(0, 0) * slope[1] - stiff(0, 1) * slope[0]) / det;
    foot.l1 += d1;
    foot.l2 += d2;
    if (std::abs(foot.l1) > 3.0 || std::abs(foot.l2) > 3.0) return false;
    if (std::abs(d1) > kLastStep || std::abs(d2) > kLastStep) continue;
    if (std::min(std::min(foot.l1, foot.l2), 1.0 - foot.l1 - foot.l2) < -kEps) return false;
    foot.distance2 = (x - PatchPlace(patch, foot.l1, foot.l2).point).squaredNorm();
    return true;
  }
  return false;
}

}  // namespace

Vec3 calc_edge_bend(const Vec3& chord, const Vec3& n0, const Vec3& n1) {
  // n0 . (chord - bend) = 0 and n1 . (chord + bend) = 0, by sum and difference of the normals.
  const Vec3 sum = n0 + n1;
  const Vec3 difference = n0 - n1;
  const Vec3 bend = difference.dot(chord) / sum.squaredNorm() * sum;
  const double skew = std::abs(sum.dot(chord));
  const double turn = difference.norm();
  if (skew > kLargestSkew * turn * chord.norm() || !(turn > 0.0)) return bend;
  return bend + sum.dot(chord) / (turn * turn) * difference;
}

Vec3 calc_crease_bend(const Vec3& chord, const std::array<Vec3, 2>& n0, const std::array<Vec3, 2>& n1) {
  Mat3 normal_matrix = Mat3::Zero();
  Vec3 right = Vec3::Zero();
  for (std::size_t side = 0; side < 2; ++side) {
    normal_matrix += n0[side] * n0[side].transpose() + n1[side] * n1[side].transpose();
    right += n0[side] * n0[side].dot(chord) - n1[side] * n1[side].dot(chord);
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> modes(normal_matrix);
  Vec3 bend = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const double strength = modes.eigenvalues()[i];
    if (strength < kSameDirection * modes.eigenvalues()[2]) continue;  // a squared singular value
    const Vec3 mode = modes.eigenvectors().col(i);
    bend += mode.dot(right) / strength * mode;
  }
  const double largest = kLargestSkew * chord.norm();
  return bend.norm() > largest ? Vec3(Vec3::Zero()) : bend;
}

PatchPlace::PatchPlace(const NagataPatch& patch, double l1, double l2) {
  const double l3 = 1.0 - l1 - l2;
  const auto& x = patch.x;
  const auto& c = patch.bend;
  point = l1 * x[0] + l2 * x[1] + l3 * x[2] - l2 * l3 * c[0] - l3 * l1 * c[1] - l1 * l2 * c[2];
  a = x[0] - x[2] + l2 * c[0] - (l3 - l1) * c[1] - l2 * c[2];
  b = x[1] - x[2] - (l3 - l2) * c[0] + l1 * c[1] - l1 * c[2];
  aa = 2.0 * c[1];
  bb = 2.0 * c[0];
  ab = c[0] + c[1] - c[2];
  normal = a.cross(b).normalized();
}

Mat3 PatchPlace::calc_normal_gradient(double gap) const {
  Mat2 first, second;  // fundamental forms
  first << a.dot(a), a.dot(b), a.dot(b), b.dot(b);
  second << normal.dot(aa), normal.dot(ab), normal.dot(ab), normal.dot(bb);
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << a, b;
  // From (x - X) . dX/dl = 0: (first - gap second) dl = tangents^T dx; dn = -tangents first^-1 second dl.
  const Mat2 turn = first.inverse() * second * (first - gap * second).inverse();
  const Mat3 gradient = -tangents * turn * tangents.transpose();
  return 0.5 * (gradient + gradient.transpose());  // symmetric but for rounding
}

PatchEdge::PatchEdge(const NagataPatch& patch, int k, double s) {
  const Vec3& from = patch.x[at((k + 1) % 3)];
  const Vec3 chord = patch.x[at((k + 2) % 3)] - from;
  const Vec3& bend = patch.bend[at(k)];
  point = from + s * chord - s * (1.0 - s) * bend;
  tangent = chord - (1.0 - 2.0 * s) * bend;
  second = 2.0 * bend;
}

std::array<double, 2> place_on_edge(int k, double s) {
  std::array<double, 3> l{};
  l[at((k + 1) % 3)] = 1.0 - s;
  l[at((k + 2) % 3)] = s;
  return {l[0], l[1]};
}

double read_edge_parameter(int k, double l1, double l2) {
  const std::array<double, 3> l{l1, l2, 1.0 - l1 - l2};
  return l[at((k + 2) % 3)];
}

PatchFoot find_closest_on_patch(const NagataPatch& patch, const Vec3& x, double l1, double l2) {
  PatchFoot foot;
  foot.l1 = l1;
  foot.l2 = l2;
  if (find_inside(patch, x, foot)) return foot;
  foot.distance2 = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const double s = find_edge_parameter(patch, k, x, std::clamp(read_edge_parameter(k, l1, l2), 0.0, 1.0));
    const double distance2 = (x - PatchEdge(patch, k, s).point).squaredNorm();
    if (!(distance2 < foot.distance2)) continue;
    const auto l = place_on_edge(k, s);
    const int corner = s <= 0.0 ? (k + 1) % 3 : s >= 1.0 ? (k + 2) % 3 : -1;
    foot = {l[0], l[1], distance2, corner < 0 ? k : -1, corner};
  }
  return foot;
}

}  // namespace hydroscope
