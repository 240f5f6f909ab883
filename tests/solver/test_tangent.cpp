// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "model_texts.h"
#include "solver/contact/constraint.h"

namespace hydroscope {
namespace {

/// A quarter of a tube with held ends, blown into a round die that it touches in the middle only.
const std::string kTubeInDie = test::kTubeT + R"(length_mm = 24
extent = "half"
elements_around = 5
elements_along = 6
)" + test::kElastic + R"([load]
pressure_MPa = [[0, 0], [1, 40]]
[ends]
rotation = "held"
radial = "held"
[tool.die]
shape = "cylinder"
radius_mm = 30.77
[increment]
largest = 0.2
initial_s = 0.2
tolerance = 1e-8
)";

/// Differences of all forces about an accepted state, with thickness, contact set and the stiffness of
/// the wall under the tool held still: what the assembled matrix must be.
class TangentCheck {
 public:
  explicit TangentCheck(const std::vector<std::string>& sets)
      : model_(test::make_model(kTubeInDie, sets)), state_(make_initial_state(model_)), scratch_(model_, 1) {
    const IncrementReport report = test::run_to_end(model_, state_, scratch_);
    EXPECT_EQ(state_.time, model_.end_time) << report.message;
    loads_ = test::evaluate_state(model_, state_, scratch_);
    bases_ = scratch_.bases;
    if (!scratch_.trial.contacts.empty()) contacts_ = scratch_.trial.contacts[0];
  }

  int count_contacts() const {
    int n = 0;
    for (const ContactPoint& c : contacts_) n += c.is_active() && c.held_row >= 0 ? 1 : 0;
    return n;
  }

  /// Relative error of matrix times a direction that the supports allow, free rows only.
  double calc_error(int seed) {
    Vector local(scratch_.matrix.size());
    for (Eigen::Index i = 0; i < local.size(); ++i) {
      // Rotations are per length of an element.
      local[i] = std::sin(1.7 * static_cast<double>(i) + seed) * (i % 5 < 3 ? 1.0 : 0.2);
    }
    erase_held(local);
    Vector product = scratch_.matrix.multiply(local);
    Vector world = local;
    transform(world, false);
    constexpr double kStep = 1e-5;  // mm: truncation (1e-5 / 4)^2, rounding of 1e-15 E t against E t 1e-5 / 4
    Vector difference = (calc_force(kStep * world) - calc_force(-kStep * world)) / (2 * kStep);
    transform(difference, true);
    erase_held(product);
    erase_held(difference);
    return (difference - product).norm() / product.norm();
  }

 private:
  void erase_held(Vector& local) const {
    for (std::size_t i = 0; i < bases_.size(); ++i) {
      for (int k = 0; k < bases_[i].n_held(); ++k) {
        if (bases_[i].is_eliminated(k)) local[static_cast<Eigen::Index>(kDofs * i) + k] = 0.0;
      }
    }
  }

  /// World to local (T^T r) for forces, local to world (T q) for displacements.
  void transform(Vector& v, bool to_local) const {
    for (std::size_t i = 0; i < bases_.size(); ++i) {
      const auto at = static_cast<Eigen::Index>(kDofs * i);
      const NodeBlock& t = bases_[i].transform();
      v.segment<kDofs>(at) = ((to_local ? NodeBlock(t.transpose()) : t) * v.segment<kDofs>(at)).eval();
    }
  }

  /// Internal force less pressure and normal contact force, at the state moved by `q`.
  Vector calc_force(const Vector& q) {
    start_trial(state_, scratch_);
    Trial& trial = scratch_.trial;
    move(trial.configuration, q);
    evaluate(model_, state_, loads_, {.freeze_thickness = true, .with_stiffness = true}, scratch_);
    trial.friction.setZero();
    Vector force = -trial.calc_residual(loads_);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const ContactPoint& c = contacts_[i];
      if (!c.is_active() || c.held_row < 0) continue;
      const FootPoint& foot = trial.contacts[0][i].foot;
      const NodeBasis& basis = bases_[i];
      // Of a spring, the normal force follows the gap; of an eliminated row it keeps its size.
      const double spring = basis.is_eliminated(c.held_row) ? 0.0 : basis.stiffness(c.held_row);
      const double normal_force = c.normal_force - spring * (foot.gap - c.foot.gap);
      const SlavePoint slave{trial.configuration.triad[i], 0.5 * trial.configuration.thickness[i]};
      force.segment<kDofs>(static_cast<Eigen::Index>(kDofs * i)) -=
          slave.calc_map().transpose() * (normal_force * foot.normal);
    }
    return force;
  }

  Model model_;
  State state_;
  Scratch scratch_;
  Loads loads_;
  std::vector<NodeBasis> bases_;
  std::vector<ContactPoint> contacts_;
};

void expect_tangent(const std::vector<std::string>& sets) {
  TangentCheck check(sets);
  EXPECT_GT(check.count_contacts(), 6);
  for (const int seed : {1, 2, 3}) {
    const double error = check.calc_error(seed);  // seen: 2e-10
    EXPECT_LT(error, 1e-8) << "direction " << seed;
  }
}

TEST(WholeTangent, SpringyWallMatchesDifferences) { expect_tangent({}); }

TEST(WholeTangent, RigidWallMatchesDifferences) { expect_tangent({"contact.wall_stiffness=0"}); }

TEST(WholeTangent, InnerPressureMatchesDifferences) { expect_tangent({"load.pressure_surface=inner"}); }

TEST(WholeTangent, SlidingEndMatchesDifferences) { expect_tangent({"ends.radial=free"}); }

/// Were the load stiffness left out, the check would see it: this is not a test of something tiny.
TEST(WholeTangent, DifferencesSeeTheLoadStiffness) {
  TangentCheck check({"load.load_stiffness=false"});
  EXPECT_GT(check.calc_error(1), 1e-6);
}

TEST(WholeTangent, DifferencesSeeTheCurvature) {
  TangentCheck check({"contact.curvature=none"});
  EXPECT_GT(check.calc_error(1), 1e-6);
}

}  // namespace
}  // namespace hydroscope
