// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/report.h"

namespace hydroscope {

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::kRunning:
      return "running";
    case Outcome::kCompleted:
      return "completed";
    case Outcome::kPressureMaximum:
      return "pressure maximum";
    case Outcome::kBursting:
      return "bursting";
    case Outcome::kBuckling:
      return "buckling";
    case Outcome::kSingular:
      return "singular";
    case Outcome::kStepFloor:
      return "step floor";
    case Outcome::kUserStop:
      return "user stop";
  }
  return "";
}

const char* to_string(Limiter limiter) {
  switch (limiter) {
    case Limiter::kNone:
      return "none";
    case Limiter::kTimePath:
      return "path";
    case Limiter::kStrain:
      return "strain";
    case Limiter::kRotation:
      return "rotation";
    case Limiter::kThickness:
      return "thickness";
    case Limiter::kYield:
      return "yield";
    case Limiter::kTouch:
      return "touch";
    case Limiter::kRelease:
      return "release";
    case Limiter::kStickToSlip:
      return "stick-to-slip";
    case Limiter::kSlide:
      return "slide";
    case Limiter::kConvergence:
      return "convergence";
    case Limiter::kError:
      return "error-tolerance";
    case Limiter::kQuantity:
      return "quantity";
  }
  return "";
}

const char* to_string(EventKind kind) {
  switch (kind) {
    case EventKind::kTouch:
      return "touch";
    case EventKind::kStick:
      return "stick";
    case EventKind::kSlip:
      return "slip";
    case EventKind::kDetach:
      return "detach";
    case EventKind::kRetouch:
      return "retouch";
    case EventKind::kTakenBack:
      return "taken-back";
  }
  return "";
}

}  // namespace hydroscope
