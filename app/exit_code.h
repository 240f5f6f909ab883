// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/report.h"

namespace hydroscope {

/// Exit codes of the program; part of its interface, never renumber.
enum class ExitCode : int {
  kDone = 0,
  kDifferences = 1,  ///< a check found differences
  kBadInput = 2,
  kEndedByPhysics = 3,   ///< pressure maximum, bursting, buckling
  kEndedByNumerics = 4,  ///< singular, step floor
  kEnvironment = 5,      ///< renderer, disk
  kInternal = 70,        ///< a fault of the program itself
  kInterrupted = 130,
};

ExitCode find_exit_code(Outcome outcome);

}  // namespace hydroscope
