// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/scratch.h"

namespace hydroscope {

/// How a trial is evaluated.
struct EvaluationSettings {
  bool assume_flow = false;       ///< the tangent is a predictor's
  bool freeze_thickness = false;  ///< keep the nodes' thickness as it is
  bool with_stiffness = false;    ///< element matrices too
};

/// Internal force, pressure load and, on demand, the element matrices of the trial configuration,
/// integrated from `state`. Thickness follows from volume over area at the nodes afterwards (see
/// update_thickness()).
void evaluate_elements(const Model& model, const State& state, const Loads& loads,
                       const EvaluationSettings& settings, Scratch& scratch);

/// Spreads nodal values over about `length` [mm] of the wall (standard deviation of the spread); elements
/// longer than that keep theirs.
void smooth_over_wall(const Model& model, double length, std::vector<double>& values);

/// Wall thickness, volume over area at each node [mm], and from it the h of the
/// kinematics and of the contact points: where elements are shorter than the
/// wall is thick, h is spread over a length of about half the thickness. A wall
/// cannot change its thickness over less; unsmoothed, the noise of one element
/// would be pressed into the mid-surface as curvature wherever a tool holds it.
/// Kept apart from evaluate_elements() so that a tangent can be checked with it frozen.
void update_thickness(const Model& model, Trial& trial);

/// Tributary mid-surface area of each node [mm^2].
std::vector<double> calc_nodal_areas(const Model& model, const Configuration& configuration);

/// Line loads on edges (dead forces, tension along the current tangent, moments about the width).
void evaluate_edge_loads(const Model& model, const Loads& loads, Trial& trial);

/// Through-wall stress at the nodes: minus the mean of the fluid's pressure and the
/// smoothed contact pressure of the last accepted state [MPa]; zero when off.
void evaluate_through_wall_stress(const Model& model, const State& state, const Loads& loads, Trial& trial);

/// Sums element matrices, load stiffness and node blocks into the matrix, in the
/// local bases of the nodes (4.52)-(4.57).
void assemble_matrix(const Model& model, Scratch& scratch);

}  // namespace hydroscope
