// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <memory>

#include "solver/session/run.h"

namespace hydroscope::test {

/// Two quadrilaterals, one triangle as a tool, one mirror. Awkward numbers on purpose.
inline std::shared_ptr<const SnapshotModel> make_model() {
  auto model = std::make_shared<SnapshotModel>();
  model->title = "A \"sample\", with commas";
  model->quads = {{0, 1, 4, 3}, {1, 2, 5, 4}};
  model->mirrors = {{Vec3(0, 0, 0), Vec3(std::sqrt(0.5), -std::sqrt(0.5), 0)},
                    {Vec3(0, 0, 1.0 / 3.0), Vec3::UnitZ()}};
  model->is_pressure_inside = true;
  SnapshotModel::Tool tool;
  tool.name = "die";
  tool.mesh.points = {{0, 0, 0}, {1.0 / 3.0, 0, 0}, {0, 1e-300, -0.1}};
  tool.mesh.triangles = {{0, 1, 2}};
  tool.normals = {Vec3::UnitX(), Vec3::UnitY(), Vec3(0.6, 0.0, 0.8)};
  model->tools = {tool};
  return model;
}

inline std::shared_ptr<const Snapshot> make_snapshot(const std::shared_ptr<const SnapshotModel>& model,
                                                     int increment) {
  auto s = std::make_shared<Snapshot>();
  s->model = model;
  s->increment = increment;
  s->time = 0.1 * increment;
  s->pressure = 17.133 + increment / 3.0;
  s->feed = 1e-17;
  for (int i = 0; i < 6; ++i) {
    const double a = 1.0 / (i + 3.0), b = std::sin(i + increment);
    s->points.emplace_back(a, b, -a * b);
    s->directors.emplace_back(Vec3(b, a, 1).normalized());
    s->thickness.push_back(1.5 * a);
    s->plastic_strain.push_back(b * b);
    s->contact_state.push_back(static_cast<ContactClass>(i % 4));
    s->contact_tool.push_back(i % 2 - 1);
    s->gap.push_back(i == 2 ? std::numeric_limits<double>::quiet_NaN() : -0.0 + a * i);
    s->contact_pressure.push_back(5e-324 * i);
    s->contact_force.emplace_back(b, -0.0, 1e300);
    s->support_force.emplace_back(-b, 1.0 / 3.0, 0);
    s->tool_normal.emplace_back(0, 0, i);
    s->let_go_time.push_back(i == 1 ? std::numeric_limits<double>::quiet_NaN() : 0.1 / (i + 3.0));
    s->toggles.push_back(7 * i);
    s->release_reference.push_back(a * i);
    s->release_threshold.push_back(5e-324 * i);
    s->slip.emplace_back(a, a, b);
    s->slip_increment.emplace_back(a * 1e-9, 0, 0);
  }
  s->tool_translation = {Vec3(0, -1.0 / 7.0, 0)};
  s->tool_force = {Vec3(1e300, 0, -1.0 / 7.0)};
  s->quantities = {{"r45_mm", 1.0 / 7.0}, {"t_mm", 1.25}};
  return s;
}

inline IncrementReport make_report(int increment) {
  IncrementReport r;
  r.increment = increment;
  r.time = 0.1 * increment;
  r.pressure = 1.0 / 3.0;
  r.step_fraction = 0.75;
  r.limited_by = Limiter::kTouch;
  r.limited_at = 12;
  r.n_contact = 3;
  r.n_stick = 2;
  r.n_slip = 1;
  r.residual = 1.25e-5;
  r.tangential_rest = 0.0625;
  r.iterations = 4;
  r.factorisations = 3;
  r.thickness_min = 1.25;
  r.thickness_max = 1.5;
  r.quantities = {1.0 / 7.0, 1.25};
  return r;
}

inline ContactEvent make_event(int increment, const char* cause) {
  ContactEvent event;
  event.kind = EventKind::kDetach;
  event.increment = increment;
  event.time = 0.1 * increment;
  event.node = 7;
  event.position = Vec3(1, 2.5, -3);
  event.tool = 0;
  event.cause = cause;
  event.force_before = 12.5;
  event.force_after = -0.75;
  event.patch_pressure = -0.5;
  event.threshold = 0.25;
  event.gap = 0.125;
  return event;
}

inline RunSummary make_summary(Outcome outcome, int increments) {
  RunSummary summary;
  summary.outcome = outcome;
  summary.message = "because";
  summary.increments = increments;
  summary.factorisations = 2 * increments;
  summary.degrees_of_freedom = 30;
  summary.time = 0.1 * increments;
  summary.wall.search = 0.25;
  summary.quantity_names = {"r45_mm", "t_mm"};
  summary.quantities = {1.0 / 7.0, 1.25};
  summary.warnings = {{2, 0.2, "necking", "wall past its maximum"}};
  return summary;
}

}  // namespace hydroscope::test
