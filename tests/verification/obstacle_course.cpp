// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/obstacle_course.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/verification/linear_shell.h"

namespace hydroscope::verification {

namespace {

constexpr double kPi = std::numbers::pi;
// Degrees of freedom of a node: u_x, u_y, u_z, rotation about V1, about V2.
constexpr int kX = 0, kY = 1, kZ = 2, kAlpha = 3, kBeta = 4;

/// Cylinder about z: V1 around, V2 along the axis.
SurfacePoint on_cylinder(double radius, double angle, double z) {
  const Vec3 out(std::cos(angle), std::sin(angle), 0.0);
  return {radius * out + z * Vec3::UnitZ(), out, Vec3(-out.y(), out.x(), 0.0)};
}

/// Part of a cylinder from the angle 0 and z = 0 (symmetry planes) to `angle` and a rigid diaphragm at z =
/// `length`.
LinearShell make_cylinder(int n, double radius, double angle, double length) {
  LinearShell shell;
  shell.add_patch(
      n, n, [=](int i, int j) { return on_cylinder(radius, angle * i / n, length * j / n); }, 0.0);
  shell.finish_mesh();
  for (int k = 0; k <= n; ++k) {
    shell.hold(k * (n + 1), {kY, kBeta});          // plane y = 0: no rotation about the axis
    shell.hold(k, {kZ, kAlpha});                   // plane z = 0
    shell.hold(n * (n + 1) + k, {kX, kY, kBeta});  // diaphragm
  }
  return shell;
}

/// R 25, L 50, half angle 40 degrees, t 0.25, E 4.32e8, nu 0, 90 per area downwards.
double solve_scordelis_lo(int n) {
  LinearShell shell = make_cylinder(n, 25.0, 40.0 * kPi / 180.0, 25.0);
  shell.youngs_modulus = 4.32e8;
  shell.thickness = 0.25;
  shell.add_area_load(Vec3(-90.0, 0.0, 0.0));
  return -shell.solve()[kDofs * n + kX];
}

/// R 300, L 600, t 3, E 3e6, nu 0.3, two forces of 1.
double solve_pinched_cylinder(int n) {
  LinearShell shell = make_cylinder(n, 300.0, 0.5 * kPi, 300.0);
  shell.youngs_modulus = 3e6;
  shell.poisson = 0.3;
  shell.thickness = 3.0;
  for (int j = 0; j <= n; ++j) shell.hold(j * (n + 1) + n, {kX, kBeta});  // plane x = 0
  shell.load[kX] = -0.25;
  return -shell.solve()[kX];
}

/// Sphere: V1 around the z axis; at the pole along y.
SurfacePoint on_sphere(double radius, const Vec3& direction) {
  const Vec3 out = direction.normalized();
  const Vec3 around(-out.y(), out.x(), 0.0);
  return {radius * out, out, around.norm() > 1e-9 ? Vec3(around.normalized()) : Vec3(Vec3::UnitY())};
}

/// A quarter of a hemisphere, R 10, t 0.04, E 6.825e7, nu 0.3, forces of 2 at its four points of the
/// equator, outwards along x and inwards along y; returns the mean displacement along them.
double solve_hemisphere(LinearShell& shell) {
  shell.youngs_modulus = 6.825e7;
  shell.poisson = 0.3;
  shell.thickness = 0.04;
  shell.finish_mesh();
  int on_x = -1, on_y = -1;
  for (std::size_t i = 0; i < shell.x.size(); ++i) {
    const Vec3& x = shell.x[i];
    const int node = static_cast<int>(i);
    const bool in_y = std::abs(x.y()) < 1e-9, in_x = std::abs(x.x()) < 1e-9;
    if (in_y) shell.hold(node, {kY, kBeta});
    if (in_x) shell.hold(node, {kX, kBeta});
    if (in_x && in_y) shell.hold(node, {kAlpha});
    if (std::abs(x.z()) < 1e-9 && in_y) on_x = node;
    if (std::abs(x.z()) < 1e-9 && in_x) on_y = node;
  }
  shell.hold(on_x, {kZ});
  shell.load[kDofs * on_x + kX] = 1.0;
  shell.load[kDofs * on_y + kY] = -1.0;
  const Vector q = shell.solve();
  return 0.5 * (q[kDofs * on_x + kX] - q[kDofs * on_y + kY]);
}

double solve_hemisphere_with_hole(int n) {
  LinearShell shell;
  shell.add_patch(
      n, n,
      [=](int i, int j) {
        const double around = 0.5 * kPi * i / n, up = 72.0 * kPi / 180.0 * j / n;
        // Exact zeros on the symmetry planes.
        return on_sphere(10.0, {i == n ? 0.0 : std::cos(around) * std::cos(up),
                                i == 0 ? 0.0 : std::sin(around) * std::cos(up), std::sin(up)});
      },
      0.0);
  return solve_hemisphere(shell);
}

/// Three patches of n/2 x n/2 elements that meet in the middle.
double solve_whole_hemisphere(int n) {
  LinearShell shell;
  const int half = n / 2;
  const Vec3 middle = Vec3::Ones().normalized();
  for (int k = 0; k < 3; ++k) {
    const Vec3 corner = Vec3::Unit(k), next = (corner + Vec3::Unit((k + 1) % 3)).normalized(),
               last = (corner + Vec3::Unit((k + 2) % 3)).normalized();
    shell.add_patch(
        half, half,
        [&](int i, int j) {
          const double a = static_cast<double>(i) / half, b = static_cast<double>(j) / half;
          return on_sphere(
              10.0, (1 - a) * (1 - b) * corner + a * (1 - b) * next + a * b * middle + (1 - a) * b * last);
        },
        1e-6);
  }
  return solve_hemisphere(shell);
}

/// A clamped strip whose mid-surface is `point(s, w)`, s from 0 to 1 along it, w from -1/2 to 1/2 across it;
/// `force` spread evenly over its end. Returns the displacement of the end's middle along the force.
double solve_strip(LinearShell& shell, int along, int across,
                   const std::function<SurfacePoint(double, double)>& point, const Vec3& force) {
  shell.add_patch(
      along, across,
      [&](int i, int j) {
        return point(static_cast<double>(i) / along, static_cast<double>(j) / across - 0.5);
      },
      0.0);
  shell.finish_mesh();
  const auto end = [=](int j) { return kDofs * (j * (along + 1) + along); };
  for (int j = 0; j <= across; ++j) {
    shell.hold(j * (along + 1), {kX, kY, kZ, kAlpha, kBeta});
    shell.load.segment<3>(end(j)) = force * (j == 0 || j == across ? 0.5 : 1.0) / across;
  }
  const Vector q = shell.solve();
  const Vec3 middle = 0.5 * (q.segment<3>(end(across / 2)) + q.segment<3>(end((across + 1) / 2)));
  return middle.dot(force) / force.norm();
}

/// L 12, width 1.1, E 29e6, nu 0.22, twisted by 90 degrees.
double solve_twisted_beam(int n, double thickness, const Vec3& force) {
  LinearShell shell;
  shell.youngs_modulus = 29e6;
  shell.poisson = 0.22;
  shell.thickness = thickness;
  const auto point = [](double s, double w) {
    const double turn = 0.5 * kPi * s;
    const Vec3 across(0.0, std::cos(turn), std::sin(turn)), rise(0.0, -std::sin(turn), std::cos(turn));
    const Vec3 along = Vec3::UnitX() + 1.1 * w * 0.5 * kPi / 12.0 * rise;
    return SurfacePoint{12.0 * s * Vec3::UnitX() + 1.1 * w * across, along.cross(across).normalized(),
                        along.normalized()};
  };
  return solve_strip(shell, 6 * n, n, point, force);
}

double solve_thick_in_plane(int n) { return solve_twisted_beam(n, 0.32, Vec3(0, 0, 1)); }
double solve_thick_out_of_plane(int n) { return solve_twisted_beam(n, 0.32, Vec3(0, 1, 0)); }
double solve_thin_in_plane(int n) { return solve_twisted_beam(n, 0.0032, Vec3(0, 0, 1e-6)); }
double solve_thin_out_of_plane(int n) { return solve_twisted_beam(n, 0.0032, Vec3(0, 1e-6, 0)); }

/// Two arcs that bend opposite ways, 60 degrees of R 14 from the clamp and 150 degrees of R 46; width 20,
/// t 2, E 3300, nu 0.35, a force of 1 along the width.
double solve_raasch_hook(int n) {
  LinearShell shell;
  shell.youngs_modulus = 3300.0;
  shell.poisson = 0.35;
  shell.thickness = 2.0;
  const double first = 14.0 * kPi / 3.0, second = 46.0 * 5.0 * kPi / 6.0;
  const auto point = [=](double s, double w) {
    // Direction angle of the line, 0 at the clamp: + 60 degrees over the first arc, then back by 150.
    const double way = s * (first + second);
    const Vec3 centre1(0.0, 14.0, 0.0),
        centre2 = centre1 + 60.0 * Vec3(std::sin(kPi / 3), -std::cos(kPi / 3), 0.0);
    const double turn = way <= first ? way / 14.0 : kPi / 3.0 - (way - first) / 46.0;
    const Vec3 left(-std::sin(turn), std::cos(turn), 0.0);
    const Vec3 at = way <= first ? Vec3(centre1 - 14.0 * left) : Vec3(centre2 + 46.0 * left);
    return SurfacePoint{at + 20.0 * w * Vec3::UnitZ(), Vec3(-left),
                        Vec3(std::cos(turn), std::sin(turn), 0.0)};
  };
  // A node on the seam of the arcs: lengths are as 14 x 60 to 46 x 150, 14 elements to 115 or nearly.
  return solve_strip(shell, 9 * n, n, point, Vec3(0, 0, 1));
}

}  // namespace

const std::vector<Obstacle>& list_obstacles() {
  static const std::vector<Obstacle> obstacles = {
      {"scordelis_lo", 0.3024, solve_scordelis_lo},
      {"pinched_cylinder", 1.8248e-5, solve_pinched_cylinder},
      {"hemisphere", 0.0924, solve_whole_hemisphere},
      {"hemisphere_with_hole", 0.0940, solve_hemisphere_with_hole},
      {"twisted_beam_in_plane", 5.4245e-3, solve_thick_in_plane},
      {"twisted_beam_out_of_plane", 1.7532e-3, solve_thick_out_of_plane},
      {"thin_twisted_beam_in_plane", 5.256e-3, solve_thin_in_plane},
      {"thin_twisted_beam_out_of_plane", 1.294e-3, solve_thin_out_of_plane},
      {"raasch_hook", 5.02, solve_raasch_hook},
  };
  return obstacles;
}

const Obstacle& find_obstacle(const std::string& name) {
  for (const Obstacle& obstacle : list_obstacles()) {
    if (obstacle.name == name) return obstacle;
  }
  throw std::invalid_argument("no obstacle " + name);
}

}  // namespace hydroscope::verification
