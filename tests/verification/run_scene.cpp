// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verification/run_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "solver/scene/scene_reader.h"
#include "solver/scene/scene_source.h"

namespace hydroscope::verification {

namespace {

std::vector<SceneOverride> make_overrides(const std::vector<std::string>& assignments) {
  std::vector<SceneOverride> overrides;
  for (const std::string& assignment : assignments) overrides.push_back(make_override(assignment));
  return overrides;
}

History record(const Scene& scene, int threads) {
  RunOptions options;
  options.threads = threads;
  Run run(scene, options);
  History history;
  RunObserver observer;
  observer.on_increment = [&](const IncrementReport& report) { history.rows.push_back(report); };
  observer.on_snapshot = [&](std::shared_ptr<const Snapshot> snapshot, bool for_state, bool) {
    if (for_state) history.states.push_back(snapshot);
  };
  history.summary = run.run(observer);
  return history;
}

}  // namespace

const Snapshot& History::state_at(double time) const {
  for (const auto& state : states) {
    if (std::abs(state->time - time) < 1e-9 * std::max(1.0, time)) return *state;
  }
  throw std::invalid_argument("no state was kept at " + std::to_string(time) + " s");
}

std::vector<double> History::column(const std::string& name) const {
  std::vector<double> values;
  values.reserve(rows.size());
  if (name == "pressure" || name == "time") {
    for (const IncrementReport& row : rows) values.push_back(name == "time" ? row.time : row.pressure);
    return values;
  }
  const auto& names = summary.quantity_names;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw std::invalid_argument("no quantity " + name);
  const auto k = static_cast<std::size_t>(found - names.begin());
  for (const IncrementReport& row : rows) values.push_back(row.quantities.at(k));
  return values;
}

double History::value_at(const std::string& wanted, const std::string& key, double at) const {
  const std::vector<double> x = column(key);
  const std::vector<double> y = column(wanted);
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    if ((x[i] - at) * (x[i + 1] - at) > 0.0) continue;
    const std::size_t first = std::min(i > 0 ? i - 1 : 0, x.size() >= 4 ? x.size() - 4 : 0);
    const std::size_t last = std::min(first + 4, x.size());
    double sum = 0.0;
    for (std::size_t j = first; j < last; ++j) {  // Lagrange
      double weight = 1.0;
      for (std::size_t k = first; k < last; ++k) {
        if (k != j) weight *= (at - x[k]) / (x[j] - x[k]);
      }
      sum += weight * y[j];
    }
    return sum;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

bool History::has_warning(const std::string& kind) const {
  return std::any_of(summary.warnings.begin(), summary.warnings.end(),
                     [&](const Warning& warning) { return warning.kind == kind; });
}

double History::pressure_of_warning(const std::string& kind) const {
  for (const Warning& warning : summary.warnings) {
    if (warning.kind != kind) continue;
    for (const IncrementReport& row : rows) {
      if (row.increment == warning.increment) return row.pressure;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

History run_scene(const std::string& file, const std::vector<std::string>& assignments, int threads) {
  return record(read_scene("scenes/" + file, make_overrides(assignments)), threads);
}

History run_text(const std::string& text, const std::vector<std::string>& assignments) {
  return record(parse_scene(text, "scenes/in_test.toml", make_overrides(assignments)), 1);
}

double relative_error(double value, double wanted) { return std::abs(value / wanted - 1.0); }

}  // namespace hydroscope::verification
