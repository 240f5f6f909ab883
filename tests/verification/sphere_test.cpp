// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "tests/temporary_folder.h"
#include "tests/verification/linear_shell.h"
#include "tests/verification/plane_strain_ring.h"
#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

constexpr double kRadius = 50.0, kWall = 1.0;

/// An octant of the sphere of three patches of n x n quadrilaterals, as a VTU in text.
std::string make_octant(int n) {
  LinearShell mesh;
  const Vec3 middle = Vec3::Ones().normalized();
  for (int k = 0; k < 3; ++k) {
    const Vec3 corner = Vec3::Unit(k), next = (corner + Vec3::Unit((k + 1) % 3)).normalized(),
               last = (corner + Vec3::Unit((k + 2) % 3)).normalized();
    mesh.add_patch(
        n, n,
        [&](int i, int j) {
          const double a = static_cast<double>(i) / n, b = static_cast<double>(j) / n;
          const Vec3 out =
              ((1 - a) * (1 - b) * corner + a * (1 - b) * next + a * b * middle + (1 - a) * b * last)
                  .normalized();
          return SurfacePoint{kRadius * out, out, out.unitOrthogonal()};
        },
        1e-6);
  }
  std::ostringstream points, cells, offsets, types;
  points.precision(15);
  for (const Vec3& x : mesh.x) points << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
  for (std::size_t e = 0; e < mesh.quads.size(); ++e) {
    for (const int i : mesh.quads[e]) cells << i << ' ';
    offsets << 4 * (e + 1) << ' ';
    types << "9 ";
  }
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece><Points><DataArray type=\"Float64\" "
         "NumberOfComponents=\"3\" format=\"ascii\">\n" +
         points.str() +
         "</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">" +
         cells.str() + "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">" +
         offsets.str() + "</DataArray><DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">" +
         types.str() + "</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>\n";
}

struct SphereState {
  double strain, thickness, pressure;
};

/// Equal stresses s in all directions: sbar = s, each direction takes half of the plastic strain ep, so
/// e = (1 - nu) s/E + ep/2, t = t0 exp(-2 nu s/E - ep), p = 2 s t/r, r = r0 exp(e), with s = K (eps0 + ep)^n:
/// exact, elastic strains and all.
SphereState calc_sphere(double plastic_strain) {
  const double s = kM1.k * std::pow(kM1.eps0 + plastic_strain, kM1.n);
  const double e = (1.0 - kM1.poisson) * s / kM1.youngs_modulus + 0.5 * plastic_strain;
  const double t = kWall * std::exp(-2.0 * kM1.poisson * s / kM1.youngs_modulus - plastic_strain);
  return {e, t, 2.0 * s * t / (kRadius * std::exp(e))};
}

SphereState find_sphere(double strain) {
  double low = 0.0, high = 2.0 * strain;
  for (int i = 0; i < 60; ++i)
    (calc_sphere(0.5 * (low + high)).strain < strain ? low : high) = 0.5 * (low + high);
  return calc_sphere(low);
}

/// V6: free expansion of a sphere past its pressure maximum. Elements of an angle d make a polyhedron that
/// bears about d^2/8 more than the sphere, 0.06 % with 24 over a quarter turn.
TEST(Sphere, FollowsTheClosedFormPastItsMaximum) {
  EXPECT_LT(relative_error(find_sphere(0.01).pressure, 10.4666), 1e-4);  // mechanics V6
  EXPECT_LT(relative_error(find_sphere(0.01).thickness, 0.98122), 1e-4);
  EXPECT_LT(relative_error(find_sphere(0.05).pressure, 12.1406), 1e-4);
  const TemporaryFolder folder;
  std::ofstream(folder / "octant.vtu") << make_octant(12);
  const History h = run_text("[mesh]\nfile = \"" + folder / "octant.vtu" + R"("
thickness_mm = 1.0
[material]
youngs_modulus_MPa = 206e3
poisson = 0.3
hardening = "swift"
swift_K_MPa = 550.0
swift_eps0 = 0.01
swift_n = 0.2
[ends]
axial = "free"
[load]
control = "volume"
volume_ratio = [[0.0, 1.0], [1.0, 1.32]]
)");
  ASSERT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  double worst_pressure = 0.0, worst_thickness = 0.0, last = 0.0, highest = 0.0;
  for (const auto& state : h.states) {
    double radius = 0.0, thinnest = 1e300, thickest = 0.0;
    for (std::size_t i = 0; i < state->points.size(); ++i) {
      radius += state->points[i].norm() / static_cast<double>(state->points.size());
      thinnest = std::min(thinnest, state->thickness[i]);
      thickest = std::max(thickest, state->thickness[i]);
    }
    last = std::log(radius / kRadius);
    highest = std::max(highest, state->pressure);
    if (last < 0.005) continue;  // the increments over first yield: docs/verification.md
    const SphereState wanted = find_sphere(last);
    worst_pressure = std::max(worst_pressure, relative_error(state->pressure, wanted.pressure));
    worst_thickness = std::max({worst_thickness, relative_error(thinnest, wanted.thickness),
                                relative_error(thickest, wanted.thickness)});
  }
  EXPECT_LT(worst_pressure, 0.002);
  EXPECT_LT(worst_thickness, 0.002) << "every node";
  EXPECT_GT(last, 0.085) << "past the maximum at 0.0628";
  EXPECT_LT(relative_error(highest, 12.1916), 0.002);
  RecordProperty("pressure_error", std::to_string(worst_pressure));
  RecordProperty("thickness_error", std::to_string(worst_thickness));
  RecordProperty("highest_pressure_MPa", std::to_string(highest));
}

}  // namespace
}  // namespace hydroscope::verification
