// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

#include "solver/base/thread_pool.h"
#include "solver/increment/report.h"
#include "solver/increment/state.h"
#include "solver/system/block_matrix.h"
#include "solver/system/linear_solver.h"
#include "solver/system/node_basis.h"
#include "solver/system/secant_updates.h"

namespace hydroscope {

/// What drives the model at one instant.
struct Loads {
  double time = 0.0;      ///< [s]: supports, tools, edge loads
  double pressure = 0.0;  ///< [MPa]
};

/// A configuration on its way to being accepted, with all that is evaluated in it.
struct Trial {
  Configuration configuration;
  std::vector<LayerState> layers;
  std::vector<GaussState> gauss;
  std::vector<std::vector<ContactPoint>> contacts;
  std::vector<double> sigma33;
  std::vector<double> area;    ///< tributary mid-surface area [mm^2]
  std::vector<double> volume;  ///< tributary volume [mm^3]
  std::vector<double> wall;    ///< volume / area [mm]
  Vector internal;             ///< internal force
  Vector pressure_load;        ///< load of unit pressure
  Vector other_load;           ///< edge loads
  Vector friction;             ///< friction forces of the tools on the sheet
  Vector normal_reaction;      ///< normal contact forces (for reports and the reference force)
  double strain_increment = 0.0, plastic_increment = 0.0;
  double elastic_share = 1.0;  ///< smallest share of the increment before a point begins to yield (r1)
  int yield_at = -1;           ///< its element
  int strain_at = -1;          ///< element with the largest strain increment

  /// Out-of-balance force but for the reactions of supports and normal contact.
  Vector calc_residual(const Loads& loads) const {
    return loads.pressure * pressure_load + other_load + friction - internal;
  }
};

/// Adds the time between its construction and its end to a phase.
class PhaseTimer {
 public:
  explicit PhaseTimer(double& phase) : phase_(phase), start_(std::chrono::steady_clock::now()) {}
  ~PhaseTimer() {
    phase_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  double& phase_;
  std::chrono::steady_clock::time_point start_;
};

/// Buffers of a run: nothing in it carries meaning from one increment to the next,
/// except that `trial` may hold the evaluated last accepted state.
struct Scratch {
  Scratch(const Model& model, int threads);
  ThreadPool pool;
  BlockMatrix matrix;
  LinearSolver solver;
  Trial trial;
  std::vector<ElementMatrix> element_matrices;
  std::vector<ElementResponse> responses;
  std::vector<ElementVector> pressure_loads;
  std::vector<NodeBlock> node_blocks;
  std::vector<NodeBasis> bases;
  SecantUpdates secant;
  std::vector<NodeBasis> factor_bases;  ///< those that the factorised matrix stands in
  std::vector<char> is_held;
  std::vector<double> values;
  std::vector<std::vector<std::array<int, 2>>> node_elements;  ///< (element, local node) of each node
  PhaseTimes times;
  int factorisations = 0;
  Factorisation last_factorisation;
};

}  // namespace hydroscope
