// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "solver/increment/advance.h"
#include "solver/increment/contact_step.h"
#include "solver/increment/equations.h"
#include "solver/increment/evaluate.h"
#include "solver/scene/scene_reader.h"
#include "solver/session/build_model.h"

namespace hydroscope::test {

/// Tube T of the verification cases, a quarter, elastic; tables follow.
inline const std::string kTubeT = R"([tube]
radius_mm = 30
thickness_mm = 1.5
section = "quarter"
)";

inline const std::string kElastic = R"([material]
youngs_modulus_MPa = 206e3
poisson = 0.3
)";

inline Model make_model(const std::string& text, const std::vector<std::string>& sets = {}) {
  std::vector<SceneOverride> overrides;
  for (const std::string& set : sets) overrides.push_back(make_override(set));
  return build_model(parse_scene(text, "test.toml", overrides));
}

/// Runs to the end of the paths; the report of the increment that ended it.
inline IncrementReport run_to_end(const Model& model, State& state, Scratch& scratch) {
  IncrementReport report;
  while (state.time < model.end_time * (1.0 - 1e-12)) {
    report = advance(model, state, scratch);
    if (report.outcome != Outcome::kRunning) break;
  }
  return report;
}

/// Evaluates the accepted state again: matrix and forces about a zero increment.
inline Loads evaluate_state(const Model& model, const State& state, Scratch& scratch) {
  const Loads loads{state.time, state.pressure};
  start_trial(state, scratch);
  evaluate(model, state, loads, {.freeze_thickness = true, .with_stiffness = true}, scratch);
  evaluate_contacts(model, state, loads, true, scratch);
  assemble_matrix(model, scratch);
  return loads;
}

}  // namespace hydroscope::test
