// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/contact_step.h"
#include "solver/increment/evaluate.h"

namespace hydroscope {

/// Everything of the trial configuration at these loads: contacts, elements,
/// forces, matrix. The trial must hold a configuration and contact points.
void evaluate(const Model& model, const State& state, const Loads& loads, const EvaluationSettings& settings,
              Scratch& scratch);

/// Copies the accepted state into the trial.
void start_trial(const State& state, Scratch& scratch);

/// Out-of-balance force of the free degrees of freedom against the reference
/// force max(|pressure force|, |contact force|, |reactions|, |edge loads|), both as
/// Euclidean norms; moments count over the wall's thickness (mechanics 4.2).
struct Imbalance {
  double residual = 0.0;   ///< relative
  double reference = 0.0;  ///< [N]
};
Imbalance calc_imbalance(const Model& model, const Loads& loads, const Scratch& scratch);

/// Factorises the assembled matrix with the held degrees of freedom eliminated.
Factorisation factorise(const Model& model, Scratch& scratch);

/// A correction (or prediction) and what it is expected to do.
struct Solution {
  Vector q;                      ///< displacements (u, alpha, beta) in world terms
  double pressure_change = 0.0;  ///< [MPa]
  double work = 0.0;             ///< q . out-of-balance force [N mm]
  Vector force;                  ///< out-of-balance force in the factor's bases
  Vector local;                  ///< q in the factor's bases, before any change of pressure
  Vector penetration;            ///< what a penalty lets the held degrees of freedom give way
  double compliance =
      0.0;  ///< g . K^-1 g [mm^3/MPa]: negative past a limit point of pressure (volume control)
};

/// Out-of-balance force of the trial with what the springs of constraints lack, in world terms.
Vector calc_unbalanced(const Loads& loads, const Scratch& scratch);

/// What a solve is given: forces in world terms, and the displacements of held degrees of freedom in
/// the nodes' bases.
struct Step {
  Vector force, prescribed;
};
Step make_step(const Loads& loads, const Scratch& scratch);

/// Solves K q = force with the matrix factorised last, as far
/// as the steps since have not taught better; with volume control, `volume_gap` [mm^3] is what the
/// enclosed volume still lacks.
Solution solve(const Model& model, const Loads& loads, const Step& step, bool use_volume, double volume_gap,
               Scratch& scratch);

/// The same for the trial's own out-of-balance force.
inline Solution solve(const Model& model, const Loads& loads, bool use_volume, double volume_gap,
                      Scratch& scratch) {
  return solve(model, loads, make_step(loads, scratch), use_volume, volume_gap, scratch);
}

/// Forces with which the constraints have held a solution, in the bases of the factor: of eliminated rows
/// from the rows wiped, of a penalty -alpha X (4.62) [N]. Without a change of pressure by volume control.
Vector calc_held_forces(const Model& model, const Step& step, const Solution& solution,
                        const Scratch& scratch);

/// Work of the out-of-balance force of the trial on displacements `q` [N mm].
double calc_work(const Loads& loads, const Vector& q, const Scratch& scratch);

/// Springs of contacts that came or went since the factorisation. False when the matrix must be
/// factorised again.
bool learn_springs(const std::vector<SpringChange>& changes, Scratch& scratch);

/// What `scale` times `solution` has changed in the out-of-balance force teaches the solver for later passes.
void learn_step(const Solution& solution, double scale, const Loads& loads, Scratch& scratch);

/// Enclosed volume of the trial [mm^3]: the state's plus what the surface has
/// swept, with the load vector at mid-way.
double calc_volume(const Model& model, const State& state, const Scratch& scratch);

/// Reactions of the supports on the sheet, a node [N].
std::vector<Vec3> calc_reactions(const Model& model, const Loads& loads, const Scratch& scratch);

}  // namespace hydroscope
