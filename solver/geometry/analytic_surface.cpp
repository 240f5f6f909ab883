// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/geometry/analytic_surface.h"

#include <cmath>
#include <numbers>

#include "solver/base/error.h"
#include "solver/geometry/grid_mesh.h"

namespace hydroscope {

namespace {

// Nearer than this part of the radius to the centre there is no direction to trust.
constexpr double kCentre = 1e-9;

/// Foot point on a surface round about `centre`: `spoke` = x - centre without its part along the
/// surface's straight direction; `straight` that unit direction, or zero for a round of both ways.
FootPoint make_round_foot(const Vec3& x, const Vec3& spoke, const Vec3& straight, double radius, Side side) {
  const double sign = side == Side::outside ? 1.0 : -1.0;
  const double distance = spoke.norm();
  FootPoint foot;
  const bool is_centre = distance <= kCentre * radius;
  const Vec3 out = is_centre ? Vec3(make_frame(straight).col(0)) : Vec3(spoke / distance);
  foot.normal = foot.gap_gradient = sign * out;
  foot.gap = sign * (distance - radius);
  foot.point = x - foot.gap * foot.normal;
  if (is_centre) return foot;
  const Mat3 around = Mat3::Identity() - out * out.transpose() - straight * straight.transpose();
  foot.normal_gradient = sign / distance * around;  // + convex, - concave
  return foot;
}

}  // namespace

std::optional<FootPoint> AnalyticSurface::find_foot_point(const Vec3& x, double band, double depth,
                                                          SearchHint& hint) const {
  const FootPoint foot = locate(pose_.take_back(x));
  hint.position = x;
  hint.clearance = std::abs(foot.gap);
  hint.facet = foot.facet;
  if (foot.gap > band || foot.gap < -depth) return std::nullopt;
  return place_foot_point(pose_, foot);
}

void AnalyticSurface::set_display_mesh(TriangleMesh mesh) {
  display_normals_.clear();
  for (const Vec3& point : mesh.points)
    display_normals_.push_back(pose_.place_direction(locate(point).normal));
  place_mesh(pose_, mesh);
  display_mesh_ = std::move(mesh);
}

PlaneSurface::PlaneSurface(const Pose& pose, double extent) : AnalyticSurface(pose) {
  std::vector<Vec2> line;
  for (int i = 0; i <= 20; ++i) line.emplace_back(extent * (0.1 * i - 1.0), 0.0);
  set_display_mesh(make_grid_mesh(21, 21, [&](int i, int j) {
    return Vec3(line[static_cast<std::size_t>(i)].x(), line[static_cast<std::size_t>(j)].x(), 0.0);
  }));
}

FootPoint PlaneSurface::locate(const Vec3& x) const {
  FootPoint foot;
  foot.gap = x.z();
  foot.point = Vec3(x.x(), x.y(), 0.0);
  foot.facet = 0;
  return foot;
}

CylinderSurface::CylinderSurface(const Pose& pose, double radius, Side side, double extent)
    : AnalyticSurface(pose), radius_(radius), side_(side) {
  require(radius > 0.0, "a cylinder needs a radius");
  TriangleMesh mesh = make_grid_mesh(181, 13, [&](int i, int j) {
    const double angle = 2.0 * std::numbers::pi * (i % 180) / 180.0;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), extent * (j / 6.0 - 1.0));
  });
  if (side == Side::inside) flip_mesh(mesh);
  set_display_mesh(std::move(mesh));
}

FootPoint CylinderSurface::locate(const Vec3& x) const {
  FootPoint foot = make_round_foot(x, Vec3(x.x(), x.y(), 0.0), Vec3::UnitZ(), radius_, side_);
  foot.facet = 0;
  return foot;
}

RoundedBoxSurface::RoundedBoxSurface(const Pose& pose, const Section& section, Side side, double extent)
    : AnalyticSurface(pose), section_(section), side_(side) {
  require(section.corner_radius >= 0.0 && section.half_width > 0.0 && section.half_height > 0.0 &&
              section.corner_radius <= std::min(section.half_width, section.half_height),
          "a rounded box needs a corner radius between 0 and its half sizes");
  const std::vector<Vec2> outline =
      make_rounded_outline(section.half_width, section.half_height, section.corner_radius, 30, 10);
  const int count = static_cast<int>(outline.size());
  TriangleMesh mesh = make_grid_mesh(count + 1, 13, [&](int i, int j) {
    const Vec2& p = outline[static_cast<std::size_t>(i % count)];
    return Vec3(p.x(), p.y(), extent * (j / 6.0 - 1.0));
  });
  if (side == Side::inside) flip_mesh(mesh);
  set_display_mesh(std::move(mesh));
}

FootPoint RoundedBoxSurface::locate(const Vec3& x) const {
  // All in the quadrant x, y >= 0, then mirrored back.
  const double sx = x.x() < 0.0 ? -1.0 : 1.0;
  const double sy = x.y() < 0.0 ? -1.0 : 1.0;
  const double dx = sx * x.x() - (section_.half_width - section_.corner_radius);
  const double dy = sy * x.y() - (section_.half_height - section_.corner_radius);
  if (dx > 0.0 && dy > 0.0) {
    const Vec3 spoke(sx * dx, sy * dy, 0.0);
    FootPoint foot = make_round_foot(x, spoke, Vec3::UnitZ(), section_.corner_radius, side_);
    foot.facet = 4 + (sy > 0.0 ? (sx > 0.0 ? 0 : 1) : (sx > 0.0 ? 3 : 2));
    return foot;
  }
  const double sign = side_ == Side::outside ? 1.0 : -1.0;
  FootPoint foot;
  if (dx >= dy) {  // nearer to the flat across x
    foot.gap = sign * (dx - section_.corner_radius);
    foot.normal = foot.gap_gradient = Vec3(sign * sx, 0.0, 0.0);
    foot.facet = sx > 0.0 ? 0 : 2;
  } else {
    foot.gap = sign * (dy - section_.corner_radius);
    foot.normal = foot.gap_gradient = Vec3(0.0, sign * sy, 0.0);
    foot.facet = sy > 0.0 ? 1 : 3;
  }
  foot.point = x - foot.gap * foot.normal;
  return foot;
}

TorusSurface::TorusSurface(const Pose& pose, double radius, double minor_radius, Side side)
    : AnalyticSurface(pose), radius_(radius), minor_radius_(minor_radius), side_(side) {
  require(minor_radius > 0.0 && radius > minor_radius, "a torus needs 0 < minor radius < radius");
  TriangleMesh mesh = make_grid_mesh(121, 73, [&](int i, int j) {
    const double around = 2.0 * std::numbers::pi * (i % 120) / 120.0;
    const double turn = 2.0 * std::numbers::pi * (j % 72) / 72.0;
    const double rho = radius + minor_radius * std::cos(turn);
    return Vec3(rho * std::cos(around), rho * std::sin(around), minor_radius * std::sin(turn));
  });
  if (side == Side::inside) flip_mesh(mesh);
  set_display_mesh(std::move(mesh));
}

FootPoint TorusSurface::locate(const Vec3& x) const {
  const double rho = std::hypot(x.x(), x.y());
  const bool is_on_axis = rho <= kCentre * radius_;
  const Vec3 out = is_on_axis ? Vec3(Vec3::UnitX()) : Vec3(x.x() / rho, x.y() / rho, 0.0);
  const Vec3 around(-out.y(), out.x(), 0.0);
  FootPoint foot = make_round_foot(x, x - radius_ * out, around, minor_radius_, side_);
  // The second curvature: the tube's centre runs along with the point by radius / rho of its way.
  if (!is_on_axis) {
    const double distance = (x - radius_ * out).norm();
    const double sign = side_ == Side::outside ? 1.0 : -1.0;
    if (distance > kCentre * minor_radius_) {
      foot.normal_gradient += sign * (1.0 - radius_ / rho) / distance * around * around.transpose();
    }
  }
  foot.facet = 0;
  return foot;
}

}  // namespace hydroscope
