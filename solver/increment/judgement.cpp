// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "solver/increment/measures.h"

namespace hydroscope {

namespace {

enum Given : std::size_t { kNecking, kLocalisation, kPivots, kGivenCount };

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

Vec3 calc_centre(const Model& model, const State& state, std::size_t e) {
  Vec3 centre = Vec3::Zero();
  for (const int i : model.quads[e]) centre += 0.25 * state.configuration.x[static_cast<std::size_t>(i)];
  return centre;
}

double calc_mean_strain(const Model& model, const State& state, std::size_t e) {
  const auto n = static_cast<std::size_t>(kGaussPoints * model.law.rule.size());
  double sum = 0.0;
  for (std::size_t k = 0; k < n; ++k) sum += state.layers[e * n + k].point.plastic_strain;
  return sum / static_cast<double>(n);
}

/// Does any node of the element stick to a tool?
bool is_sticking(const Model& model, const State& state, std::size_t e) {
  for (const auto& contacts : state.contacts) {
    for (const int i : model.quads[e]) {
      if (contacts[static_cast<std::size_t>(i)].status == ContactStatus::kStick) return true;
    }
  }
  return false;
}

/// Follows how the strain of late is shared out: the last few per cent of the fastest element count.
void update_recent_strain(const Scratch& s, State& state) {
  constexpr double kMemory = 0.02;  // strain of the fastest element over which the past fades
  double fastest = 0.0;
  for (const ElementResponse& r : s.responses) fastest = std::max(fastest, r.plastic_increment);
  if (fastest <= 0.0) return;
  const double weight = std::min(1.0, fastest / kMemory);
  for (std::size_t e = 0; e < state.recent_strain.size(); ++e) {
    state.recent_strain[e] += weight * (s.responses[e].plastic_increment / fastest - state.recent_strain[e]);
  }
}

/// Recent plastic strain of an element against the mean of those within a few wall
/// thicknesses of it but not next to it.
double calc_rate_ratio(const Model& model, const State& state, std::size_t e) {
  const Vec3 centre = calc_centre(model, state, e);
  const double inner = 1.5 * std::max(model.thickness, model.element_size), outer = 2.5 * inner;
  double sum = 0.0;
  int count = 0;
  for (std::size_t other = 0; other < model.quads.size(); ++other) {
    const double distance = (calc_centre(model, state, other) - centre).norm();
    if (distance < inner || distance > outer) continue;
    sum += state.recent_strain[other];
    ++count;
  }
  if (count == 0 || state.recent_strain[e] <= 0.0) return 0.0;
  return state.recent_strain[e] / std::max(sum / count, 1e-6);
}

struct Weakest {
  int element = -1;
  double strain = 0.0;
};

/// The element farthest past its force maximum that still stretches and does not stick.
Weakest find_necking(const Model& model, const Scratch& s, const State& state) {
  Weakest weakest;
  const Hardening& hardening = model.law.sheet.material.hardening;
  double largest = 0.0;
  for (const ElementResponse& r : s.responses) largest = std::max(largest, r.plastic_increment);
  for (std::size_t e = 0; e < model.quads.size(); ++e) {
    if (s.responses[e].plastic_increment < 0.3 * largest) continue;
    const double strain = calc_mean_strain(model, state, e);
    if (strain <= weakest.strain) continue;
    const auto flow = hardening(strain);
    const bool is_past = flow.slope < 0.5 * std::numbers::sqrt3 * flow.stress;  // plane-strain Considère
    double thickness = 0.0;
    for (const int i : model.quads[e]) thickness += 0.25 * state.wall[static_cast<std::size_t>(i)];
    // A wall that has not thinned by as much has been compressed or bent, not stretched.
    const bool is_stretched =
        std::log(model.thickness / thickness) > 0.7 * 0.5 * std::numbers::sqrt3 * strain;
    if (is_past && is_stretched && !is_sticking(model, state, e)) weakest = {static_cast<int>(e), strain};
  }
  return weakest;
}

void warn(State& state, IncrementReport& report, Given kind, const char* name, const std::string& text) {
  if (state.has_warned.size() < kGivenCount) state.has_warned.assign(kGivenCount, 0);
  if (state.has_warned[kind] != 0) return;
  state.has_warned[kind] = 1;
  report.warnings.push_back({report.increment, report.time, name, text});
}

void end_bursting(IncrementReport& report, const std::string& message) {
  report.outcome = Outcome::kBursting;
  report.message = message;
}

void judge_necking(const Model& model, const Scratch& s, State& state, IncrementReport& report) {
  const Weakest weakest = find_necking(model, s, state);
  if (weakest.element < 0) return;
  const auto e = static_cast<std::size_t>(weakest.element);
  const Vec3 at = calc_centre(model, state, e);
  const std::string place =
      format(" at (%.1f, %.1f, %.1f) mm, pressure %.4g MPa", at[0], at[1], at[2], state.pressure);
  warn(state, report, kNecking, "necking",
       "the wall has passed the maximum of its force" + place +
           format(" (plastic strain %.3f): from here on it may neck and no mesh converges", weakest.strain));
  const double ratio = calc_rate_ratio(model, state, e);
  if (ratio > model.limits.localisation) {
    const std::string text =
        "the strain localises" + place + format(": %.1f times the rate of its surroundings", ratio);
    warn(state, report, kLocalisation, "localisation", text);
    return end_bursting(report, "bursting: " + text);
  }
  if (model.limits.on_necking == "stop") end_bursting(report, "bursting: the wall necks" + place);
}

}  // namespace

void judge(const Model& model, const Scratch& s, State& state, IncrementReport& report) {
  if (model.law.sheet.material.hardening.is_plastic()) {
    update_recent_strain(s, state);
    judge_necking(model, s, state, report);
  }
  const int explained = model.use_volume_control ? 1 : 0;
  if (report.negative_pivots > explained) {
    warn(state, report, kPivots, "negative-pivot",
         std::to_string(report.negative_pivots) + " negative pivots" +
             format(" at %.4g MPa: more than a pressure maximum explains", state.pressure));
  }
  if (report.outcome != Outcome::kRunning) return;
  if (report.thickness_min < model.limits.min_thickness_ratio * model.thickness) {
    return end_bursting(report, format("bursting: the wall is down to %.4g mm of %.4g mm at %.4g MPa",
                                       report.thickness_min, model.thickness, state.pressure));
  }
  for (const LayerState& layer : state.layers) {
    if (layer.point.plastic_strain > model.limits.max_plastic_strain) {
      return end_bursting(report, format("bursting: plastic strain %.3g reached at %.4g MPa",
                                         layer.point.plastic_strain, state.pressure, 0, 0));
    }
  }
}

bool has_necked(const State& state) {
  return state.has_warned.size() > kNecking && state.has_warned[kNecking] != 0;
}

}  // namespace hydroscope
