// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exit_code.h"

namespace hydroscope {

ExitCode find_exit_code(Outcome outcome) {
  switch (outcome) {
    case Outcome::kCompleted:
      return ExitCode::kDone;
    case Outcome::kPressureMaximum:
    case Outcome::kBursting:
    case Outcome::kBuckling:
      return ExitCode::kEndedByPhysics;
    case Outcome::kSingular:
    case Outcome::kStepFloor:
      return ExitCode::kEndedByNumerics;
    case Outcome::kUserStop:
      return ExitCode::kInterrupted;
    case Outcome::kRunning:
      break;
  }
  return ExitCode::kInternal;  // a run that returns has ended
}

}  // namespace hydroscope
