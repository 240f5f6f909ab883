// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solver/increment/model.h"

namespace hydroscope {

/// Positions, fibres and thickness: what the corrector moves.
struct Configuration {
  std::vector<Vec3> x;
  std::vector<Triad> triad;
  std::vector<double> thickness;  ///< h of fibres and contact points [mm]
};

/// The analysis at an accepted increment; a plain value.
struct State {
  Configuration configuration;
  std::vector<LayerState> layers;                   ///< elements x 4 x n_z
  std::vector<GaussState> gauss;                    ///< elements x 4
  std::vector<std::vector<ContactPoint>> contacts;  ///< one list a tool, one entry a node
  std::vector<double>
      recent_strain;            ///< an element: plastic strain of late, per strain of the fastest element
  std::vector<double> sigma33;  ///< a node [MPa]
  std::vector<double> outer_pressure;  ///< smoothed contact pressure of the last state, a node [MPa]
  std::vector<double> wall;            ///< thickness at the nodes, volume over area [mm]
  std::vector<double> area;            ///< tributary mid-surface area of a node [mm^2]
  std::vector<Vec3> reaction;          ///< of the supports, a node [N]
  Eigen::VectorXd unbalanced;  ///< out-of-balance force left behind; kept by explicit corrections only
  double time = 0.0, pressure = 0.0, volume = 0.0;  ///< [s], [MPa], [mm^3]
  double last_dt = 0.0;                             ///< length of the last increment [s]
  int increment = 0;
  bool is_at_corner = true;  ///< a path turned at `time`
  double next_dt = 0.0;      ///< increment to try next [s]
  double peak_pressure = 0.0;
  std::vector<char> has_warned;  ///< kinds of warnings already given
};

/// State at time 0: stress-free, contacts searched, nothing solved.
State make_initial_state(const Model& model);

/// Nodes of one element in a configuration.
ElementNodes gather_nodes(const Model& model, const Configuration& configuration, std::size_t element);

/// 64-bit FNV-1a hash of all values of the state, for determinism checks.
std::uint64_t calc_hash(const State& state);

/// Moves nodes by `q` = (u, alpha, beta) a node; fibres turn by the exponential map.
void move(Configuration& configuration, const Eigen::VectorXd& q);

}  // namespace hydroscope
