// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/step_limit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/contact/constraint.h"
#include "solver/increment/contact_step.h"

namespace hydroscope {

StepLimit calc_step_limit(const Model& model, const Vector& q, const Trial& trial) {
  StepLimit limit;
  const IncrementScene& settings = model.increment;
  const double max_rotation = settings.max_rotation * std::numbers::pi / 180.0;
  const double allowance = settings.max_penetration * model.thickness;
  const double max_slide = settings.max_slide * model.element_size;
  for (std::size_t i = 0; i < model.x0.size(); ++i) {
    const NodeVector step = q.segment<kDofs>(static_cast<Eigen::Index>(kDofs * i));
    const double rotation = step.tail<2>().norm();
    if (max_rotation > 0.0 && rotation > max_rotation)
      limit.reduce(max_rotation / rotation, Limiter::kRotation, static_cast<int>(i));
    for (std::size_t t = 0; t < model.tools.size(); ++t) {
      const ContactPoint& point = trial.contacts[t][i];
      if (!point.has_foot) continue;
      const SlavePoint slave{trial.configuration.triad[i],
                             model.tools[t].side * 0.5 * trial.configuration.thickness[i]};
      const Vec3 move = slave.calc_map() * step;
      const double closing = -point.foot.normal.dot(move);
      if (point.is_active()) {
        const double slide = (move + closing * point.foot.normal).norm();
        if (max_slide > 0.0 && slide > max_slide)
          limit.reduce(max_slide / slide, Limiter::kSlide, static_cast<int>(i));
      } else if (closing > 0.0) {
        limit.reduce((std::max(point.foot.gap, 0.0) + allowance) / closing, Limiter::kTouch,
                     static_cast<int>(i));
      }
    }
  }
  return limit;
}

bool stops_at(const Model& model, const char* event) {
  const auto& events = model.increment.stop_at;
  return std::find(events.begin(), events.end(), event) != events.end();
}

namespace {

/// First root in (0, 1) of |f + r df| = mu (t + r dt); 1 when there is none.
double find_slip(const Vec3& f, const Vec3& df, double mu, double t, double dt) {
  const double a = df.squaredNorm() - mu * mu * dt * dt, b = f.dot(df) - mu * mu * t * dt,
               c = f.squaredNorm() - mu * mu * t * t;
  const double root = b * b - a * c;
  if (c >= 0.0 || root < 0.0) return 1.0;
  const double r = -c / (b + std::sqrt(root));  // c < 0: the positive root
  return r > 0.0 ? std::min(r, 1.0) : 1.0;
}

}  // namespace

void limit_by_contact_events(const Model& model, const State& state, const Vector& q, const Scratch& s,
                             StepLimit& limit) {
  const bool at_release = stops_at(model, "release"), at_slip = stops_at(model, "slip");
  if (!at_release && !at_slip) return;
  constexpr double kPressed = 0.02;   // of the fluid's share of the node
  constexpr double kShortest = 0.02;  // nearer events are left to the corrector
  const auto stop = [&](double r, Limiter by, std::size_t i) {
    limit.reduce(std::max(kShortest, (1.0 + model.increment.cluster) * r), by, static_cast<int>(i));
  };
  for (std::size_t t = 0; t < model.tools.size(); ++t) {
    for (std::size_t i = 0; i < model.x0.size(); ++i) {
      const ContactPoint& start = state.contacts[t][i];
      const ContactPoint& point = s.trial.contacts[t][i];
      if (!start.is_active() || point.held_row < 0 || s.bases[i].is_eliminated(point.held_row)) continue;
      const NodeVector step = q.segment<kDofs>(static_cast<Eigen::Index>(kDofs * i));
      const NodeBasis& basis = s.bases[i];
      // The spring gives way by the step less the way of the tool; where forces are out of balance its own
      // force is not the node's.
      const double give = basis.value(point.held_row) + start.foot.gap - basis.row(point.held_row).dot(step),
                   now = start.normal_force, end = now + basis.stiffness(point.held_row) * give;
      // What hardly presses will let go sooner or later: no event to stop at.
      const double pressed = kPressed * std::abs(state.pressure) * s.trial.area[i];
      if (at_release && now > pressed && end < 0.0) stop(now / (now - end), Limiter::kRelease, i);
      if (!at_slip || start.status != ContactStatus::kStick || model.tools[t].friction <= 0.0) continue;
      const SlavePoint slave{s.trial.configuration.triad[i],
                             model.tools[t].side * 0.5 * s.trial.configuration.thickness[i]};
      const Vec3 move = slave.calc_map() * step, n = point.foot.normal;
      const Vec3 change = -calc_stick_stiffness(model, s.trial.area[i]) * (move - n.dot(move) * n);  // (4.45)
      const double r = find_slip(start.friction, change, model.tools[t].friction, now, end - now);   // (4.46)
      if (r < 1.0) stop(r, Limiter::kStickToSlip, i);
    }
  }
}

double calc_strain_fraction(const Model& model, const Trial& trial) {
  const double limit = model.increment.max_strain;
  return limit > 0.0 && trial.strain_increment > limit ? limit / trial.strain_increment : 1.0;
}

}  // namespace hydroscope
