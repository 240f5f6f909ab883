// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "solver/material/plane_stress.h"

namespace hydroscope {
namespace {

SheetMaterial make_m1() {
  SheetMaterial m;
  m.youngs_modulus = 206e3;
  m.poisson = 0.3;
  m.hardening.kind = Hardening::Kind::kSwift;
  m.hardening.k = 550;
  m.hardening.eps0 = 0.01;
  m.hardening.n = 0.2;
  return m;
}

SheetMaterial make_hill() {
  SheetMaterial m = make_m1();
  m.r0 = 1.8;
  m.r45 = 1.2;
  m.r90 = 2.1;
  return m;
}

TEST(Hardening, SlopesMatchFiniteDifferences) {
  Hardening swift = make_m1().hardening;
  Hardening voce;
  voce.kind = Hardening::Kind::kVoce;
  voce.yield = 200;
  voce.q = 150;
  voce.b = 12;
  Hardening table;
  table.kind = Hardening::Kind::kTable;
  table.table = {{0.0, 200}, {0.1, 300}, {0.4, 350}};
  for (const Hardening& h : {swift, voce, table}) {
    for (const double ep : {0.01, 0.07, 0.25}) {
      const double d = 1e-6;
      EXPECT_NEAR(h(ep).slope, (h(ep + d).stress - h(ep - d).stress) / (2 * d), 1e-5 * h(ep).slope);
    }
  }
  EXPECT_DOUBLE_EQ(table(0.05).stress, 250);
  EXPECT_DOUBLE_EQ(table(1.0).stress, 350);
}

/// The stress lies on the yield surface after any plastic increment.
TEST(J2, SatisfiesConsistency) {
  const SheetLaw law(make_m1());
  MaterialPoint point;
  for (int k = 0; k < 30; ++k) {
    const StressUpdate u = update_stress(law, point, Vec3(2e-3 * std::cos(0.3 * k), 1.5e-3, 1e-3 * std::sin(0.2 * k)));
    point = u.point;
    if (!u.is_plastic) continue;
    const double flow = law.material.hardening(point.plastic_strain).stress;
    EXPECT_NEAR(calc_equivalent_stress(law.yield_matrix, point.stress), flow, 1e-10 * flow);
  }
  EXPECT_GT(point.plastic_strain, 0.02);
}

class ConsistentTangent : public ::testing::TestWithParam<SheetMaterial> {};

TEST_P(ConsistentTangent, MatchesFiniteDifferences) {
  const SheetLaw law(GetParam());
  const MaterialPoint start = update_stress(law, {}, Vec3(4e-3, -1e-3, 2e-3)).point;
  const Vec3 step(3e-3, 2e-3, -1e-3);
  const Mat3 tangent = update_stress(law, start, step).tangent;
  for (int j = 0; j < 3; ++j) {
    const double d = 1e-7;
    const Vec3 e = d * Vec3::Unit(j);
    const Vec3 difference =
        (update_stress(law, start, step + e).point.stress - update_stress(law, start, step - e).point.stress) / (2 * d);
    EXPECT_LT((difference - tangent.col(j)).norm(), 1e-6 * law.elasticity.norm());
  }
  EXPECT_LT((tangent - tangent.transpose()).norm(), 1e-9 * tangent.norm());
}

INSTANTIATE_TEST_SUITE_P(Materials, ConsistentTangent, ::testing::Values(make_m1(), make_hill()));

/// Ratio of yield stresses of planar anisotropy (mechanics 2.3) by loading to first yield.
TEST(Hill48, YieldsByItsFormulas) {
  SheetMaterial m = make_hill();
  m.hardening.kind = Hardening::Kind::kPerfect;
  m.hardening.yield = 200;
  const Mat3 p = m.calc_yield_matrix();
  const double s0 = 1.0 / calc_equivalent_stress(p, Vec3(1, 0, 0));
  const double s90 = 1.0 / calc_equivalent_stress(p, Vec3(0, 1, 0));
  const double sb = 1.0 / calc_equivalent_stress(p, Vec3(1, 1, 0));
  EXPECT_NEAR(s90 / s0, std::sqrt(m.r90 * (1 + m.r0) / (m.r0 * (1 + m.r90))), 1e-12);
  const double expected = 1 - 2 * m.r0 / (1 + m.r0) + m.r0 * (1 + m.r90) / (m.r90 * (1 + m.r0));
  EXPECT_NEAR(sb / s0, 1 / std::sqrt(expected), 1e-12);
}

/// Uniaxial tension at 0 degrees: the width strain follows the Lankford value, R0 = e22 / e33.
TEST(Hill48, LankfordValueComesOut) {
  const SheetLaw law(make_hill());
  MaterialPoint point;
  double width = 0.0, length = 0.0;
  for (int k = 0; k < 200; ++k) {
    double lateral = -1e-4 * 1.8 / 2.8;
    for (int i = 0; i < 20; ++i) {  // find the lateral strain that leaves s22 = 0
      const StressUpdate u = update_stress(law, point, Vec3(1e-3, lateral, 0));
      lateral -= u.point.stress[1] / u.tangent(1, 1);
    }
    point = update_stress(law, point, Vec3(1e-3, lateral, 0)).point;
    width += lateral;
    length += 1e-3;
  }
  EXPECT_NEAR(point.stress[1], 0.0, 1e-6);
  const double e22 = width + law.material.poisson * point.stress[0] / law.material.youngs_modulus;
  const double e11 = length - point.stress[0] / law.material.youngs_modulus;
  EXPECT_NEAR(e22 / -(e11 + e22), 1.8, 1e-6);
}

/// J2 does not feel a hydrostatic shift: a change of sigma33 with the strain it causes leaves s unchanged.
TEST(ThroughWallStress, HydrostaticShiftCausesNoFlow) {
  const SheetLaw law(make_m1());
  const MaterialPoint start = update_stress(law, {}, Vec3(5e-3, 2e-3, 0)).point;
  const double shift = -40.0;
  const double strain = (1 - 2 * 0.3) / 206e3 * shift;
  const StressUpdate u = update_stress(law, start, Vec3(strain, strain, 0), shift);
  EXPECT_LT((u.point.stress - start.stress).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(u.point.plastic_strain, start.plastic_strain);
}

}  // namespace
}  // namespace hydroscope
