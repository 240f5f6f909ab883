// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/increment/step_limit.h"

#include <numbers>

#include "solver/contact/constraint.h"

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
    if (rotation > max_rotation)
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
        if (slide > max_slide) limit.reduce(max_slide / slide, Limiter::kSlide, static_cast<int>(i));
      } else if (closing > 0.0) {
        limit.reduce((std::max(point.foot.gap, 0.0) + allowance) / closing, Limiter::kTouch,
                     static_cast<int>(i));
      }
    }
  }
  return limit;
}

double calc_strain_fraction(const Model& model, const Trial& trial) {
  const double limit = model.increment.max_strain;
  return trial.strain_increment > limit ? limit / trial.strain_increment : 1.0;
}

}  // namespace hydroscope
