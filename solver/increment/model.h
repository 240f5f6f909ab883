// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/contact/contact_point.h"
#include "solver/contact/friction.h"
#include "solver/loading/path.h"
#include "solver/scene/scene.h"
#include "solver/shell/shell_element.h"

namespace hydroscope {

/// One support of a node.
struct Support {
  enum class Kind {
    kDisplacement,  ///< displacement along `direction` follows motion `motion` (-1: held)
    kSymmetry,      ///< the node stays in the plane across `direction`, its fibre too
    kClamp,         ///< no rotation of the fibre
  };
  Kind kind = Kind::kDisplacement;
  Vec3 direction = Vec3::UnitX();
  int motion = -1;
};

/// Line load on an edge of a strip.
struct EdgeLoad {
  std::vector<int> nodes,
      inner_nodes;  ///< edge nodes and their neighbours inside: the tangent leads from one to the other
  std::vector<double> widths;      ///< tributary width of each node [mm]
  Path force_x, force_y, tension;  ///< [N/mm]
  Path moment;                     ///< about z, per width [N mm/mm]
  double lever = 1.0;  ///< from end to end of the strip [mm]: what a moment counts over, as a force
};

/// A chosen output number, resolved to nodes.
struct Quantity {
  std::string name;
  QuantityScene scene;
  std::vector<int> nodes;       ///< interpolation points, or the patch
  std::vector<double> weights;  ///< of `nodes`
  int tool = -1;
  std::vector<int> of;        ///< indices of other quantities
  std::vector<int> elements;  ///< over which it is averaged
};

/// How the tangent knows that normals turn (method section 4).
enum class Curvature { kNone, kKnownRadius, kSymmetric, kFull };

/// When a node lets go (mechanics 9).
enum class ReleaseRule {
  kFull,   ///< thresholds, patches, verification
  kFluid,  ///< sign of the normal force, the fluid's subtracted
  kSign,   ///< sign of the internal nodal force
};

/// What becomes of out-of-balance forces (method sections 4.2 and 4.3).
enum class Correction { kNewton, kNone, kOneStepBehind, kAlgoneq };

/// Everything about an analysis that does not change while it runs.
struct Model {
  std::string title;
  std::vector<Vec3> x0;  ///< mid-surface nodes [mm]
  std::vector<std::array<int, 4>> quads;
  std::vector<Triad> triad0;
  double thickness = 0.0;     ///< initial [mm]
  Vec3 axis = Vec3::UnitZ();  ///< material axis 1
  std::vector<Plane> mirrors;
  std::vector<std::vector<Support>> supports;  ///< one list a node
  std::vector<Path> motions;                   ///< [mm]
  std::vector<EdgeLoad> edge_loads;
  std::vector<Tool> tools;
  ShellLaw law;
  bool use_volume_control = false;
  bool use_inner_surface = false;  ///< pressure acts on the inner face
  bool use_load_stiffness = true;
  bool use_through_wall_stress = false;  ///< sigma33 = mean of the faces' pressures
  Path pressure, volume_ratio, feed;
  double volume0 = 0.0;       ///< enclosed volume of the modelled part at the start [mm^3]
  double slice_width = 1.0;   ///< modelled length along z [mm]: forces per mm
  double element_size = 1.0;  ///< smallest edge of the mesh [mm]
  double end_time = 1.0;
  ContactScene contact;
  IncrementScene increment;
  Curvature curvature = Curvature::kSymmetric;
  FrictionLaw friction_law = FrictionLaw::kReturnMapping;
  ReleaseRule release = ReleaseRule::kFull;
  Correction correction = Correction::kNewton;
  bool use_penalty = false;  ///< constraints by penalty, else by elimination
  bool controls_error = false;
  LimitsScene limits;
  std::vector<Quantity> quantities;
  int stop_quantity = -1;
  StopScene stop;
  std::vector<std::vector<int>> node_neighbours;

  int n_nodes() const { return static_cast<int>(x0.size()); }
  int n_elements() const { return static_cast<int>(quads.size()); }
  double touch_tolerance() const { return contact.tolerance > 0.0 ? contact.tolerance : 1e-3 * thickness; }
};

}  // namespace hydroscope
