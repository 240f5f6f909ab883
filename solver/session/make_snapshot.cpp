// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/make_snapshot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/increment/contact_step.h"
#include "solver/increment/evaluate.h"
#include "solver/increment/measures.h"
#include "solver/increment/release.h"

namespace hydroscope {

namespace {

/// Largest plastic strain of the layers at the Gauss point next to each node, averaged over its elements.
std::vector<double> calc_plastic_strain(const Model& model, const State& state) {
  std::vector<double> sum(model.x0.size(), 0.0), count(model.x0.size(), 0.0);
  const auto n_z = static_cast<std::size_t>(model.law.rule.size());
  for (std::size_t e = 0; e < model.quads.size(); ++e) {
    for (std::size_t a = 0; a < 4; ++a) {
      double largest = 0.0;
      for (std::size_t k = 0; k < n_z; ++k) {
        largest = std::max(largest, state.layers[(e * kGaussPoints + a) * n_z + k].point.plastic_strain);
      }
      sum[static_cast<std::size_t>(model.quads[e][a])] += largest;
      count[static_cast<std::size_t>(model.quads[e][a])] += 1.0;
    }
  }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] /= std::max(count[i], 1.0);
  return sum;
}

/// Takes over what one tool does at a node; the nearest tool gives the gap.
void add_contact(const Model& model, const State& state, std::size_t t, std::size_t i, Snapshot& s) {
  const ContactPoint& c = state.contacts[t][i];
  if (c.has_foot && !(std::abs(s.gap[i]) <= std::abs(c.foot.gap))) s.gap[i] = c.foot.gap;
  if (!c.is_active()) {
    const bool has_just_let_go = c.last_toggle == state.increment && c.toggles > 0 && state.increment > 0;
    if (has_just_let_go && s.contact_state[i] == ContactClass::kFree) {
      s.contact_state[i] = ContactClass::kDetachedNow;
    }
    return;
  }
  s.contact_state[i] = c.status == ContactStatus::kStick ? ContactClass::kStick : ContactClass::kSlip;
  s.contact_tool[i] = static_cast<int>(t);
  const Vec3 force = c.normal_force * c.foot.normal + c.friction;
  s.contact_force[i] += force;
  s.tool_force[t] += force;
  s.contact_pressure[i] += calc_smoothed_pressure(model, state.contacts[t], state.area, static_cast<int>(i));
  s.tool_normal[i] = c.foot.normal;
  s.slip[i] = c.slip;
  s.slip_increment[i] = c.slip_increment;
}

/// Mean normal force of the nodes that a tool presses [N].
double calc_mean_press(const std::vector<ContactPoint>& contacts) {
  double sum = 0.0;
  int pressed = 0;
  for (const ContactPoint& c : contacts) {
    if (!c.is_active() || c.normal_force <= 0.0) continue;
    sum += c.normal_force;
    ++pressed;
  }
  return pressed > 0 ? sum / pressed : 0.0;
}

/// When nodes let go, how often, and against which force those in contact would (mechanics 9.4).
void add_contact_life(const Model& model, const State& state, const std::vector<double>& times, Snapshot& s) {
  const std::size_t n = s.points.size();
  s.let_go_time.assign(n, std::numeric_limits<double>::quiet_NaN());
  s.toggles.assign(n, 0);
  s.release_reference.assign(n, 0.0);
  s.release_threshold.assign(n, 0.0);
  for (std::size_t t = 0; t < model.tools.size(); ++t) {
    const double mean = calc_mean_press(state.contacts[t]);
    for (std::size_t i = 0; i < n; ++i) {
      const ContactPoint& c = state.contacts[t][i];
      s.toggles[i] += std::max(0, c.toggles - 1);  // the first is the first touch
      if (c.is_active()) {
        s.release_reference[i] = std::max(std::abs(state.pressure) * state.area[i], 0.1 * mean);
        if (model.release == ReleaseRule::kFull)  // the sign rules let go whatever pulls
          s.release_threshold[i] = model.contact.release_tolerance * s.release_reference[i];
      } else if (s.contact_tool[i] < 0 && c.toggles > 0 &&
                 static_cast<std::size_t>(c.last_toggle) < times.size()) {
        s.let_go_time[i] = std::fmax(s.let_go_time[i], times[static_cast<std::size_t>(c.last_toggle)]);
      }
    }
  }
}

/// The part of a force along the directions in which a node is held: what is left
/// of a reaction across them is out of balance, and no support bears it.
Vec3 calc_borne(const std::vector<Support>& supports, const Vec3& force) {
  Vec3 borne = Vec3::Zero();
  std::vector<Vec3> axes;
  for (const Support& support : supports) {
    if (support.kind == Support::Kind::kClamp) continue;
    Vec3 axis = support.direction;
    for (const Vec3& other : axes) axis -= other.dot(axis) * other;
    if (axis.norm() < 1e-9) continue;
    axes.push_back(axis.normalized());
    borne += axes.back().dot(force) * axes.back();
  }
  return borne;
}

/// What holds and loads the sheet beside fluid and tools.
std::vector<Vec3> calc_support_force(const Model& model, const State& state) {
  Trial trial;
  trial.configuration = state.configuration;
  trial.other_load = Vector::Zero(static_cast<Eigen::Index>(kDofs * model.x0.size()));
  evaluate_edge_loads(model, {.time = state.time, .pressure = state.pressure}, trial);
  std::vector<Vec3> forces;
  for (std::size_t i = 0; i < model.x0.size(); ++i)
    forces.push_back(calc_borne(model.supports[i], state.reaction[i]) +
                     trial.other_load.segment<3>(static_cast<Eigen::Index>(kDofs * i)));
  return forces;
}

Vec3 calc_shown_translation(const Tool& tool, double time) {
  constexpr double kGone = std::numeric_limits<double>::quiet_NaN();
  return tool.is_present(time) ? tool.calc_translation(time) : Vec3::Constant(kGone);
}

}  // namespace

std::shared_ptr<const Snapshot> make_snapshot(const Model& model, const State& state,
                                              std::shared_ptr<const SnapshotModel> shared,
                                              const std::vector<double>& times) {
  auto s = std::make_shared<Snapshot>();
  const std::size_t n = model.x0.size();
  s->model = std::move(shared);
  s->increment = state.increment;
  s->time = state.time;
  s->pressure = state.pressure;
  s->feed = model.feed(state.time);
  s->points = state.configuration.x;
  for (const Triad& t : state.configuration.triad) s->directors.push_back(t.v);
  s->thickness = state.wall;
  s->plastic_strain = calc_plastic_strain(model, state);
  s->contact_state.assign(n, ContactClass::kFree);
  s->contact_tool.assign(n, -1);
  s->gap.assign(n, std::numeric_limits<double>::quiet_NaN());
  s->contact_pressure.assign(n, 0.0);
  for (auto* field : {&s->contact_force, &s->tool_normal, &s->slip, &s->slip_increment}) {
    field->assign(n, Vec3::Zero());
  }
  s->support_force = calc_support_force(model, state);
  s->tool_force.assign(model.tools.size(), Vec3::Zero());
  for (std::size_t t = 0; t < model.tools.size(); ++t) {
    for (std::size_t i = 0; i < n; ++i) add_contact(model, state, t, i, *s);
    s->tool_translation.push_back(calc_shown_translation(model.tools[t], state.time));
  }
  add_contact_life(model, state, times, *s);
  std::vector<double> values;
  for (const Quantity& q : model.quantities) {
    values.push_back(evaluate_quantity(model, state, q, values));
    s->quantities[q.name] = values.back();
  }
  return s;
}

}  // namespace hydroscope
