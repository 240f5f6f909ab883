// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/live/live_camera.h"

#include <algorithm>
#include <cmath>

#include "render/camera.h"
#include "render/shape/reflection.h"

namespace hydroscope {
namespace {

constexpr double kUsualElevation = 25.0;         // [deg]
constexpr double kWidth = 0.80, kHeight = 0.84;  // of the picture, beside title and legend
constexpr double kLeft = 0.075, kBelow = 0.04;   // by how much the part then lies beside the middle

Vec3 find_up(const Vec3& direction, double azimuth) {
  if (std::abs(direction.y()) < 0.999) return Vec3::UnitY();
  // Straight from above: what was behind is up, whatever the azimuth.
  return (direction.y() > 0.0 ? -1.0 : 1.0) * calc_direction(azimuth, 0.0);
}

/// Half the picture's height [mm] at zoom 1.
double calc_scale(const Bounds& bounds, double aspect, bool has_text) {
  const Vec3 half = 0.5 * (bounds.greatest - bounds.least);
  const double wide = has_text ? kWidth : 0.94, high = has_text ? kHeight : 0.94;
  double scale = 0.0;
  const auto hold = [&](double azimuth, double elevation, double share_wide, double share_high) {
    const Vec3 direction = calc_direction(azimuth, elevation);
    const Vec3 right = find_up(direction, azimuth).cross(direction).normalized();
    const Vec3 upright = direction.cross(right);
    scale = std::max({scale, right.cwiseAbs().dot(half) / (share_wide * aspect),
                      upright.cwiseAbs().dot(half) / share_high});
  };
  for (int degrees = 0; degrees < 180; degrees += 5) hold(degrees, kUsualElevation, wide, high);
  // The standard views may fill the picture.
  for (const double azimuth : {0.0, 90.0}) {
    hold(azimuth, 0.0, 0.97, 0.97);
    hold(azimuth, 90.0, 0.97, 0.97);
  }
  return scale > 0.0 ? scale : 1.0;
}

}  // namespace

Bounds calc_live_bounds(const Snapshot& first, bool is_mirrored) {
  const std::vector<Plane> mirrors = is_mirrored ? first.model->mirrors : std::vector<Plane>{};
  const Bounds sheet = calc_bounds(first, calc_reflections(mirrors));
  Bounds box = sheet;
  const Vec3 margin = (0.35 * (sheet.greatest - sheet.least)).cwiseMax(0.05 * sheet.diagonal());
  for (const SnapshotModel::Tool& tool : first.model->tools)
    for (const Reflection& reflection : calc_reflections(find_open_mirrors(mirrors, tool.mesh.points)))
      for (const Vec3& x : tool.mesh.points)
        box.include(reflection.point(x).cwiseMax(sheet.least - margin).cwiseMin(sheet.greatest + margin));
  if (first.model->tools.empty()) {  // a free bulge grows
    box.include(sheet.least - 0.2 * margin);
    box.include(sheet.greatest + 0.2 * margin);
  }
  return box;
}

CameraPose calc_live_camera(const LiveView& view, const Bounds& bounds) {
  const double aspect = static_cast<double>(view.width) / view.height;
  const double whole = calc_scale(bounds, aspect, view.has_text);
  CameraPose pose;
  const Vec3 direction = calc_direction(view.azimuth, view.elevation);
  pose.up = find_up(direction, view.azimuth);
  pose.scale = whole / view.zoom;
  const Vec3 right = pose.up.cross(direction).normalized(), upright = direction.cross(right);
  pose.focal = view.focus.value_or(bounds.centre());
  // Beside the legend, unless a place was asked for.
  if (view.has_text && !view.focus)
    pose.focal += 2.0 * pose.scale * (aspect * kLeft * right + kBelow * upright);
  pose.focal += 2.0 * whole * (view.pan_x * right + view.pan_y * upright);
  const double reach = (pose.focal - bounds.centre()).norm() + bounds.diagonal();
  pose.position = pose.focal + 4.0 * std::max(reach, pose.scale) * direction;
  return pose;
}

std::optional<Plane> calc_clip_plane(const LiveView& view, const Bounds& bounds) {
  if (view.clip_axis < 0) return std::nullopt;
  Plane plane{bounds.centre(), Vec3::Unit(view.clip_axis)};
  plane.point[view.clip_axis] =
      bounds.least[view.clip_axis] + view.clip_share * (bounds.greatest - bounds.least)[view.clip_axis];
  if (view.clip_flip) plane.normal = -plane.normal;
  return plane;
}

Plane calc_live_cut(const CameraPose& camera, const Bounds& bounds) {
  const Vec3 direction = (camera.position - camera.focal).normalized();
  // Upright planes first: a part is looked at from above more often than cut level.
  const Vec3 weight = direction.cwiseAbs().cwiseProduct(Vec3(1.0, 0.6, 1.0));
  int axis = 0;
  weight.maxCoeff(&axis);
  return {bounds.centre(), direction[axis] < 0.0 ? Vec3(-Vec3::Unit(axis)) : Vec3(Vec3::Unit(axis))};
}

Projection::Projection(const LiveView& view, const CameraPose& camera)
    : focal(camera.focal),
      direction((camera.position - camera.focal).normalized()),
      width(view.width),
      height(view.height),
      pixel(2.0 * camera.scale / view.height) {
  right = camera.up.cross(direction).normalized();
  upright = direction.cross(right);
}

}  // namespace hydroscope
