// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/scratch.h"

namespace hydroscope {

/// Internal force, pressure load and (always) the element matrices of the
/// trial configuration, integrated from `state`. Thickness follows from volume
/// over area at the nodes afterwards (see update_thickness()). `assume_flow`: the tangent is a predictor's.
void evaluate_elements(const Model& model, const State& state, const Loads& loads, bool assume_flow,
                       Scratch& scratch);

/// h = volume / area at each node of the trial configuration [mm]. Kept apart
/// from evaluate_elements() so that a tangent can be checked with it frozen.
void update_thickness(Trial& trial);

/// Line loads on edges (dead forces, tension along the current tangent).
void evaluate_edge_loads(const Model& model, const Loads& loads, Trial& trial);

/// Through-wall stress at the nodes: minus the mean of the fluid's pressure and the
/// smoothed contact pressure of the last accepted state [MPa]; zero when off.
void evaluate_through_wall_stress(const Model& model, const State& state, const Loads& loads, Trial& trial);

/// Sums element matrices, load stiffness and node blocks into the matrix, in the
/// local bases of the nodes (4.52)-(4.57).
void assemble_matrix(const Model& model, Scratch& scratch);

ElementNodes gather_nodes(const Model& model, const Configuration& configuration, std::size_t element);

}  // namespace hydroscope
