// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/contact_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/contact/constraint.h"
#include "solver/increment/release.h"

namespace hydroscope {

namespace {

SlavePoint make_slave_point(const Configuration& c, std::size_t i, const Tool& tool) {
  return {c.triad[i], tool.side * 0.5 * c.thickness[i]};
}

/// Stiffness of the outer half of the wall under contact pressure, E A / (h/2) [N/mm].
double calc_wall_stiffness(const Model& model, double area) {
  if (model.contact.wall_stiffness <= 0.0) return std::numeric_limits<double>::infinity();
  return model.contact.wall_stiffness * 2.0 * model.law.sheet.material.youngs_modulus / model.thickness *
         area;
}

void add_supports(const Model& model, const Loads& loads, const Configuration& c, std::size_t i,
                  NodeBasis& basis) {
  const Triad& t = c.triad[i];
  for (const Support& support : model.supports[i]) {
    NodeVector row = NodeVector::Zero();
    const Vec3& d = support.direction;
    if (support.kind == Support::Kind::kClamp) {
      basis.add_row(NodeVector::Unit(3), 0.0);
      basis.add_row(NodeVector::Unit(4), 0.0);
      continue;
    }
    const double target =
        support.motion < 0 ? 0.0 : model.motions[static_cast<std::size_t>(support.motion)](loads.time);
    row.head<3>() = d;
    basis.add_row(row, target - d.dot(c.x[i] - model.x0[i]));
    if (support.kind == Support::Kind::kSymmetry) {  // the fibre may turn about the plane's normal only
      const Vec3 axis = t.v.cross(d);
      row.setZero();
      row[3] = t.v1.dot(axis);
      row[4] = t.v2.dot(axis);
      basis.add_row(row, -t.v.dot(d));
    }
  }
}

/// Do the node's supports leave it (almost) no way along `normal`?
bool is_held_along(const Model& model, std::size_t i, const Vec3& normal) {
  constexpr double kFree = 0.3;  // share of the normal that must be free
  NodeBasis basis;
  for (const Support& support : model.supports[i]) {
    if (support.kind == Support::Kind::kClamp) continue;
    NodeVector row = NodeVector::Zero();
    row.head<3>() = support.direction;
    basis.add_row(row, 0.0);
  }
  if (basis.n_held() == 0) return false;
  basis.finish();
  for (int k = basis.n_held(); k < kDofs; ++k) {
    const NodeVector z = basis.transform().col(k);
    if (z.head<3>().dot(normal) > kFree || z.head<3>().dot(normal) < -kFree) return false;
  }
  return true;
}

/// Friction by the law of the scene.
FrictionResult calc_point_friction(const Model& model, const ContactPoint& start, const Tool& tool,
                                   double area, const ContactPoint& point) {
  const Vec3 slide = point.position - point.anchor, n = point.foot.normal;
  const double stick = calc_stick_stiffness(model, area);
  if (tool.friction > 0.0 && model.friction_law != FrictionLaw::kReturnMapping) {
    const bool slips =
        model.friction_law == FrictionLaw::kOneStepBehind && start.status == ContactStatus::kSlip;
    return calc_lagging_friction(start.friction, slips, slide, n, stick);
  }
  return calc_friction(start.friction, slide, n, point.friction_normal, tool.friction, stick);
}

/// Contact of one node with one tool: constraint row, normal force, friction, stiffness.
void evaluate_point(const Model& model, const Loads& loads, const ContactPoint& start, const Tool& tool,
                    std::size_t i, const NodeVector& residual, bool freeze_friction, Scratch& s,
                    ContactPoint& point) {
  Trial& trial = s.trial;
  const auto at = static_cast<Eigen::Index>(kDofs * i);
  const SlavePoint slave = make_slave_point(trial.configuration, i, tool);
  point.normal_force = point.held_row < 0
                           ? 0.0
                           : -s.bases[i].transform().col(point.held_row).dot(residual);  // t_N, mechanics 9.1
  if (!freeze_friction || point.friction_normal <= 0.0) {
    // Far from equilibrium the normal force may be anything; friction must not follow it there.
    const double bound = 2.0 * std::max(start.normal_force, 2.0 * std::abs(loads.pressure) * trial.area[i]);
    point.friction_normal = loads.pressure != 0.0 ? std::min(point.normal_force, bound) : point.normal_force;
  }
  const FrictionResult friction = calc_point_friction(model, start, tool, trial.area[i], point);
  point.friction = friction.force;
  point.status = friction.is_slipping ? ContactStatus::kSlip : ContactStatus::kStick;
  const auto map = slave.calc_map();
  trial.friction.segment<kDofs>(at) += map.transpose() * friction.force;
  trial.normal_reaction.segment<3>(at) += point.normal_force * point.foot.normal;
  FootPoint foot = point.foot;
  if (model.curvature == Curvature::kKnownRadius && tool.known_radius > 0.0)
    foot.normal_gradient = calc_known_gradient(foot, tool.known_radius);
  s.node_blocks[i] +=
      calc_contact_stiffness(slave, foot, point.normal_force, friction, model.curvature != Curvature::kNone,
                             model.curvature != Curvature::kFull);
}

/// Where a node that went through the tool in this increment crossed its surface.
Vec3 calc_anchor(const ContactPoint& before, const ContactPoint& now) {
  if (!before.has_foot || before.foot.gap <= 0.0) return before.has_foot ? before.position : now.position;
  const double share = before.foot.gap / (before.foot.gap - now.foot.gap);
  return before.position + std::clamp(share, 0.0, 1.0) * (now.position - before.position);
}

SpringChange make_spring(const Model& model, const Trial& trial, std::size_t t, std::size_t i, double sign) {
  const SlavePoint slave = make_slave_point(trial.configuration, i, model.tools[t]);
  return {static_cast<int>(i), calc_gap_row(slave, trial.contacts[t][i].foot.normal),
          sign * calc_wall_stiffness(model, trial.area[i])};
}

/// Free nodes that have gone through the tool touch it.
void take_touches(const Model& model, const State& state, std::size_t t, Trial& trial, SetChange& change) {
  const double through = model.contact.wall_stiffness > 0.0 ? 0.0 : -0.1 * model.touch_tolerance();
  auto& contacts = trial.contacts[t];
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    ContactPoint& point = contacts[i];
    if (point.is_active()) continue;
    const bool is_on_tool = point.has_foot && point.foot.beyond_edge <= 0.5 * model.thickness;
    if (!is_on_tool || point.foot.gap >= through) continue;
    point.anchor = calc_anchor(state.contacts[t][i], point);
    point.status = ContactStatus::kStick;
    point.friction.setZero();
    point.friction_normal = 0.0;
    ++(point.is_releasing ? change.reclosed : change.touched);
    if (point.is_releasing) point.locked = 5;  // the fluid pushes it back: not a release
    point.is_releasing = false;
    change.springs.push_back(make_spring(model, trial, t, i, 1.0));
  }
}

}  // namespace

double calc_stick_stiffness(const Model& model, double area) {
  return model.contact.stick_stiffness * model.law.sheet.material.youngs_modulus / model.thickness * area;
}

void search_contacts(const Model& model, const Loads& loads, Scratch& s) {
  const PhaseTimer timer(s.times.search);
  Trial& trial = s.trial;
  const double band = std::max(3.0 * model.thickness, 1.5 * model.element_size);
  const double depth = std::max(2.0 * model.thickness, model.element_size);
  for (std::size_t t = 0; t < model.tools.size(); ++t) {
    const Tool& tool = model.tools[t];
    const Vec3 translation = tool.calc_translation(loads.time);
    const bool is_present = tool.is_present(loads.time);
    s.pool.for_ranges(trial.contacts[t].size(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        ContactPoint& point = trial.contacts[t][i];
        const SlavePoint slave = make_slave_point(trial.configuration, i, tool);
        point.position = trial.configuration.x[i] + slave.offset * slave.triad.v - translation;
        point.has_foot = false;
        if (!is_present) {
          set_free(point, {ReleaseCause::kToolTaken, point.normal_force, 0.0, 0.0});
          continue;
        }
        // A node in contact is looked for farther: it must not be lost by one long step.
        const double reach = point.is_active() ? 2.0 : 1.0;
        const auto foot =
            tool.surface->find_foot_point(point.position, reach * band, reach * depth, point.hint);
        if (!foot) continue;
        point.has_foot = true;
        point.foot = *foot;
        point.foot.point += translation;
      }
    });
  }
}

void evaluate_contacts(const Model& model, const State& state, const Loads& loads, bool freeze_friction,
                       Scratch& s) {
  const PhaseTimer timer(s.times.search);
  Trial& trial = s.trial;
  trial.friction.setZero();
  trial.normal_reaction.setZero();
  const Vector residual = trial.calc_residual(loads);
  for (std::size_t i = 0; i < model.x0.size(); ++i) {
    s.node_blocks[i].setZero();
    NodeBasis basis;
    add_supports(model, loads, trial.configuration, i, basis);
    bool touches = false;
    for (std::size_t t = 0; t < model.tools.size(); ++t) {
      ContactPoint& point = trial.contacts[t][i];
      if (point.is_active() && !point.has_foot) {  // slid off or far away: no longer this tool's
        set_free(point, {ReleaseCause::kLost, point.normal_force, 0.0, 0.0});
      }
      if (!point.is_active()) continue;
      touches = true;
      const NodeVector row =
          calc_gap_row(make_slave_point(trial.configuration, i, model.tools[t]), point.foot.normal);
      if (is_held_along(model, i,
                        point.foot.normal)) {  // its support already decides: only the fibre could turn
        point.held_row = -1;
        continue;
      }
      point.held_row = basis.add_row(row, -point.foot.gap, calc_wall_stiffness(model, trial.area[i]));
    }
    basis.finish();
    s.bases[i] = basis;
    if (!touches) continue;
    const NodeVector r = residual.segment<kDofs>(static_cast<Eigen::Index>(kDofs * i));
    for (std::size_t t = 0; t < model.tools.size(); ++t) {
      ContactPoint& point = trial.contacts[t][i];
      if (point.is_active())
        evaluate_point(model, loads, state.contacts[t][i], model.tools[t], i, r, freeze_friction, s, point);
    }
  }
}

SetChange update_contact_set(const Model& model, const State& state, const Loads& loads, bool may_release,
                             Scratch& s) {
  Trial& trial = s.trial;
  SetChange change;
  for (std::size_t t = 0; t < model.tools.size(); ++t) {
    take_touches(model, state, t, trial, change);
    if (!may_release || model.release != ReleaseRule::kFull) continue;
    for (const NodeRelease& release : find_releases(model, loads, t, trial)) {
      ContactPoint& point = trial.contacts[t][release.node];
      change.springs.push_back(make_spring(model, trial, t, release.node, -1.0));
      set_free(point, release.why);
      point.is_releasing = true;
      ++change.released;
    }
  }
  return change;
}

void renew_friction(const Model& model, Scratch& s) {
  if (model.friction_law != FrictionLaw::kOneStepBehind) return;
  Trial& trial = s.trial;
  const double shortest = 1e-6 * model.thickness;
  for (std::size_t t = 0; t < model.tools.size(); ++t) {
    const Tool& tool = model.tools[t];
    for (std::size_t i = 0; tool.friction > 0.0 && i < trial.contacts[t].size(); ++i) {
      ContactPoint& point = trial.contacts[t][i];
      if (!point.is_active()) continue;
      const FrictionResult renewed = renew_lagging_friction(
          point.friction, point.status == ContactStatus::kSlip, point.position - point.anchor,
          point.foot.normal, point.normal_force, tool.friction, shortest);
      const auto map = make_slave_point(trial.configuration, i, tool).calc_map();
      trial.friction.segment<kDofs>(static_cast<Eigen::Index>(kDofs * i)) +=
          map.transpose() * (renewed.force - point.friction);  // (4.48)
      point.friction = renewed.force;
      point.status = renewed.is_slipping ? ContactStatus::kSlip : ContactStatus::kStick;
    }
  }
}

double calc_tangential_rest(const Scratch& s, const Loads& loads) {
  const Trial& trial = s.trial;
  const Vector residual = trial.calc_residual(loads);
  double rest = 0.0, force = 0.0;
  for (const auto& contacts : trial.contacts) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const ContactPoint& c = contacts[i];
      if (!c.is_active() || c.held_row < 0) continue;
      // What the node's constraints do not hold: supports, and the tool itself.
      const auto free = s.bases[i].transform().rightCols(kDofs - s.bases[i].n_held());
      const NodeVector rest_force =
          free * (free.transpose() * residual.segment<kDofs>(static_cast<Eigen::Index>(kDofs * i)));
      const Vec3 r = rest_force.head<3>(), n = c.foot.normal;
      rest += (r - n.dot(r) * n).squaredNorm();
      force += c.normal_force * c.normal_force;
    }
  }
  return force > 0.0 ? std::sqrt(rest / force) : 0.0;
}

double calc_gap_error(const Trial& trial) {
  double error = 0.0;
  for (const auto& contacts : trial.contacts) {
    for (const ContactPoint& c : contacts) {
      if (c.is_active() && c.held_row >= 0) error = std::max(error, std::abs(c.foot.gap));
    }
  }
  return error;
}

}  // namespace hydroscope
