// SPDX-License-Identifier: GPL-3.0-or-later
// Treatments of the turning normal: what each puts into the tangent.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "model_texts.h"
#include "solver/geometry/mesh_surface.h"
#include "tests/geometry/test_shapes.h"

namespace hydroscope {
namespace {

constexpr double kRadius = 30.77;  // of the die [mm]

/// Tube T as a slice, pressed into a round die; elastic.
const std::string kSlice = test::kTubeT + R"(length_mm = 3
extent = "slice"
elements_around = 7
)" + test::kElastic + R"([load]
pressure_MPa = [[0, 0], [1, 60]]
[tool.die]
shape = "cylinder"
radius_mm = 30.77
[increment]
largest = 0.2
initial_s = 0.2
tolerance = 1e-8
)";

/// The die as a mesh, node normals averaged, points moved by `shift`; seen from inside.
std::shared_ptr<const ToolSurface> make_meshed_die(int facets, int rings,
                                                   const std::function<Vec3(const Vec3&)>& shift) {
  TriangleMesh mesh = make_grid_mesh(facets + 1, rings, [&](int i, int j) {
    const double angle = 2.0 * std::numbers::pi * (i % facets + 0.31) / facets;
    return Vec3(kRadius * std::cos(angle), kRadius * std::sin(angle), 14.0 - 28.0 * j / (rings - 1));
  });
  for (Vec3& x : mesh.points) x = shift(x);
  const auto surface = std::make_shared<MeshSurface>(mesh);
  SearchHint hint;
  const auto foot = surface->find_foot_point(Vec3(kRadius - 0.4, 0, 0), 5.0, 5.0, hint);
  if (!foot || foot->normal.x() > 0.0) throw std::runtime_error("the die is seen from outside");
  return surface;
}

/// Node blocks of contact at the pressed state of the exact die, with one treatment.
class Blocks {
 public:
  explicit Blocks(const std::string& curvature, std::shared_ptr<const ToolSurface> die = nullptr,
                  double known_radius = 0.0)
      : model_(test::make_model(kSlice)), state_(make_initial_state(model_)) {
    {
      Scratch scratch(model_, 1);
      const IncrementReport report = test::run_to_end(model_, state_, scratch);
      EXPECT_EQ(state_.time, model_.end_time) << report.message;
    }
    model_.curvature = test::make_model(kSlice, {"contact.curvature=" + curvature}).curvature;
    if (die) model_.tools[0].surface = die;
    model_.tools[0].known_radius = known_radius;
    Scratch scratch(model_, 1);
    const Loads loads{state_.time, state_.pressure};
    start_trial(state_, scratch);
    evaluate(model_, state_, loads, {.freeze_thickness = true, .with_stiffness = true}, scratch);
    evaluate_contacts(model_, state_, loads, true, scratch);
    block = scratch.node_blocks;
    contact = scratch.trial.contacts[0];
    EXPECT_EQ(contact.size(), 16U);
    for (const ContactPoint& c : contact) EXPECT_TRUE(c.is_active() && c.normal_force > 1.0);
  }
  std::vector<NodeBlock> block;
  std::vector<ContactPoint> contact;

 private:
  Model model_;
  State state_;
};

Vec3 find_around(const ContactPoint& c) { return Vec3::UnitZ().cross(c.foot.normal).normalized(); }

/// Stiffness of a node against a move along `d`.
double along(const Blocks& b, std::size_t i, const Vec3& d) {
  return d.dot(b.block[i].topLeftCorner<3, 3>() * d);
}

double calc_asymmetry(const Blocks& b) {
  double largest = 0.0;
  for (const NodeBlock& k : b.block) largest = std::max(largest, (k - k.transpose()).norm() / k.norm());
  return largest;
}

/// Largest difference between the blocks of two treatments, against t_N/R.
double compare(const Blocks& a, const Blocks& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.block.size(); ++i) {
    largest = std::max(largest, (a.block[i] - b.block[i]).norm() / (a.contact[i].normal_force / kRadius));
  }
  return largest;
}

/// (4.22): t_N/rho on the diagonal around, nothing along the axis or across; without the treatment nothing.
/// A concave tool stiffens. On an exact tool the foot point stands on the surface: rho is the die's radius.
TEST(CurvatureTreatment, KnownRadiusPutsForceOverRadiusAround) {
  const Blocks none("none"), known("known-radius");
  for (std::size_t i = 0; i < known.block.size(); ++i) {
    const Vec3 n = known.contact[i].foot.normal, around = find_around(known.contact[i]);
    const double wanted = known.contact[i].normal_force / (kRadius - known.contact[i].foot.gap);
    EXPECT_NEAR(along(known, i, around), wanted, 1e-10 * wanted);
    EXPECT_NEAR(along(known, i, Vec3::UnitZ()), 0.0, 1e-12 * wanted);
    EXPECT_NEAR(along(known, i, n), 0.0, 1e-12 * wanted);
    EXPECT_EQ((none.block[i].topLeftCorner<3, 3>().norm()), 0.0);
    EXPECT_NE(none.block[i](3, 3), 0.0) << "the fibre that carries the force stays";
  }
  EXPECT_GT(compare(known, none), 0.9);
}

/// On an exact surface dn/dx is symmetric and known: three treatments are one.
TEST(CurvatureTreatment, OnExactToolsAllButNoneAgree) {
  const Blocks known("known-radius"), symmetric("symmetric"), full("full");
  EXPECT_LT(compare(symmetric, full), 1e-12);
  EXPECT_LT(compare(known, full), 1e-12);
  EXPECT_LT(calc_asymmetry(full), 1e-14);
}

/// On a mesh of coarse facets, 15 degrees each. A radius that is given is taken as it is, around alone. With
/// N_a,i V_a instead, prisms between radial normals are radial: 1/R of where the point is.
TEST(CurvatureTreatment, KnownRadiusOnAMesh) {
  const auto die = make_meshed_die(24, 5, [](const Vec3& x) { return x; });
  const Blocks known("known-radius", die, kRadius), interpolated("symmetric", die);
  for (std::size_t i = 0; i < known.block.size(); ++i) {
    const Vec3 around = find_around(known.contact[i]);
    const double there = known.contact[i].normal_force / known.contact[i].position.head<2>().norm(),
                 wanted = known.contact[i].normal_force / kRadius;
    EXPECT_NEAR(along(known, i, around), wanted, 1e-9 * wanted);
    EXPECT_NEAR(along(known, i, Vec3::UnitZ()), 0.0, 1e-9 * wanted);
    EXPECT_NEAR(along(interpolated, i, around), there, 1e-9 * wanted);
  }
  // Half the radius, twice the stiffness.
  const Blocks half("known-radius", die, 0.5 * kRadius);
  EXPECT_NEAR(along(half, 3, find_around(half.contact[3])) / along(known, 3, find_around(half.contact[3])),
              2.0, 1e-9);
}

/// Averaged normals of uneven facets: dn/dx is no shape operator. "full" keeps what is unsymmetric,
/// "symmetric" is its symmetric part, and nothing else of the block differs.
TEST(CurvatureTreatment, FullIsUnsymmetricOnAveragedNormals) {
  test::Dice dice(7);
  const auto die = make_meshed_die(72, 13, [&](const Vec3& x) {
    return Vec3(kRadius * (x + 0.5 * dice.direction()).cwiseProduct(Vec3(1, 1, 0)).normalized() +
                x.z() * Vec3::UnitZ() + 0.02 * dice.direction());
  });
  const Blocks full("full", die), symmetric("symmetric", die);
  EXPECT_GT(calc_asymmetry(full), 1e-3);
  EXPECT_LT(calc_asymmetry(symmetric), 1e-12);
  for (std::size_t i = 0; i < full.block.size(); ++i) {
    const NodeBlock part = 0.5 * (full.block[i] + full.block[i].transpose());
    EXPECT_LT((part - symmetric.block[i]).norm(), 1e-12 * part.norm());
  }
}

/// Newton's method ends in the same place whatever the tangent says of the normal, but needs more passes
/// without it (square die: its fillet turns the force).
TEST(CurvatureTreatment, NewtonEndsAlikeWithAllOfThem) {
  const auto run = [](const std::string& curvature) {
    const Model model =
        test::make_model(kSlice, {"contact.curvature=" + curvature, "tool.die.shape=box",
                                  "tool.die.half_width_mm=30.77", "tool.die.half_height_mm=30.77",
                                  "tool.die.corner_radius_mm=25", "increment.tolerance=1e-9"});
    State state = make_initial_state(model);
    Scratch scratch(model, 1);
    const IncrementReport report = test::run_to_end(model, state, scratch);
    EXPECT_EQ(state.time, model.end_time) << curvature << ": " << report.message;
    return state.configuration.x;
  };
  const auto wanted = run("symmetric");
  for (const std::string curvature : {"none", "known-radius", "full"}) {
    const auto x = run(curvature);
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_LT((x[i] - wanted[i]).norm(), 1e-7) << curvature;
  }
}

}  // namespace
}  // namespace hydroscope
