// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/node_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/server/api_json.h"
#include "render/contact_life.h"
#include "render/image/colour_map.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

constexpr double kUnknownValue = std::numeric_limits<double>::quiet_NaN();

/// What needs the tool at a touching node.
struct NodeContact {
  Json tool, normal;
  double normal_force = kUnknownValue, friction = kUnknownValue;  ///< [N]
};

std::size_t check_node(const Snapshot& s, int node) {
  if (node < 0 || node >= static_cast<int>(s.points.size()))
    throw InputError("there is no node " + std::to_string(node) + "; allowed: 0 to " +
                     std::to_string(static_cast<int>(s.points.size()) - 1));
  return static_cast<std::size_t>(node);
}

NodeContact find_contact(const Snapshot& s, std::size_t i) {
  NodeContact contact;
  const int tool = s.contact_tool[i];
  if (tool < 0) return contact;
  if (tool < static_cast<int>(s.model->tools.size()))
    contact.tool = s.model->tools[static_cast<std::size_t>(tool)].name;
  const Vec3& normal = s.tool_normal[i];
  contact.normal = make_vector_json(normal);
  contact.normal_force = s.contact_force[i].dot(normal);
  contact.friction = (s.contact_force[i] - contact.normal_force * normal).norm();
  return contact;
}

const char* contact_name(ContactClass contact) {
  return contact == ContactClass::kDetachedNow ? "detached" : class_name(contact);
}

/// Empty arrays belong to states that do not know.
double at(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? values[i] : kUnknownValue;
}

double calc_margin_force(const Snapshot& s, const ContactLife& life, std::size_t i) {
  return life.is_known ? at(life.margin, i) * at(s.release_reference, i) : kUnknownValue;
}

Json::Object make_spread(const Snapshot& s, const std::vector<double>& values,
                         const std::vector<int>& nodes) {
  double least = kUnknownValue, greatest = kUnknownValue, sum = 0.0;
  int count = 0;
  for (const int node : nodes) {
    const double value = at(values, check_node(s, node));
    if (std::isnan(value)) continue;
    least = std::fmin(least, value);
    greatest = std::fmax(greatest, value);
    sum += value;
    ++count;
  }
  return {
      {"min", least}, {"mean", count > 0 ? Json(sum / count) : Json()}, {"max", greatest}, {"count", count}};
}

}  // namespace

Json::Object make_node_record(const Snapshot& s, const Snapshot& first, int node, int branch) {
  const std::size_t i = check_node(s, node);
  const NodeContact contact = find_contact(s, i);
  const ContactLife life = calc_contact_life(s);
  const bool is_known = life.is_known;
  return {
      {"node", node},
      {"branch", branch},
      {"increment", s.increment},
      {"time_s", s.time},
      {"pressure_MPa", s.pressure},
      {"position_mm", make_vector_json(s.points[i])},
      {"displacement_mm", i < first.points.size() ? make_vector_json(s.points[i] - first.points[i]) : Json()},
      {"thickness_mm", at(s.thickness, i)},
      {"plastic_strain", at(s.plastic_strain, i)},
      {"contact", contact_name(s.contact_state[i])},
      {"tool", contact.tool},
      {"gap_mm", at(s.gap, i)},
      {"tool_normal", contact.normal},
      {"normal_force_N", contact.normal_force},
      {"friction_N", contact.friction},
      {"contact_pressure_MPa", at(s.contact_pressure, i)},
      {"slip_mm", s.slip[i].norm()},
      {"let_go_time_s", at(s.let_go_time, i)},
      {"toggles", is_known ? Json(s.toggles[i]) : Json()},
      {"release_threshold_N", contact.tool.is_null() ? Json() : Json(at(s.release_threshold, i))},
      {"margin_N", calc_margin_force(s, life, i)},
      {"margin_share", is_known ? Json(at(life.margin, i)) : Json()}};
}

Json::Object make_element_record(const Snapshot& s, int element) {
  if (element < 0 || element >= static_cast<int>(s.model->quads.size()))
    throw InputError("there is no element " + std::to_string(element));
  const std::array<int, 4>& quad = s.model->quads[static_cast<std::size_t>(element)];
  const std::vector<int> nodes(quad.begin(), quad.end());
  Json::Array names;
  for (const int node : nodes) names.emplace_back(node);
  Json::Object record = make_nodes_summary(s, nodes);
  record.insert(record.begin(), {{"element", element}, {"nodes", std::move(names)}});
  return record;
}

void NodeHistory::add(const Snapshot& s) {
  const std::size_t i = check_node(s, node_);
  const NodeContact contact = find_contact(s, i);
  increment_.emplace_back(s.increment);
  time_.emplace_back(s.time);
  pressure_.emplace_back(s.pressure);
  thickness_.emplace_back(at(s.thickness, i));
  plastic_strain_.emplace_back(at(s.plastic_strain, i));
  gap_.emplace_back(at(s.gap, i));
  normal_force_.emplace_back(contact.normal_force);
  margin_.emplace_back(calc_margin_force(s, calc_contact_life(s), i));
  contact_.emplace_back(contact_name(s.contact_state[i]));
  slip_.emplace_back(s.slip[i].norm());
}

Json NodeHistory::make_json() const {
  return Json::Object{{"node", node_},
                      {"increment", increment_},
                      {"time_s", time_},
                      {"pressure_MPa", pressure_},
                      {"thickness_mm", thickness_},
                      {"plastic_strain", plastic_strain_},
                      {"gap_mm", gap_},
                      {"normal_force_N", normal_force_},
                      {"margin_N", margin_},
                      {"contact", contact_},
                      {"slip_mm", slip_}};
}

Json::Object make_nodes_summary(const Snapshot& s, const std::vector<int>& nodes) {
  std::array<int, kContactClasses> counts{};
  for (const int node : nodes) ++counts[static_cast<std::size_t>(s.contact_state[check_node(s, node)])];
  Json::Object classes;
  for (int i = 0; i < kContactClasses; ++i)
    classes.emplace_back(contact_name(static_cast<ContactClass>(i)), counts[static_cast<std::size_t>(i)]);
  return {{"count", static_cast<int>(nodes.size())},
          {"contact", std::move(classes)},
          {"thickness_mm", make_spread(s, s.thickness, nodes)},
          {"plastic_strain", make_spread(s, s.plastic_strain, nodes)},
          {"contact_pressure_MPa", make_spread(s, s.contact_pressure, nodes)},
          {"gap_mm", make_spread(s, s.gap, nodes)}};
}

}  // namespace hydroscope
