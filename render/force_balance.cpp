// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/force_balance.h"

#include <algorithm>

namespace hydroscope {
namespace {

/// Sum of vectors and of their lengths.
struct Sum {
  Vec3 vector = Vec3::Zero();
  double length = 0.0;

  void add(const Vec3& v) {
    vector += v;
    length += v.norm();
  }
};

/// The area vector of a bilinear quadrilateral is half the product of its diagonals, exactly.
Sum calc_pressure(const Snapshot& s) {
  Sum sum;
  const auto face = [&s](int node) -> Vec3 {
    const auto i = static_cast<std::size_t>(node);
    return s.points[i] - (s.model->is_pressure_inside ? 0.5 * s.thickness[i] : 0.0) * s.directors[i];
  };
  for (const auto& quad : s.model->quads) {
    const Vec3 diagonal = face(quad[2]) - face(quad[0]), other = face(quad[3]) - face(quad[1]);
    sum.add(0.5 * s.pressure * diagonal.cross(other));
  }
  return sum;
}

bool is_contradiction(const Snapshot& s, std::size_t node) {
  const bool is_touching =
      s.contact_state[node] == ContactClass::kStick || s.contact_state[node] == ContactClass::kSlip;
  const bool has_tool = node < s.contact_tool.size() && s.contact_tool[node] >= 0;
  if (is_touching) return !has_tool;
  return has_tool || !s.contact_force[node].isZero(0.0);
}

}  // namespace

ForceBalance calc_force_balance(const Snapshot& s) {
  const Sum pressure = calc_pressure(s);
  Sum contact, support;
  for (const Vec3& force : s.contact_force) contact.add(force);
  for (const Vec3& force : s.support_force) support.add(force);
  ForceBalance balance;
  balance.pressure = pressure.vector;
  balance.contact = contact.vector;
  balance.support = support.vector;
  balance.scale = std::max({pressure.length, contact.length, support.length});
  balance.is_support_known = s.support_force.size() == s.points.size();
  if (balance.is_support_known) balance.rest = pressure.vector + contact.vector + support.vector;
  if (s.tool_force.size() == s.model->tools.size()) {
    Vec3 tools = Vec3::Zero();
    for (const Vec3& force : s.tool_force) tools += force;
    balance.contact_error = (contact.vector - tools).norm();
  }
  for (std::size_t node = 0; node < s.points.size(); ++node)
    balance.contradicting_nodes += is_contradiction(s, node) ? 1 : 0;
  return balance;
}

}  // namespace hydroscope
