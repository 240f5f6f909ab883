// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "solver/geometry/tool_surface.h"
#include "solver/loading/path.h"

namespace hydroscope {

/// A rigid tool as placed, with its motion and friction.
struct Tool {
  std::string name;
  std::shared_ptr<const ToolSurface> surface;
  std::array<Path, 3> motion;  ///< translation [mm] against process time
  double friction = 0.0;       ///< Coulomb mu
  double side = 1.0;           ///< +1: meets the outer face X + (h/2)V, -1: the inner (4.63)
  double leaves_at = 1e300;    ///< process time at which the tool is taken away [s]
  double known_radius = 0.0;   ///< where the tool is curved [mm]; 0: the surface's own

  Vec3 calc_translation(double time) const { return {motion[0](time), motion[1](time), motion[2](time)}; }
  bool is_present(double time) const { return time < leaves_at; }
};

/// Why a node let go.
enum class ReleaseCause : unsigned char {
  kNone,
  kTension,    ///< pulled beyond the threshold, and its patch carries no pressure
  kPatch,      ///< with its patch, of which it is a part
  kSign,       ///< by a sign rule
  kEdge,       ///< slid off the tool's edge
  kLost,       ///< no foot point near: slid off or far away
  kToolTaken,  ///< the tool is taken away
};

/// Figures of the moment at which a node was released.
struct Release {
  ReleaseCause cause = ReleaseCause::kNone;
  double force = 0.0;      ///< normal force then, negative under tension [N]
  double pressure = 0.0;   ///< smoothed contact pressure then [MPa]
  double threshold = 0.0;  ///< tension that was needed [N]
};

enum class ContactStatus : unsigned char { kFree, kStick, kSlip };

/// One node against one tool: what is remembered from increment to increment.
struct ContactPoint {
  ContactStatus status = ContactStatus::kFree;
  bool has_foot = false;  ///< a foot point was found within the band
  FootPoint foot;         ///< in world axes
  SearchHint hint;
  Vec3 position = Vec3::Zero();  ///< slave point relative to the tool's translation [mm]
  Vec3 anchor = Vec3::Zero();    ///< where friction starts in this increment, like `position`
  double normal_force = 0.0;     ///< t_N [N], compression positive, from total equilibrium
  double friction_normal = 0.0;  ///< normal force that bounds the friction [N]; see evaluate_contacts()
  double peak_force = 0.0;       ///< largest normal force since it touched [N]
  Vec3 friction = Vec3::Zero();  ///< tangential force of the tool on the sheet [N]
  Vec3 slip = Vec3::Zero();      ///< accumulated sliding [mm]
  Vec3 slip_increment = Vec3::Zero();
  Release release;            ///< the last one
  bool is_releasing = false;  ///< let go in this increment, not yet seen to open
  int held_row = -1;          ///< place of its constraint among the node's held ones; -1: redundant
  int locked = 0;             ///< increments for which it may not be released again
  int toggles = 0;            ///< touches and releases so far
  int last_toggle = -1000;    ///< increment of the last one

  bool is_active() const { return status != ContactStatus::kFree; }
};

}  // namespace hydroscope
