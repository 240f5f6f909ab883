// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

// Of the picture's width and height, what the part may take: the title stands
// above it and the legend to its right.
constexpr double kWidth = 0.80, kHeight = 0.84;
// By how much of them the part's middle lies left of and below the picture's.
constexpr double kLeft = 0.075, kBelow = 0.04;

/// Half height [mm] that holds the box seen from `direction`.
double calc_scale(const Bounds& bounds, const Vec3& direction, const Vec3& up, double aspect) {
  const Vec3 right = up.cross(direction).normalized(), upright = direction.cross(right);
  const Vec3 half = 0.5 * (bounds.greatest - bounds.least);
  const double width = right.cwiseAbs().dot(half), height = upright.cwiseAbs().dot(half);
  return std::max(height / kHeight, width / (kWidth * aspect));
}

}  // namespace

Vec3 calc_direction(double azimuth, double elevation) {
  const double a = azimuth * std::numbers::pi / 180.0, e = elevation * std::numbers::pi / 180.0;
  return {std::cos(a) * std::cos(e), std::sin(e), std::sin(a) * std::cos(e)};
}

CameraPose calc_camera(const FrameOptions& options, const Bounds& bounds, const std::optional<Vec3>& look_at,
                       int index, int expected) {
  if (options.pose) return *options.pose;
  const bool is_orbit = options.camera == "orbit";
  const double turned = is_orbit && expected > 1 ? options.orbit * index / expected : 0.0;
  const Vec3 direction = calc_direction(options.azimuth + turned, options.elevation);
  const double aspect = static_cast<double>(options.size[0]) / options.size[1];
  CameraPose pose;
  // Looking straight down, "up" must not be the line of sight.
  pose.up = std::abs(direction.y()) > 0.999 ? Vec3::UnitX() : Vec3::UnitY();
  pose.scale = calc_scale(bounds, direction, pose.up, aspect);
  if (is_orbit)
    for (int degrees = 0; degrees < 180; degrees += 5)
      pose.scale = std::max(pose.scale,
                            calc_scale(bounds, calc_direction(degrees, options.elevation), pose.up, aspect));
  pose.scale /= options.zoom;
  if (!(pose.scale > 0.0)) pose.scale = 1.0;
  const Vec3 right = pose.up.cross(direction).normalized(), upright = direction.cross(right);
  const double unit = 2.0 * pose.scale;
  pose.focal = look_at.value_or(bounds.centre() + unit * (aspect * kLeft * right + kBelow * upright));
  pose.position = pose.focal + 4.0 * std::max(bounds.diagonal(), pose.scale) * direction;
  return pose;
}

Plane calc_cut(const FrameOptions& options, const CameraPose& camera, const Bounds& bounds) {
  if (options.cut) return *options.cut;
  Vec3 direction = camera.position - camera.focal;
  direction.y() = 0.0;
  if (direction.norm() < 1e-6 * (camera.position - camera.focal).norm())
    return {bounds.centre(), Vec3::UnitY()};
  if (options.camera == "orbit") return {bounds.centre(), direction.normalized()};
  const bool is_across = std::abs(direction.x()) >= std::abs(direction.z());
  const Vec3 axis = is_across ? Vec3::UnitX() : Vec3::UnitZ();
  return {bounds.centre(), axis.dot(direction) >= 0.0 ? axis : Vec3(-axis)};
}

void check_camera(const FrameOptions& options, int nodes) {
  if (options.camera != "fixed" && options.camera != "orbit" && options.camera != "look-at")
    throw InputError("camera '" + options.camera + "' is unknown; there are fixed, orbit and look-at");
  if (!(options.zoom > 0.0) || !std::isfinite(options.zoom)) throw InputError("zoom must be above 0");
  if (!(std::abs(options.elevation) <= 90.0))
    throw InputError("elevation must lie between -90 and 90 degrees");
  if (!std::isfinite(options.azimuth) || !std::isfinite(options.orbit))
    throw InputError("azimuth and orbit must be numbers");
  if (options.camera == "look-at" && (options.look_at_node < 0 || options.look_at_node >= nodes))
    throw InputError("look_at_node is " + std::to_string(options.look_at_node) + "; nodes run from 0 to " +
                     std::to_string(nodes - 1));
  for (int extent : options.size)
    if (extent < 64 || extent > 8192) throw InputError("frame size must lie between 64 and 8192 pixels");
}

}  // namespace hydroscope
