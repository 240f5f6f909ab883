// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/increment/report.h"
#include "solver/scene/scene.h"
#include "solver/session/run.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope::verification {

/// All that a run said, in the order of its increments.
struct History {
  std::vector<IncrementReport> rows;
  RunSummary summary;
  std::vector<std::shared_ptr<const Snapshot>> states;  ///< those that the scene keeps, first and last too

  /// The state kept at a time [s].
  const Snapshot& state_at(double time) const;

  /// Column of a quantity of the scene, or "pressure" or "time".
  std::vector<double> column(const std::string& name) const;

  /// Value of `wanted` where `key` first passes `at`: the cubic through the four nearest
  /// increments, so that the size of the increments does not enter the figure.
  /// NaN when the run never gets there.
  double value_at(const std::string& wanted, const std::string& key, double at) const;

  bool has_warning(const std::string& kind) const;
  /// Pressure of the increment that gave the first warning of a kind [MPa]; NaN without one.
  double pressure_of_warning(const std::string& kind) const;
};

/// Runs a shipped scene with keys replaced as on the command line ("tube.length_mm=90").
History run_scene(const std::string& file, const std::vector<std::string>& assignments = {}, int threads = 1);
/// The same for a scene written out in the test.
History run_text(const std::string& text, const std::vector<std::string>& assignments = {});

/// |value / wanted - 1|
double relative_error(double value, double wanted);

}  // namespace hydroscope::verification
