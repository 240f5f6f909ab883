// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/verification/run_scene.h"

namespace hydroscope::verification {
namespace {

constexpr double kRadius = 30.0, kYoung = 206e3, kPoisson = 0.3, kPressure = 1.0;

// A wedge of 2 degrees of a tube, ends clamped, free to slide along the axis.
const char* const kScene = R"(
[tube]
radius_mm = 30.0
thickness_mm = 1.5
length_mm = 120.0
section = "sector"
sector_angle_deg = 2.0
extent = "half"
elements_around = 1
elements_along = 200
[material]
youngs_modulus_MPa = 206e3
poisson = 0.3
[load]
pressure_MPa = [[0.0, 0.0], [1.0, 1.0]]
[ends]
axial = "free"
radial = "held"
rotation = "held"
[increment]
tolerance = 1e-5
)";

/// V4: bending of a clamped edge under pressure without axial force: a beam on an elastic foundation
/// k = E t/r^2, with bending stiffness D and shear stiffness S = kappa G t (none of it left out: S infinite).
///   D beta'' + S (w' - beta) = 0,  S (w'' - beta') - k w + p = 0,  w = beta = 0 at the edge.
/// w = w0 (1 - f), w0 = p/k, f = e^(-ax) (cos bx + c sin bx), a^2, b^2 = lambda^2 +- k/(4 S), 4 lambda^4 =
/// k/D; beta(0) = 0 gives c = (a/b) (1 - s)/(1 + s), s = k/(2 S lambda^2). Then the edge's moment is D w0 (2
/// a b c + k/(2 S)) and its force S w0 (a - b c). For s = 0: p/(2 lambda^2) and p/lambda.
struct Edge {
  double far, a, b, c, moment, force, lambda;

  Edge(double t, bool is_shear_flexible) {
    const double k = kYoung * t / (kRadius * kRadius),
                 d = kYoung * t * t * t / (12.0 * (1.0 - kPoisson * kPoisson)),
                 stiffness = 5.0 / 6.0 * kYoung / (2.0 * (1.0 + kPoisson)) * t;
    lambda = std::pow(0.25 * k / d, 0.25);
    const double flexibility = is_shear_flexible ? 1.0 / stiffness : 0.0;
    const double s = 0.5 * k * flexibility / (lambda * lambda);
    far = kPressure / k;
    a = std::sqrt(lambda * lambda + 0.25 * k * flexibility);
    b = std::sqrt(lambda * lambda - 0.25 * k * flexibility);
    c = a / b * (1.0 - s) / (1.0 + s);
    moment = d * far * (2.0 * a * b * c + 0.5 * k * flexibility);
    force = is_shear_flexible ? stiffness * far * (a - b * c) : kPressure / lambda;
  }
  double calc_displacement(double x) const {
    return far * (1.0 - std::exp(-a * x) * (std::cos(b * x) + c * std::sin(b * x)));
  }
};

struct Measured {
  double error_of_w = 0.0, moment = 0.0, force = 0.0;
};

Measured run_tube(double t, double length, const Edge& edge) {
  const History h = run_text(
      kScene, {"tube.thickness_mm=" + std::to_string(t), "tube.length_mm=" + std::to_string(length)});
  EXPECT_EQ(h.summary.outcome, Outcome::kCompleted) << h.summary.message;
  const Snapshot& end = *h.states.back();
  Measured m;
  const double step = 0.5 * length / 200.0;
  double first = NAN, second = NAN;
  for (std::size_t i = 0; i < end.points.size(); ++i) {
    const double x = 0.5 * length - end.points[i].z();
    const double w = end.points[i].head<2>().norm() - kRadius;
    m.error_of_w = std::max(m.error_of_w, std::abs(w - edge.calc_displacement(x)) / edge.far);
    const double tilt = std::abs(end.directors[i].z());
    if (std::abs(x - step) < 0.1 * step) first = tilt;
    if (std::abs(x - 2 * step) < 0.1 * step) second = tilt;
    if (std::abs(x) < 0.1 * step) m.force += end.support_force[i].head<2>().norm();
  }
  // The fibre is at rest at the clamp: beta'(0) of second order.
  m.moment =
      kYoung * t * t * t / (12.0 * (1.0 - kPoisson * kPoisson)) * (4.0 * first - second) / (2.0 * step);
  m.force /= kRadius * 2.0 * std::numbers::pi / 180.0;
  return m;
}

void expect_edge(const std::string& name, double t, double length, const Edge& edge) {
  const Measured m = run_tube(t, length, edge);
  EXPECT_LT(m.error_of_w, 0.01) << "of the displacement far away, everywhere";
  EXPECT_LT(relative_error(m.moment, edge.moment), 0.01);
  EXPECT_LT(relative_error(m.force, edge.force), 0.01);
  ::testing::Test::RecordProperty(name + "_error_of_w", std::to_string(m.error_of_w));
  ::testing::Test::RecordProperty(name + "_moment_N",
                                  std::to_string(m.moment) + " wanted " + std::to_string(edge.moment));
  ::testing::Test::RecordProperty(name + "_force_N_per_mm",
                                  std::to_string(m.force) + " wanted " + std::to_string(edge.force));
}

TEST(EdgeBending, FormulaIsTheNotebooksWithoutShear) {
  const Edge rigid(1.5, false);  // mechanics V4
  EXPECT_NEAR(rigid.lambda, 0.191617, 1e-6);
  EXPECT_NEAR(rigid.moment, 13.618, 1e-3);
  EXPECT_NEAR(rigid.force, 5.2187, 1e-4);
  EXPECT_NEAR(rigid.far, 2.91262e-3, 1e-8);
}

/// Tube T: shear through the wall takes 4.5 % off the moment and 3.3 % off the force.
TEST(EdgeBending, OfTubeTIsThatOfAShearFlexibleWall) { expect_edge("T", 1.5, 120.0, Edge(1.5, true)); }

/// A wall of a tenth: the classical formula.
TEST(EdgeBending, OfAThinTubeIsTheClassicalOne) { expect_edge("thin", 0.15, 40.0, Edge(0.15, false)); }

}  // namespace
}  // namespace hydroscope::verification
