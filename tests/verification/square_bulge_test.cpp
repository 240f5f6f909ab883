// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

#include "scenes/generators/die_meshes.h"
#include "scenes/generators/stl_file.h"
#include "solver/increment/advance.h"
#include "solver/increment/contact_step.h"
#include "solver/increment/equations.h"
#include "solver/scene/scene_reader.h"
#include "solver/session/build_model.h"
#include "solver/session/make_snapshot.h"
#include "solver/system/linear_solver.h"
#include "tests/temporary_folder.h"

namespace hydroscope::verification {
namespace {

Model make_main_job(const std::vector<std::string>& assignments = {}) {
  const TemporaryFolder folder;
  const std::string die = folder / "die.stl";
  write_file(die, make_binary_stl(make_square_bulge_die({}), "square bulge die"));
  std::vector<SceneOverride> overrides = {make_override("tool.die.file=" + die)};
  for (const std::string& assignment : assignments) overrides.push_back(make_override(assignment));
  return build_model(read_scene("scenes/square-bulge.toml", overrides));
}

using OnIncrement = std::function<void(const State&, const IncrementReport&)>;

/// As Run does it, with the whole state in sight.
IncrementReport run_main_job(const Model& model, Scratch& scratch, const OnIncrement& on_increment) {
  fix_blas_threads(1);
  State state = make_initial_state(model);
  start_trial(state, scratch);
  search_contacts(model, {}, scratch);
  state.contacts = scratch.trial.contacts;
  IncrementReport report;
  while (state.time < model.end_time * (1.0 - 1e-12)) {
    report = advance(model, state, scratch);
    on_increment(state, report);
    if (report.outcome != Outcome::kRunning) break;
  }
  return report;
}

/// Volume between the faces x -+ (wall/2) V of one element [mm^3]: a brick, exact with 2 x 2 x 2 points.
double calc_brick_volume(const Snapshot& s, const std::array<int, 4>& quad) {
  double volume = 0.0;
  for (int g = 0; g < kGaussPoints; ++g) {
    const Vec2 at = gauss_point(g);
    const ShapeFunctions f = calc_shape_functions(at[0], at[1]);
    for (const double zeta : {-1.0 / std::numbers::sqrt3, 1.0 / std::numbers::sqrt3}) {
      Vec3 g1 = Vec3::Zero(), g2 = Vec3::Zero(), g3 = Vec3::Zero();
      for (std::size_t a = 0; a < 4; ++a) {
        const auto i = static_cast<std::size_t>(quad[a]);
        const Vec3 half = 0.5 * s.thickness[i] * s.directors[i], x = s.points[i] + zeta * half;
        g1 += f.n1[a] * x;
        g2 += f.n2[a] * x;
        g3 += f.n[a] * half;
      }
      volume += std::abs(g1.cross(g2).dot(g3));
    }
  }
  return volume;
}

double calc_solid_volume(const Snapshot& s) {
  double volume = 0.0;
  for (const auto& quad : s.model->quads) volume += calc_brick_volume(s, quad);
  return volume;
}

/// Mean over the material of (1 - 2 nu)/E tr sigma, the elastic change of volume that it stands under.
double calc_elastic_change(const Model& model, const State& state) {
  const auto n_z = static_cast<std::size_t>(model.law.rule.size());
  double sum = 0.0, volume = 0.0;
  for (std::size_t g = 0; g < state.gauss.size(); ++g) {
    for (std::size_t k = 0; k < n_z; ++k) {
      const Vec3& sigma = state.layers[g * n_z + k].point.stress;
      const double share = model.law.rule.weight[k] * state.gauss[g].volume;
      sum += share * (sigma[0] + sigma[1]);
      volume += share;
    }
  }
  const SheetMaterial& m = model.law.sheet.material;
  return (1.0 - 2.0 * m.poisson) / m.youngs_modulus * sum / volume;
}

/// What the fluid presses on the modelled part with [N]: half the cross product of a quad's diagonals is
/// its vector area, whatever its warp; outwards by the fibres.
Vec3 calc_fluid_force(const Snapshot& s) {
  Vec3 force = Vec3::Zero();
  for (const auto& quad : s.model->quads) {
    std::array<Vec3, 4> x;
    Vec3 outwards = Vec3::Zero();
    for (std::size_t a = 0; a < 4; ++a) {
      x[a] = s.points[static_cast<std::size_t>(quad[a])];
      outwards += s.directors[static_cast<std::size_t>(quad[a])];
    }
    const Vec3 area = 0.5 * (x[2] - x[0]).cross(x[3] - x[1]);
    force += std::copysign(s.pressure, area.dot(outwards)) * area;
  }
  return force;
}

Vec3 sum_of(const std::vector<Vec3>& forces) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& f : forces) sum += f;
  return sum;
}

/// Largest errors over the increments of a run.
struct Errors {
  double residual = 0.0, volume = 0.0, balance = 0.0;
};

// The numbers that the main job must reach, along its whole path. The tube of 24 chords has its volume by
// hand; what is written as thickness must keep it but for the elastic part, 0.2 % at the end. Forces as
// written into the states, on the modelled part: die (normal force and friction), supports with symmetry
// planes, the pushed end, and the fluid on the mid-surface.
TEST(SquareBulge, MainJobKeepsMaterialAndBalance) {
  const Model model = make_main_job();
  const auto shared = std::make_shared<SnapshotModel>(make_snapshot_model(model));
  const double chords = 24.0 * 60.0 * std::sin(std::numbers::pi / 8.0 / 24.0), start = chords * 90.0 * 1.5;
  Scratch scratch(model, 2);
  Errors worst;
  std::shared_ptr<const Snapshot> last;
  double elastic = 0.0;
  const IncrementReport end =
      run_main_job(model, scratch, [&](const State& state, const IncrementReport& report) {
        if (state.increment != report.increment) return;  // an increment that failed
        last = make_snapshot(model, state, shared);
        elastic = calc_elastic_change(model, state);
        const double volume = std::abs(calc_solid_volume(*last) / (start * (1.0 + elastic)) - 1.0);
        const Vec3 fluid = calc_fluid_force(*last);
        const Vec3 rest = fluid + sum_of(last->contact_force) + sum_of(last->support_force);
        worst.residual = std::max(worst.residual, report.residual);
        worst.volume = std::max(worst.volume, volume);
        worst.balance = std::max(worst.balance, rest.norm() / fluid.norm());
      });
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->time, model.end_time) << to_string(end.outcome) << ": " << end.message;
  EXPECT_LE(worst.residual, 1e-3);
  EXPECT_LE(worst.volume, 1e-3);
  EXPECT_LE(worst.balance, 1e-3);
  EXPECT_LE(scratch.factorisations, 400);
  EXPECT_GT(end.n_contact, 1500) << "of 2,275 nodes: the cavity is not filled";

  RecordProperty("increments", last->increment);
  RecordProperty("factorisations", scratch.factorisations);
  RecordProperty("largest_residual", std::to_string(worst.residual));
  RecordProperty("largest_volume_error", std::to_string(worst.volume));
  RecordProperty("elastic_change_of_volume", std::to_string(elastic));
  RecordProperty("largest_force_error", std::to_string(worst.balance));
  RecordProperty("die_force_N", std::to_string(sum_of(last->contact_force).norm()));
  RecordProperty("thickness_min_mm", std::to_string(end.thickness_min));
  RecordProperty("thickness_max_mm", std::to_string(end.thickness_max));
  for (const auto& [name, value] : last->quantities) RecordProperty(name, std::to_string(value));
}

// Every value of every accepted state, on a coarser tube and up to a filled flat.
TEST(SquareBulge, StatesAreTheSameBitForBitForOneAndTwoThreads) {
  const Model model = make_main_job({"tube.elements_around=12", "tube.elements_along=30",
                                     "load.pressure_MPa=[[0, 0], [0.15, 18], [0.5, 38]]",
                                     "load.axial_feed_mm=[[0, 0], [0.15, 0], [0.5, 1]]"});
  std::array<std::vector<std::uint64_t>, 2> hashes;
  std::array<IncrementReport, 2> ends;
  for (const int threads : {1, 2}) {
    const auto k = static_cast<std::size_t>(threads - 1);
    Scratch scratch(model, threads);
    ends[k] = run_main_job(model, scratch, [&](const State& state, const IncrementReport&) {
      hashes[k].push_back(calc_hash(state));
    });
  }
  ASSERT_EQ(ends[0].time, model.end_time) << to_string(ends[0].outcome) << ": " << ends[0].message;
  EXPECT_GT(ends[0].n_contact, 50);
  EXPECT_GT(ends[0].n_slip, 0);
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace hydroscope::verification
