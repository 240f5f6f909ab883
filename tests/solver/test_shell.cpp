// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/base/error.h"
#include "solver/shell/shell_element.h"

namespace hydroscope {
namespace {

/// A curved, distorted element with layers, and its stress after a few increments.
struct Patch {
  ShellLaw law;
  ElementNodes nodes;
  std::vector<LayerState> layers;
  std::vector<GaussState> gauss;

  explicit Patch(bool is_plastic = true) {
    SheetMaterial m;
    m.youngs_modulus = 206e3;
    m.poisson = 0.3;
    if (is_plastic) m.hardening = {Hardening::Kind::kSwift, 0, 550, 0.01, 0.2, 0, 0, {}};
    law = {SheetLaw(m), make_thickness_rule("gauss", 5)};
    const double r = 30.0;
    const std::array<double, 4> angle{0.0, 0.11, 0.12, -0.01}, z{0.0, 0.3, 3.1, 2.8};
    for (std::size_t a = 0; a < 4; ++a) {
      nodes.x[a] = Vec3(r * std::cos(angle[a]), r * std::sin(angle[a]), z[a]);
      const Vec3 v(std::cos(angle[a]), std::sin(angle[a]), 0.02 * static_cast<double>(a));
      nodes.triad[a].v = v.normalized();
      nodes.triad[a].v1 = Vec3::UnitZ().cross(nodes.triad[a].v).normalized();
      nodes.triad[a].v2 = nodes.triad[a].v.cross(nodes.triad[a].v1);
      nodes.thickness[a] = 1.5 - 0.05 * static_cast<double>(a);
    }
    layers.resize(20);
    gauss.resize(4);
    initialise_element(nodes, Vec3::UnitZ(), law.rule, {layers, gauss});
  }

  ElementResponse evaluate(const ElementNodes& end, std::vector<LayerState>& l, std::vector<GaussState>& g,
                           ElementMatrix* k, const ElementSettings& settings = {}) const {
    l.resize(20);
    g.resize(4);
    return evaluate_element(law, nodes, end, {layers, gauss}, settings, {l, g}, k);
  }

  void load(const ElementVector& q) {
    ElementNodes end = moved(nodes, q);
    std::vector<LayerState> l;
    std::vector<GaussState> g;
    evaluate(end, l, g, nullptr);
    nodes = end;
    layers = l;
    gauss = g;
  }

  static ElementNodes moved(const ElementNodes& from, const ElementVector& q) {
    ElementNodes to = from;
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
};

ElementVector make_load(double size) {
  ElementVector q;
  for (int i = 0; i < 20; ++i) q[i] = size * std::sin(1.7 * i + 0.3) * (i % 5 < 3 ? 1.0 : 0.3);
  return q;
}

/// About a zero increment with all points plastic: material, initial stress and director terms.
TEST(ShellTangent, MatchesFiniteDifferencesAboutAZeroIncrement) {
  Patch patch;
  for (int k = 0; k < 3; ++k) patch.load(make_load(0.02));
  ElementMatrix stiffness;
  std::vector<LayerState> l;
  std::vector<GaussState> g;
  const ElementVector direction = make_load(1.0);  // keeps loading: the state continues to flow
  patch.evaluate(Patch::moved(patch.nodes, 1e-9 * direction), l, g, &stiffness);
  EXPECT_LT((stiffness - stiffness.transpose()).norm(), 1e-10 * stiffness.norm());
  // Differences of second order from the loading side: f(d) = f0 + K d + O(d^2).
  const double d = 2e-6;
  const auto force = [&](double s) {
    return ElementVector(patch.evaluate(Patch::moved(patch.nodes, s * direction), l, g, nullptr).force);
  };
  const ElementVector difference = (4.0 * force(d) - force(2 * d) - 3.0 * force(1e-12)) / (2 * d);
  EXPECT_LT((difference - stiffness * direction).norm(), 1e-5 * (stiffness * direction).norm());
}

/// Elastic under initial stress: every column, central differences, 1e-6.
TEST(ShellTangent, EveryColumnMatchesUnderInitialStress) {
  Patch patch(false);
  patch.load(make_load(0.05));
  ElementMatrix stiffness;
  std::vector<LayerState> l;
  std::vector<GaussState> g;
  patch.evaluate(patch.nodes, l, g, &stiffness);
  for (int j = 0; j < 20; ++j) {
    const double d = 1e-6;
    const ElementVector e = d * ElementVector::Unit(j);
    const ElementVector difference = (patch.evaluate(Patch::moved(patch.nodes, e), l, g, nullptr).force -
                                      patch.evaluate(Patch::moved(patch.nodes, -e), l, g, nullptr).force) /
                                     (2 * d);
    ElementVector residual = difference - stiffness.col(j);
    // Rotations are not a vector space: about a nonzero moment the second variation is symmetric only
    // up to the drilling part, which the five-parameter update leaves out.
    EXPECT_LT(residual.norm(), 1e-6 * stiffness.col(j).norm()) << "column " << j;
  }
}

/// A rigid motion of any size strains nothing and only turns the forces (V14).
TEST(Shell, RigidMotionCausesNoStrain) {
  Patch patch;
  patch.load(make_load(0.02));
  std::vector<LayerState> l;
  std::vector<GaussState> g;
  const ElementVector before = patch.evaluate(patch.nodes, l, g, nullptr).force;
  const Mat3 turn = Eigen::AngleAxisd(2.2, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  ElementNodes end = patch.nodes;
  for (std::size_t a = 0; a < 4; ++a) {
    end.x[a] = turn * end.x[a] + Vec3(5, -3, 2);
    end.triad[a] = {turn * end.triad[a].v1, turn * end.triad[a].v2, turn * end.triad[a].v};
  }
  const ElementResponse r = patch.evaluate(end, l, g, nullptr);
  EXPECT_LT(r.strain_increment, 1e-13);
  for (int a = 0; a < 4; ++a) {
    EXPECT_LT((r.force.segment<3>(5 * a) - turn * before.segment<3>(5 * a)).norm(), 1e-9 * before.norm());
  }
}

/// Internal forces of one element balance, stress or no stress.
TEST(Shell, ForcesAndMomentsBalance) {
  Patch patch;
  patch.load(make_load(0.05));
  std::vector<LayerState> l;
  std::vector<GaussState> g;
  const ElementVector f = patch.evaluate(patch.nodes, l, g, nullptr).force;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (std::size_t a = 0; a < 4; ++a) {
    const auto at = static_cast<Eigen::Index>(5 * a);
    const Triad& t = patch.nodes.triad[a];
    force += f.segment<3>(at);
    moment += patch.nodes.x[a].cross(Vec3(f.segment<3>(at))) + f[at + 3] * t.v1 + f[at + 4] * t.v2;
  }
  EXPECT_LT(force.norm(), 1e-10 * f.norm());
  EXPECT_LT(moment.norm(), 1e-8 * f.norm());
}

/// V13: hypoelastic simple shear of a layer with Jaumann's rate.
TEST(Layer, SimpleShearFollowsJaumann) {
  SheetMaterial m;
  m.youngs_modulus = 2.6;
  m.poisson = 0.3;
  const SheetLaw law(m);
  LayerState state;
  const int n = 2000;
  const auto metric = [](double gamma) { return Metric{1.0, 1.0 + gamma * gamma, gamma}; };  // g1 = e1, g2 = e2 + gamma e1
  LayerResponse r;
  for (int k = 0; k < n; ++k) {
    r = advance_layer(law, state, metric(1.0 * k / n), metric(1.0 * (k + 1) / n), 0.0, 0.0, TangentKind::kConsistent);
    state = r.state;
  }
  // To Cartesian axes: the frame has turned by `angle` from g1 = e1.
  const double c = std::cos(state.angle), s = std::sin(state.angle);
  const Vec3 t = state.point.stress;
  const double t12 = c * s * (t[0] - t[1]) + (c * c - s * s) * t[2];
  const double t11 = c * c * t[0] + s * s * t[1] - 2 * c * s * t[2];
  EXPECT_NEAR(t12 / m.shear_modulus(), std::sin(1.0), 1e-6);
  EXPECT_NEAR(t11 / m.shear_modulus(), 1.0 - std::cos(1.0), 1e-6);
}

/// Rules integrate polynomials up to their degree.
TEST(ThicknessRule, IntegratesPolynomials) {
  const auto check = [](const ThicknessRule& rule, int degree) {
    for (int d = 0; d <= degree; ++d) {
      double sum = 0.0;
      for (int i = 0; i < rule.size(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        sum += rule.weight[k] * std::pow(rule.zeta[k], d);
      }
      EXPECT_NEAR(sum, d % 2 == 0 ? 1.0 / (d + 1) : 0.0, 1e-14) << rule.size() << " points, degree " << d;
    }
  };
  for (int n = 1; n <= 9; ++n) check(make_thickness_rule("gauss", n), 2 * n - 1);
  for (int n = 3; n <= 9; ++n) check(make_thickness_rule("lobatto", n), 2 * n - 3);
  for (int n = 3; n <= 9; n += 2) check(make_thickness_rule("simpson", n), 3);
  for (int n = 2; n <= 8; n += 2) check(make_thickness_rule("split_gauss", n), n - 1);
  EXPECT_THROW(make_thickness_rule("simpson", 4), InputError);
  EXPECT_THROW(make_thickness_rule("tea", 4), InputError);
}

}  // namespace
}  // namespace hydroscope
