// SPDX-License-Identifier: GPL-3.0-or-later
// Terms of the shell that can be left out: K_rot, and what is of second order through the wall.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/shell/shell_element.h"

namespace hydroscope {
namespace {

constexpr double kThickness = 1.5, kLength = 4.0, kWidth = 3.0;  // of the element [mm]
constexpr double kModulus = 206e3, kPoisson = 0.3, kPlaneModulus = kModulus / (1.0 - kPoisson * kPoisson);

ShellLaw make_law(bool director_stiffness, bool curvature_terms) {
  SheetMaterial m;
  m.youngs_modulus = kModulus;
  m.poisson = kPoisson;
  ShellLaw law{SheetLaw(m), make_thickness_rule("gauss", 5)};
  law.director_stiffness = director_stiffness;
  law.curvature_terms = curvature_terms;
  return law;
}

Triad make_triad(const Vec3& v) {
  Triad t;
  t.v = v.normalized();
  t.v1 = Vec3::UnitZ().cross(t.v).normalized();
  t.v2 = t.v.cross(t.v1);
  return t;
}

/// An elastic element in the plane y = 0, x along its length; its state after what load() has done.
struct Element {
  explicit Element(const ShellLaw& of) : law(of) {
    for (std::size_t a = 0; a < 4; ++a) {
      nodes.x[a] = Vec3(a == 1 || a == 2 ? kLength : 0.0, 0.0, a >= 2 ? kWidth : 0.0);
      nodes.triad[a] = make_triad(-Vec3::UnitY());
      nodes.thickness[a] = kThickness;
    }
    layers.resize(20);
    gauss.resize(4);
    initialise_element(nodes, Vec3::UnitZ(), law.rule, {layers, gauss});
  }

  ElementResponse evaluate(const ElementNodes& end, ElementMatrix* k = nullptr) const {
    std::vector<LayerState> l(20);
    std::vector<GaussState> g(4);
    return evaluate_element(law, nodes, end, {layers, gauss}, {}, {l, g}, k);
  }

  void load(const ElementNodes& end) {
    std::vector<LayerState> l(20);
    std::vector<GaussState> g(4);
    evaluate_element(law, nodes, end, {layers, gauss}, {}, {l, g}, nullptr);
    nodes = end;
    layers = l;
    gauss = g;
  }

  /// Stretched along x, and bent by turning the fibres of both ends about z, each by `turn` [rad].
  ElementNodes deform(double stretch, double turn) const {
    ElementNodes to = nodes;
    for (std::size_t a = 0; a < 4; ++a) {
      const bool is_far = a == 1 || a == 2;
      to.x[a].x() *= 1.0 + stretch;
      to.triad[a] = make_triad(Eigen::AngleAxisd(is_far ? turn : -turn, Vec3::UnitZ()) * to.triad[a].v);
    }
    return to;
  }

  ElementNodes moved(const ElementVector& q) const {
    ElementNodes to = nodes;
    for (std::size_t a = 0; a < 4; ++a) {
      const auto at = static_cast<Eigen::Index>(5 * a);
      to.x[a] += q.segment<3>(at);
      Triad& t = to.triad[a];
      const Vec3 theta = q[at + 3] * t.v1 + q[at + 4] * t.v2;
      if (theta.norm() == 0.0) continue;
      const Mat3 turn = Eigen::AngleAxisd(theta.norm(), theta.normalized()).toRotationMatrix();
      t = {turn * t.v1, turn * t.v2, turn * t.v};
    }
    return to;
  }

  ElementMatrix tangent() const {
    ElementMatrix k;
    evaluate(nodes, &k);
    return k;
  }

  /// Central differences of the force, column by column.
  ElementMatrix differences() const {
    ElementMatrix k;
    for (int j = 0; j < 20; ++j) {
      const ElementVector e = 1e-6 * ElementVector::Unit(j);
      k.col(j) = (evaluate(moved(e)).force - evaluate(moved(-e)).force) / 2e-6;
    }
    return k;
  }

  ShellLaw law;
  ElementNodes nodes;
  std::vector<LayerState> layers;
  std::vector<GaussState> gauss;
};

Element make_loaded(const ShellLaw& law, double stretch, double turn) {
  Element element(law);
  element.load(element.deform(stretch, turn));
  return element;
}

double calc_error(const ElementMatrix& k, const ElementMatrix& wanted) {
  return (k - wanted).norm() / wanted.norm();
}

/// Bent, with bending moments in it: only the whole tangent is the derivative of the force. What is left
/// out stands on the diagonal of the rotations and nowhere else.
TEST(ShellTreatment, DirectorStiffnessCompletesTheTangent) {
  const Element with = make_loaded(make_law(true, true), 0.001, 0.03),
                without = make_loaded(make_law(false, true), 0.001, 0.03);
  const ElementMatrix truth = with.differences();
  EXPECT_EQ((with.evaluate(with.nodes).force - without.evaluate(without.nodes).force).norm(), 0.0)
      << "forces are the same";
  EXPECT_LT(calc_error(with.tangent(), truth), 1e-7);
  EXPECT_GT(calc_error(without.tangent(), truth), 1e-5);
  const ElementMatrix rest = with.tangent() - without.tangent();
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      if (i == j && i % 5 >= 3) continue;
      EXPECT_EQ(rest(i, j), 0.0) << i << " " << j;
    }
  }
}

/// The second variation of a fibre is -(dalpha^2 + dbeta^2) V, so both rotations of a node get -m . V with
/// m = dW/dV. In bending by kappa z, z from -1 to 1 and kappa = t sin(turn) / l: a node has half of the
/// moment E'' w t^2/6 kappa per t/2 of fibre, m along x, and V_x = +-sin(turn): -E'' w t^3 sin^2(turn) / (12
/// l), and kappa^2 of that (1e-4) more. In stretch nothing hangs on the fibres.
TEST(ShellTreatment, DirectorStiffnessIsTheFibresShareOfTheMoment) {
  const double turn = 0.03;
  const ElementMatrix stretched = make_loaded(make_law(true, true), 0.004, 0.0).tangent() -
                                  make_loaded(make_law(false, true), 0.004, 0.0).tangent();
  const ElementMatrix bent = make_loaded(make_law(true, true), 0.0, turn).tangent() -
                             make_loaded(make_law(false, true), 0.0, turn).tangent();
  const double wanted =
      -kPlaneModulus * kWidth * std::pow(kThickness, 3) * std::pow(std::sin(turn), 2) / (12.0 * kLength);
  for (const Eigen::Index i : {3, 4, 8, 9, 13, 14, 18, 19}) {
    EXPECT_NEAR(stretched(i, i), 0.0, 1e-9 * std::abs(wanted));
    EXPECT_NEAR(bent(i, i), wanted, 1e-3 * std::abs(wanted)) << i;
  }
}

/// Without the square of the distance force and tangent still belong together.
TEST(ShellTreatment, TangentFitsWithoutCurvatureTerms) {
  const Element flat = make_loaded(make_law(true, false), 0.001, 0.03);
  EXPECT_LT(calc_error(flat.tangent(), flat.differences()), 1e-7);
  const Element whole = make_loaded(make_law(true, true), 0.001, 0.03);
  EXPECT_GT(calc_error(flat.tangent(), whole.tangent()), 1e-5);
}

/// In pure stretch of a flat sheet nothing is squared: both agree to the last digits. Their tangents do
/// not: c_2 = d . d carries the stress into the rotations.
TEST(ShellTreatment, CurvatureTermsRestInPureStretch) {
  const Element with = make_loaded(make_law(true, true), 0.004, 0.0),
                without = make_loaded(make_law(true, false), 0.004, 0.0);
  const ElementVector f = with.evaluate(with.nodes).force, g = without.evaluate(without.nodes).force;
  EXPECT_LT((f - g).norm(), 1e-14 * f.norm());
  // N = E/(1 - nu^2) ln(1.004) t w, as the sides are held; half of it at each node of an end.
  const double thickness = kThickness * std::pow(1.004, -kPoisson / (1.0 - kPoisson));
  const double pull = kPlaneModulus * std::log(1.004) * thickness * kWidth;
  EXPECT_NEAR(f[5], 0.5 * pull, 1e-5 * pull);
}

/// Ends turned while the mid-surface stays: with kappa as above the layer z is stretched by 1 + kappa z;
/// without the square by sqrt(1 + 2 kappa z). The pull per width is E'' times the integral of ln(stretch) by
/// what turns it into a force: -kappa^2 t/2 with, and -2/3 kappa^2 t without. The moments agree but for
/// kappa^3.
TEST(ShellTreatment, CurvatureTermsAreOfSecondOrderInBending) {
  double last = 0.0;
  for (const double turn : {0.08, 0.04, 0.02, 0.01}) {
    const double kappa = kThickness * std::sin(turn) / kLength;
    const auto bend = [&](bool curvature_terms) {
      const Element element(make_law(true, curvature_terms));
      return ElementVector(element.evaluate(element.deform(0.0, turn)).force);
    };
    const ElementVector with = bend(true), without = bend(false);
    const double scale = kPlaneModulus * kWidth * kThickness * kappa * kappa;
    EXPECT_NEAR(with[5] + with[10], -scale / 2.0, 2.0 * kappa * kappa * scale);
    EXPECT_NEAR(without[5] + without[10], -scale * 2.0 / 3.0, 5.0 * kappa * kappa * scale);
    const double moment = (with - without).tail<2>().norm() / with.tail<2>().norm();
    if (last > 0.0) {
      EXPECT_NEAR(std::log2(last / moment), 2.0, 0.05);
    }
    last = moment;
  }
}

}  // namespace
}  // namespace hydroscope
