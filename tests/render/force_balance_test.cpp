// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/force_balance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hydroscope {
namespace {

/// A square plate of 2 x 2 quads under pressure, borne by a tool in its middle and by its corners.
class Balance : public testing::Test {
 protected:
  Balance() {
    model->quads = {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8, 7}};
    model->tools.resize(1);
    s.model = model;
    s.pressure = 2.0;
    for (int i = 0; i < 9; ++i) {
      s.points.emplace_back(10.0 * (i % 3), 10.0 * (i / 3), 0.0);
      s.directors.emplace_back(0, 0, 1);
    }
    s.thickness.assign(9, 1.0);
    s.contact_state.assign(9, ContactClass::kFree);
    s.contact_tool.assign(9, -1);
    s.contact_force.assign(9, Vec3::Zero());
    s.support_force.assign(9, Vec3::Zero());
    // 2 MPa on 20 mm x 20 mm: 800 N.
    s.contact_state[4] = ContactClass::kStick;
    s.contact_tool[4] = 0;
    s.contact_force[4] = Vec3(0, 0, -500);
    s.tool_force = {Vec3(0, 0, -500)};
    for (std::size_t corner : {0, 2, 6, 8}) s.support_force[corner] = Vec3(0, 0, -75);
  }
  std::shared_ptr<SnapshotModel> model = std::make_shared<SnapshotModel>();
  Snapshot s;
};

TEST_F(Balance, ClosesInEquilibrium) {
  const ForceBalance balance = calc_force_balance(s);
  EXPECT_EQ(balance.pressure, Vec3(0, 0, 800));
  EXPECT_EQ(balance.contact, Vec3(0, 0, -500));
  EXPECT_EQ(balance.support, Vec3(0, 0, -300));
  EXPECT_EQ(balance.rest, Vec3::Zero());
  EXPECT_EQ(balance.scale, 800.0);
  EXPECT_EQ(balance.contact_error, 0.0);
  EXPECT_EQ(balance.contradicting_nodes, 0);
}

TEST_F(Balance, ALostContactIsMissing) {
  s.contact_force[4].setZero();
  s.contact_state[4] = ContactClass::kFree;
  s.contact_tool[4] = -1;
  const ForceBalance balance = calc_force_balance(s);
  EXPECT_EQ(balance.rest_share(), 500.0 / 800.0);
  EXPECT_EQ(balance.contact_error_share(), 500.0 / 800.0);
  EXPECT_EQ(balance.contradicting_nodes, 0) << "the node does not contradict itself, but the sum does";
}

TEST_F(Balance, NodesThatContradictThemselvesAreCounted) {
  s.contact_state[4] = ContactClass::kFree;         // a force without touching
  s.contact_state[0] = ContactClass::kSlip;         // touching without a tool
  s.contact_tool[1] = 0;                            // a tool without touching
  s.contact_state[2] = ContactClass::kDetachedNow;  // fine
  EXPECT_EQ(calc_force_balance(s).contradicting_nodes, 3);
}

TEST_F(Balance, WhatIsNotKnownIsNoNumber) {
  s.support_force.clear();
  s.tool_force.clear();
  const ForceBalance balance = calc_force_balance(s);
  EXPECT_FALSE(balance.is_support_known);
  EXPECT_TRUE(std::isnan(balance.rest_share()));
  EXPECT_TRUE(std::isnan(balance.contact_error_share()));
}

TEST_F(Balance, PressureOnTheInnerFaceHasItsArea) {
  // Directors that lean outwards: the inner face is 2 x 0.05 mm narrower each way.
  for (std::size_t i = 0; i < 9; ++i)
    s.directors[i] = Vec3(0.1 * (s.points[i].x() / 10.0 - 1.0), 0.1 * (s.points[i].y() / 10.0 - 1.0), 1.0);
  model->is_pressure_inside = true;
  EXPECT_NEAR(calc_force_balance(s).pressure.z(), 2.0 * 19.9 * 19.9, 1e-10);
}

}  // namespace
}  // namespace hydroscope
