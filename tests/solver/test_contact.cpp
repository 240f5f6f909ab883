// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "solver/contact/constraint.h"
#include "solver/geometry/analytic_surface.h"
#include "solver/system/node_basis.h"

namespace hydroscope {
namespace {

using Stiffness = Eigen::Matrix<double, kDofs, kDofs>;

Triad make_triad(const Vec3& director) {
  Triad t;
  t.v = director.normalized();
  t.v1 = t.v.cross(Vec3(0.3, -0.5, 0.9)).normalized();
  t.v2 = t.v.cross(t.v1);
  return t;
}

/// A node against a surface, and how it moves with its five degrees of freedom.
struct Node {
  Vec3 x;
  SlavePoint slave;

  Vec3 point() const { return x + slave.offset * slave.triad.v; }
  Node moved(const NodeVector& q) const {
    Node to = *this;
    to.x += q.head<3>();
    Triad& t = to.slave.triad;
    const Vec3 theta = q[3] * t.v1 + q[4] * t.v2;
    if (theta.norm() == 0.0) return to;
    const Mat3 turn = Eigen::AngleAxisd(theta.norm(), theta.normalized()).toRotationMatrix();
    t = {turn * t.v1, turn * t.v2, turn * t.v};
    return to;
  }
};

FootPoint find_foot(const ToolSurface& surface, const Vec3& x) {
  SearchHint hint;
  const auto foot = surface.find_foot_point(x, 50.0, 50.0, hint);
  EXPECT_TRUE(foot.has_value());
  return foot.value_or(FootPoint{});
}

/// Largest difference between calc_contact_stiffness() and minus the central differences of
/// J^T (t_N n(x_c)), relative to the matrix. Step 1e-5 mm of a radius of about 10 mm: truncation 1e-12,
/// rounding 1e-11.
double calc_tangent_error(const ToolSurface& surface, const Node& node, double normal_force) {
  const auto force = [&](const Node& n) {
    return NodeVector(n.slave.calc_map().transpose() * (normal_force * find_foot(surface, n.point()).normal));
  };
  const Stiffness k =
      calc_contact_stiffness(node.slave, find_foot(surface, node.point()), normal_force, {}, true, false);
  Stiffness difference;
  constexpr double kStep = 1e-5;
  for (int j = 0; j < kDofs; ++j) {
    const NodeVector q = kStep * NodeVector::Unit(j);
    difference.col(j) = -(force(node.moved(q)) - force(node.moved(-q))) / (2 * kStep);
  }
  return (k - difference).norm() / k.norm();
}

const Pose kPose = make_pose({20.0, -35.0, 50.0}, {3.0, -2.0, 1.0});

TEST(ContactTangent, MatchesDifferencesOnCylinders) {
  for (const Side side : {Side::inside, Side::outside}) {
    const CylinderSurface surface(kPose, 12.0, side, 50.0);
    for (const double radius : {11.5, 12.0, 12.3}) {  // also off the surface: 1/R becomes 1/(R + g)
      const Vec3 radial = kPose.place_direction(Vec3(std::cos(0.7), std::sin(0.7), 0.0));
      const double offset = side == Side::inside ? 0.75 : -0.75;
      Node node{Vec3::Zero(), {make_triad(radial + Vec3(0.05, 0.02, -0.04)), offset}};
      node.x = kPose.place_point(Vec3(0, 0, 4)) + radius * radial - offset * node.slave.triad.v;
      EXPECT_LT(calc_tangent_error(surface, node, 250.0), 1e-8) << "radius " << radius;
    }
  }
}

TEST(ContactTangent, MatchesDifferencesOnATorus) {
  for (const Side side : {Side::inside, Side::outside}) {
    const TorusSurface surface(kPose, 20.0, 6.0, side);
    for (const double around : {0.4, 2.3}) {  // outer (convex both ways) and inner (saddle) half
      const Vec3 local((20 + 6.1 * std::cos(around)) * std::cos(0.6),
                       (20 + 6.1 * std::cos(around)) * std::sin(0.6), 6.1 * std::sin(around));
      const Vec3 at = kPose.place_point(local);
      Node node{at, {make_triad(find_foot(surface, at).normal + Vec3(0.03, -0.02, 0.05)), -0.6}};
      node.x -= node.slave.offset * node.slave.triad.v;
      EXPECT_LT(calc_tangent_error(surface, node, 90.0), 1e-8) << "around " << around;
    }
  }
}

/// The gap row is the derivative of the gap.
TEST(ContactTangent, GapRowMatchesDifferences) {
  const CylinderSurface surface(kPose, 12.0, Side::inside, 50.0);
  const Vec3 radial = kPose.place_direction(Vec3(std::cos(0.7), std::sin(0.7), 0.0));
  const Node node{kPose.place_point(Vec3(0, 0, 4)) + 11.0 * radial,
                  {make_triad(radial + Vec3(0.05, 0.2, -0.04)), 0.75}};
  const NodeVector row = calc_gap_row(node.slave, find_foot(surface, node.point()).normal);
  for (int j = 0; j < kDofs; ++j) {
    const NodeVector q = 1e-5 * NodeVector::Unit(j);
    const double high = find_foot(surface, node.moved(q).point()).gap,
                 low = find_foot(surface, node.moved(-q).point()).gap;
    EXPECT_NEAR((high - low) / 2e-5, row[j], 1e-9) << "column " << j;  // rounding 1e-15 / 1e-5
  }
}

/// V17: a node with a horizontal spring k, pressed by a dead vertical force F onto a cylinder R.
/// Returns the stiffness against a horizontal force in the tangent plane.
double calc_sliding_stiffness(Side side, double spring, double force, double radius) {
  const CylinderSurface surface(Pose{}, radius, side, 50.0);
  const Vec3 at(0.0, side == Side::outside ? radius : -radius, 0.0);  // top of a hill, bottom of a bowl
  SlavePoint slave;
  const FootPoint foot = find_foot(surface, at);
  EXPECT_LT((foot.normal - Vec3::UnitY()).norm(), 1e-15);
  Stiffness k = calc_contact_stiffness(slave, foot, force, {}, true, true);
  k(0, 0) += spring;
  NodeBasis basis;
  basis.add_row(calc_gap_row(slave, foot.normal), -foot.gap);
  basis.add_row(NodeVector::Unit(2), 0.0);
  basis.add_row(NodeVector::Unit(3), 0.0);
  basis.add_row(NodeVector::Unit(4), 0.0);
  basis.finish();
  const Stiffness local = basis.transform().transpose() * k * basis.transform();
  return local(4, 4);  // the one free degree of freedom
}

TEST(ContactTangent, ConvexSoftensAndConcaveStiffens) {
  constexpr double kSpring = 5.0, kForce = 40.0, kRadius = 10.0;
  EXPECT_NEAR(calc_sliding_stiffness(Side::outside, kSpring, kForce, kRadius), kSpring - kForce / kRadius,
              1e-12);
  EXPECT_NEAR(calc_sliding_stiffness(Side::inside, kSpring, kForce, kRadius), kSpring + kForce / kRadius,
              1e-12);
  EXPECT_LT(calc_sliding_stiffness(Side::outside, 0.9 * kForce / kRadius, kForce, kRadius),
            0.0);  // slides off
}

/// The same number from the energy of a node that follows the surface, k u^2 / 2 + F y: what makes the
/// sign of V17 a fact and not a convention. Second differences of width 1e-3: 1e-8 of truncation.
TEST(ContactTangent, EnergyAlongTheSurfaceHasThatStiffness) {
  constexpr double kSpring = 5.0, kForce = 40.0, kRadius = 10.0, kStep = 1e-3;
  for (const double bend : {-1.0, 1.0}) {  // hill, bowl
    const auto energy = [&](double u) {
      return 0.5 * kSpring * u * u - kForce * bend * std::sqrt(kRadius * kRadius - u * u);
    };
    const double stiffness = (energy(kStep) - 2 * energy(0.0) + energy(-kStep)) / (kStep * kStep);
    const Side side = bend < 0 ? Side::outside : Side::inside;
    EXPECT_NEAR(stiffness, calc_sliding_stiffness(side, kSpring, kForce, kRadius), 1e-6);
  }
}

/// Without curvature only the fibre's second variation is left; with a flat tool as well.
TEST(ContactTangent, CurvatureCanBeLeftOut) {
  const CylinderSurface surface(Pose{}, 10.0, Side::inside, 50.0);
  SlavePoint slave{make_triad(Vec3::UnitX()), 0.75};
  const FootPoint foot = find_foot(surface, Vec3(10, 0, 0));
  const Stiffness k = calc_contact_stiffness(slave, foot, 100.0, {}, false, true);
  EXPECT_EQ((k.topLeftCorner<3, kDofs>().norm()), 0.0);
  EXPECT_NEAR(k(3, 3), -75.0, 1e-12);  // outward fibre, force inwards
}

// ---------------------------------------------------------------- friction (V23)

const Vec3 kNormal = Vec3(0.2, -0.4, 0.7).normalized();
const Vec3 kAlong = kNormal.cross(Vec3::UnitX()).normalized();
constexpr double kStick = 1e4, kMu = 0.1, kPress = 300.0;  // slips after 3e-3 mm

TEST(Friction, RisesWithStickStiffnessThenStaysAtTheLimit) {
  for (const double slide : {1e-4, 1e-3, 2.999e-3}) {
    const FrictionResult f = calc_friction(Vec3::Zero(), slide * kAlong, kNormal, kPress, kMu, kStick);
    EXPECT_FALSE(f.is_slipping);
    EXPECT_LT((f.force + kStick * slide * kAlong).norm(), 1e-12 * kMu * kPress);
  }
  for (const double slide : {3.001e-3, 0.1, 50.0}) {
    const FrictionResult f = calc_friction(Vec3::Zero(), slide * kAlong, kNormal, kPress, kMu, kStick);
    EXPECT_TRUE(f.is_slipping);
    EXPECT_LT((f.force + kMu * kPress * kAlong).norm(), 1e-12 * kMu * kPress);
  }
}

/// Many increments from the last force: it reaches the limit, stays, and follows reversal elastically.
TEST(Friction, IncrementsAddUp) {
  Vec3 force = Vec3::Zero();
  const auto slide = [&](double by) {
    force = calc_friction(force, by * kAlong, kNormal, kPress, kMu, kStick).force;
  };
  for (int i = 0; i < 7; ++i) slide(4e-4);
  EXPECT_NEAR(force.dot(kAlong), -28.0, 1e-11);
  for (int i = 0; i < 20; ++i) {
    slide(4e-4);
    EXPECT_NEAR(force.norm(), 30.0, 3e-11);
  }
  slide(-1e-3);
  EXPECT_NEAR(force.dot(kAlong), -20.0, 1e-11);
  for (int i = 0; i < 20; ++i) slide(-1e-3);
  EXPECT_NEAR(force.dot(kAlong), 30.0, 3e-11);
}

/// Lying in the tangent plane and against the motion, whatever part of the motion is normal.
TEST(Friction, IsTangentialAndOpposesSliding) {
  const Vec3 across = kNormal.cross(kAlong), motion = 0.4 * kAlong - 0.3 * across + 0.8 * kNormal;
  const FrictionResult f = calc_friction(Vec3::Zero(), motion, kNormal, kPress, kMu, kStick);
  EXPECT_NEAR(f.force.dot(kNormal), 0.0, 1e-12);
  EXPECT_LT((f.force + 30.0 * (0.8 * kAlong - 0.6 * across)).norm(), 3e-11);
}

TEST(Friction, NoneWithoutFrictionOrPressure) {
  EXPECT_EQ(calc_friction(Vec3::Zero(), kAlong, kNormal, kPress, 0.0, kStick).force.norm(), 0.0);
  EXPECT_EQ(calc_friction(Vec3::Zero(), kAlong, kNormal, -5.0, kMu, kStick).force.norm(), 0.0);
  EXPECT_EQ(calc_friction(10.0 * kAlong, kAlong, kNormal, 0.0, kMu, kStick).force.norm(), 0.0);
}

/// The stiffness is minus the derivative of the force, sticking and slipping. Step 1e-8 of a slide of
/// about 1e-3: truncation 1e-10.
TEST(Friction, StiffnessMatchesDifferences) {
  const Vec3 across = kNormal.cross(kAlong), start = 12.0 * across;
  for (const double size : {5e-4, 8e-3}) {
    const Vec3 slide = size * (0.9 * kAlong + 0.2 * across);
    const FrictionResult f = calc_friction(start, slide, kNormal, kPress, kMu, kStick);
    EXPECT_EQ(f.is_slipping, size > 1e-3);
    EXPECT_LT((f.stiffness - f.stiffness.transpose()).norm(), 1e-14 * f.stiffness.norm());
    for (int j = 0; j < 3; ++j) {
      const Vec3 d = 1e-8 * Vec3::Unit(j);
      const Vec3 difference = (calc_friction(start, slide + d, kNormal, kPress, kMu, kStick).force -
                               calc_friction(start, slide - d, kNormal, kPress, kMu, kStick).force) /
                              2e-8;
      EXPECT_LT((difference + f.stiffness.col(j)).norm(), 1e-6 * kStick) << "column " << j;
    }
  }
}

/// V18: turned along through 90 degrees in steps, a tangential force keeps its size.
TEST(Friction, TransportKeepsTheSize) {
  Vec3 force(0, 7, 0);
  for (int i = 1; i <= 18; ++i) {
    const double angle = 5.0 * i * std::acos(-1.0) / 180.0;
    force = transport_tangential(force, Vec3(std::cos(angle), std::sin(angle), 0));
  }
  EXPECT_LT((force - Vec3(-7, 0, 0)).norm(), 1e-13);
  EXPECT_EQ(transport_tangential(Vec3::Zero(), kNormal).norm(), 0.0);
}

}  // namespace
}  // namespace hydroscope
