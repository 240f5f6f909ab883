// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "solver/base/types.h"

namespace hydroscope {

enum class Outcome {
  kRunning,
  kCompleted,
  kPressureMaximum,  ///< under pressure control: a limit point
  kBursting,         ///< necking, thickness or strain limit
  kBuckling,
  kSingular,
  kStepFloor,  ///< no convergence at the smallest increment
  kUserStop,
};

/// What governed the size of an increment.
enum class Limiter {
  kNone,
  kTimePath,
  kStrain,
  kRotation,
  kThickness,
  kYield,
  kTouch,
  kRelease,
  kStickToSlip,
  kSlide,
  kConvergence,
  kQuantity,
  kError
};

enum class EventKind {
  kTouch,
  kStick,
  kSlip,
  kDetach,
  kRetouch,
  kTakenBack,  ///< let go and pushed back by the fluid within one increment
};

/// One line of events.csv.
struct ContactEvent {
  EventKind kind = EventKind::kTouch;
  int increment = 0;
  double time = 0.0;  ///< [s]
  int node = -1;
  Vec3 position = Vec3::Zero();  ///< contact point [mm]
  int tool = -1;                 ///< index into the model's tools
  std::string cause;             ///< e.g. "gap closed", "tension", "edge", "reopened"
  double force_before = 0.0;     ///< normal force at the last accepted state [N]
  double force_after = 0.0;     ///< now; of a node that let go, when it did: the tension that released it [N]
  double gap = 0.0;             ///< [mm]
  double patch_pressure = 0.0;  ///< of a node that let go: smoothed contact pressure then [MPa]
  double threshold = 0.0;       ///< tension at which it was to let go [N]
};

/// A finding that marks the run without ending it (necking, negative pivot ...).
struct Warning {
  int increment = 0;
  double time = 0.0;
  std::string kind;  ///< "necking", "localisation", "negative-pivot", "chatter", ...
  std::string text;  ///< one sentence with place and pressure
};

/// Seconds spent by phase (wall clock).
struct PhaseTimes {
  double search = 0.0, assemble = 0.0, factorise = 0.0, solve = 0.0, update = 0.0, snapshot = 0.0;
};

/// What one call of advance() did: one row of history.csv.
struct IncrementReport {
  int increment = 0;
  double time = 0.0;           ///< [s], at the end of the increment
  double pressure = 0.0;       ///< [MPa]
  double feed = 0.0;           ///< [mm]
  double step_fraction = 0.0;  ///< accepted part of the increment tried (r_min)
  Limiter limited_by = Limiter::kNone;
  int limited_at = -1;  ///< node or element
  int n_contact = 0, n_stick = 0, n_slip = 0, n_detached = 0;
  double residual = 0.0;                            ///< out-of-balance force against the reference force
  double tangential_rest = 0.0;                     ///< of it, tangential at contact nodes (4.23)
  double thickness_min = 0.0, thickness_max = 0.0;  ///< [mm]
  int iterations = 0;                               ///< corrector passes
  int factorisations = 0;                           ///< of this increment
  int negative_pivots = 0;                          ///< of the last factorisation
  std::vector<double> quantities;                   ///< in the order of the scene's names
  std::vector<ContactEvent> events;
  std::vector<Warning> warnings;
  Outcome outcome = Outcome::kRunning;
  std::string message;  ///< why the run ends, for the user
};

const char* to_string(Outcome outcome);
const char* to_string(Limiter limiter);
const char* to_string(EventKind kind);

}  // namespace hydroscope
