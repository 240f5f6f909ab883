// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "solver/geometry/analytic_surface.h"
#include "solver/geometry/grid_mesh.h"
#include "solver/geometry/mesh_surface.h"
#include "solver/geometry/nagata_surface.h"
#include "tests/solver/curvature_slope.h"

namespace hydroscope {
namespace {

constexpr double kRadius = 10.0;

/// Round die of facets of `angle` [deg], the free side inside, and a little more than a quarter of it.
TriangleMesh make_die(double angle) {
  const int facets = static_cast<int>(std::lround(100.0 / angle));
  TriangleMesh mesh = make_grid_mesh(facets + 1, 5, [&](int i, int j) {
    const double a = (angle * i - 5.0) * std::numbers::pi / 180.0;
    return Vec3(kRadius * std::cos(a), kRadius * std::sin(a), 2.0 * (j - 2));
  });
  flip_mesh(mesh);
  return mesh;
}

struct Carried {
  double removal = 1.0;  ///< size of a force whose tangential part is cut off after each step
  double transport =
      1.0;             ///< of one turned by dn/dx du, then given its size again: along the normal at the end
  double angle = 0.0;  ///< between that one and the true normal at the end [rad]
};

/// A contact force of 1 slides through 90 degrees in steps of `step` [rad], frictionless, constant: each
/// step along the tangent, then back onto the tool.
Carried slide_quarter(const ToolSurface& tool, double step) {
  const auto place = [](double a) { return Vec3(kRadius * std::cos(a), kRadius * std::sin(a), 0.3); };
  FootPoint foot = find_foot(tool, place(0.0));
  Vec3 cut = foot.normal, turned = foot.normal;
  const int steps = static_cast<int>(std::lround(0.5 * std::numbers::pi / step));
  for (int k = 1; k <= steps; ++k) {
    const FootPoint next = find_foot(tool, place(step * k));
    const Vec3 way = next.point - foot.point;
    const Vec3 du = (way - foot.normal.dot(way) * foot.normal);  // along the tangent
    cut = next.normal.dot(cut) * next.normal;                    // (4.23) taken away
    turned = (turned + foot.normal_gradient * du).normalized();  // (4.28), (4.29), renormalised
    foot = next;
  }
  return {cut.norm(), turned.dot(foot.normal), std::acos(std::min(1.0, turned.dot(foot.normal)))};
}

/// V18: cutting off the tangential part loses cos(step) each time; mechanics 4.3 prints 6.6, 2.7, 1.4, 0.7 %.
TEST(ForceTransport, RemovalLosesForceAndTransportKeepsIt) {
  const CylinderSurface die(Pose{}, kRadius, Side::inside, 20.0);
  const struct {
    double step_deg, left;
  } rows[] = {{5.0, 0.9337}, {2.0, 0.9730}, {1.0, 0.9864}, {0.5, 0.9932}};
  for (const auto& row : rows) {
    const double step = row.step_deg * std::numbers::pi / 180.0;
    const Carried c = slide_quarter(die, step);
    EXPECT_NEAR(c.removal, std::pow(std::cos(step), 90.0 / row.step_deg), 1e-9);
    EXPECT_NEAR(c.removal, row.left, 5e-5) << "as printed";
    // du is R sin(step) long here and turns the force by atan(sin(step)): behind by step^3 / 2 a step.
    EXPECT_LT(c.angle, 0.25 * std::numbers::pi * step * step);
    EXPECT_GT(c.transport, 1.0 - 2e-5);
    RecordProperty("left_" + std::to_string(row.step_deg),
                   std::to_string(c.removal) + " transported " + std::to_string(c.transport));
  }
}

/// The same on facets of 3 degrees, bent or not: the normal is continuous, and its gradient is true, but
/// jumps from facet to facet, so that a step over an edge carries a rest of the jump.
TEST(ForceTransport, HoldsOnFacetsToo) {
  const TriangleMesh mesh = make_die(3.0);
  MeshSurfaceOptions smooth;
  smooth.is_smooth = true;
  const std::pair<const char*, std::shared_ptr<const ToolSurface>> tools[] = {
      {"facets", std::make_shared<MeshSurface>(mesh)},
      {"smooth", std::make_shared<MeshSurface>(mesh, smooth)},
      {"nagata", std::make_shared<NagataSurface>(mesh)}};
  for (const auto& [name, tool] : tools) {
    for (const double step_deg : {5.0, 2.0, 1.0, 0.5}) {
      const Carried c = slide_quarter(*tool, step_deg * std::numbers::pi / 180.0);
      EXPECT_NEAR(c.removal, std::pow(std::cos(step_deg * std::numbers::pi / 180.0), 90.0 / step_deg), 2e-3)
          << name;
      EXPECT_GT(c.transport, 1.0 - 1e-4) << name << " at " << step_deg;
      RecordProperty(std::string(name) + "_" + std::to_string(step_deg),
                     std::to_string(c.removal) + " transported " + std::to_string(c.transport));
    }
  }
}

}  // namespace
}  // namespace hydroscope
