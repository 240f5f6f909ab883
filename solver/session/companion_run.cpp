// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/companion_run.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

#include "solver/base/error.h"
#include "solver/session/accuracy_choices.h"

namespace hydroscope {
namespace {

/// Of the difference, with elements and increments twice as large: between errors of first (1) and of second
/// order (1/3); measured in docs/accuracy.md.
constexpr double kShare = 0.5;

std::string print_short(double number, const char* format = "%.3g") {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), format, number);
  return text.data();
}

/// Kind of a quantity; of one that combines others, that of the first of them.
std::string find_kind(const Scene& scene, const std::string& name) {
  const QuantityScene& q = scene.quantities.at(name);
  return q.kind == "sum" ? find_kind(scene, q.of.front()) : q.kind;
}

/// Where the paths of a scene turn [s].
std::vector<double> list_turning_times(const Scene& scene) {
  std::vector<double> times;
  const auto add = [&times](const Path& path) {
    times.insert(times.end(), path.times.begin(), path.times.end());
  };
  add(scene.load.pressure);
  add(scene.load.volume_ratio);
  add(scene.load.axial_feed);
  for (const auto& [which, edge] : scene.edges) {
    for (const Path* path :
         {&edge.move_x, &edge.move_y, &edge.force_x, &edge.force_y, &edge.tension, &edge.moment})
      add(*path);
  }
  for (const auto& [name, tool] : scene.tools) {
    for (const auto& row : tool.motion) times.push_back(row[0]);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

struct CompanionRun {
  QuantityHistory history;
  RunSummary summary;
};

CompanionRun run_companion(const Scene& chosen, const RunOptions& options) {
  CompanionRun companion;
  Run run(make_companion(chosen), options);
  RunObserver observer;
  observer.on_increment = [&companion](const IncrementReport& report) {
    companion.history.times.push_back(report.time);
    companion.history.values.push_back(report.quantities);
  };
  companion.summary = run.run(observer);
  return companion;
}

ErrorEstimate estimate_error(const Scene& chosen, const RunOptions& options, const QuantityHistory& history,
                             const RunSummary& summary) {
  const auto start = std::chrono::steady_clock::now();
  ErrorEstimate estimate;
  if (summary.quantity_names.empty()) {
    estimate.trouble = "the scene has no quantity to estimate";
    return estimate;
  }
  try {
    const CompanionRun companion = run_companion(chosen, options);
    std::vector<std::string> kinds;
    for (const std::string& name : summary.quantity_names) kinds.push_back(find_kind(chosen, name));
    estimate =
        compare_histories(history, companion.history, summary.quantity_names,
                          list_rising(summary.quantity_names, kinds), list_turning_times(chosen), kShare);
    estimate.factorisations = companion.summary.factorisations;
    estimate.degrees_of_freedom = companion.summary.degrees_of_freedom;
    if (companion.summary.time < summary.time * (1.0 - 1e-9) && chosen.stop.quantity.empty() &&
        estimate.trouble.empty())
      estimate.trouble = "the companion ended at " + print_short(companion.summary.time) +
                         " s: " + companion.summary.message;
  } catch (const InputError& error) {  // so coarse a mesh does not always stand
    estimate.trouble = error.what();
  }
  estimate.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return estimate;
}

}  // namespace

void add_estimate(const Scene& chosen, const RunOptions& options, const QuantityHistory& history,
                  RunSummary& summary) {
  summary.estimate = estimate_error(chosen, options, history, summary);
  const ErrorEstimate& estimate = *summary.estimate;
  const auto warn = [&summary](const std::string& text) {
    summary.warnings.push_back({summary.increments, summary.time, "accuracy", text});
  };
  if (!estimate.trouble.empty()) warn("the error could not be estimated up to the end: " + estimate.trouble);
  if (estimate.worst > chosen.accuracy) {
    warn("the error is estimated at " + print_short(100.0 * estimate.worst, "%.2g") + " %, more than the " +
         print_short(100.0 * chosen.accuracy) + " % asked for");
  }
}

std::string describe_estimate(const ErrorEstimate& estimate, double accuracy) {
  std::string text;
  if (!estimate.errors.empty()) {
    text = "estimated error (" + print_short(100.0 * accuracy) +
           " % asked for), from a run of half as many elements and increments:\n";
  }
  for (const QuantityError& item : estimate.errors) {
    text += "  " + item.name + " = " + print_short(item.value, "%.6g") + " +- " +
            print_short(item.error, "%.2g") + " (" + print_short(100.0 * item.relative, "%.2g") + " %) at " +
            print_short(item.time, "%.4g") + " s" +
            (item.relative > accuracy ? "  <- more than asked for" : "") + "\n";
  }
  if (!estimate.trouble.empty())
    text += "the error could not be estimated up to the end: " + estimate.trouble + "\n";
  return text;
}

}  // namespace hydroscope
