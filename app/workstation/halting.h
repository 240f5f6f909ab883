// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/workstation/command.h"
#include "solver/session/steered_run.h"

namespace hydroscope {

/// The halt that an analysis waits for, and when it is reached.
class Halting {
 public:
  /// Checks that the halt lies ahead of `run`. Throws InputError.
  void arm(const Halt& halt, const SteeredRun& run);
  void disarm() { *this = {}; }
  /// After a path has changed: where the same halt lies now. Throws InputError when it lies nowhere ahead.
  void renew(const SteeredRun& run) { arm(halt_, run); }

  /// Process time that increments must not pass [s].
  double time() const { return time_; }
  bool is_armed() const { return halt_.kind != Halt::Kind::kNever; }
  /// The halt as a command; empty: none.
  std::string text() const;
  /// Why the increment just done is where to halt; empty: it is not.
  std::string judge(const StepResult& step, const SteeredRun& run) const;

 private:
  void aim(const SteeredRun& run);

  Halt halt_;
  double time_ = kNoHalt;
  double pressure_before_ = 0.0;  ///< when armed [MPa]: from which side the pressure comes
};

}  // namespace hydroscope
