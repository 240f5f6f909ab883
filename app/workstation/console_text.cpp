// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/console_text.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::array<char, 320> text{};
  std::snprintf(text.data(), text.size(), pattern, values...);
  return text.data();
}

std::string print(double number, const char* unit) {
  return std::isnan(number) ? "not known" : format("%.6g %s", number, unit);
}

std::string print(const Vec3& v, const char* unit) {
  return format("(%.6g, %.6g, %.6g) %s", v.x(), v.y(), v.z(), unit);
}

const char* name_phase(WorkstationStatus::Phase phase) {
  if (phase == WorkstationStatus::Phase::kRunning) return "running";
  return phase == WorkstationStatus::Phase::kPaused ? "paused" : "ended";
}

const char* name_contact(ContactClass contact) {
  static constexpr std::array<const char*, 4> kNames = {"free", "stick", "slip", "let go just now"};
  return kNames.at(static_cast<std::size_t>(contact));
}

std::string name_tool(const Snapshot& s, int tool) {
  return tool < 0 ? "" : s.model->tools[static_cast<std::size_t>(tool)].name;
}

}  // namespace

std::string describe_status(const WorkstationStatus& s) {
  std::string text = format("%s: increment %d, %.6g s of %.6g s, %.6g MPa", name_phase(s.phase), s.increment,
                            s.time, s.end_time, s.pressure);
  if (s.feed != 0.0) text += format(", feed %.6g mm", s.feed);
  text += format(", branch %d\n", s.branch);
  text += format("  contact %d (stick %d, slip %d), thinnest wall %.6g mm, residual %.3g", s.n_contact,
                 s.n_stick, s.n_slip, s.thickness_min, s.residual);
  if (!s.limited_by.empty()) text += ", limited by " + s.limited_by;
  text += format("\n  %d kept states, %d events, %d warnings, %.3g s in the solver\n", s.n_kept, s.n_events,
                 s.n_warnings, s.solver_s);
  if (!s.until.empty()) text += "  " + s.until + "\n";
  if (!s.message.empty()) text += "  " + s.message + "\n";
  return text;
}

std::string describe_kept(const std::vector<KeptState>& states) {
  std::string text = "branch increment       time s  pressure MPa touched slipped let go retouched kept as\n";
  for (const KeptState& s : states) {
    text += format("%6d %9d %12.6g %13.6g %7d %7d %6d %9d %s%s\n", s.branch, s.increment, s.time, s.pressure,
                   s.touched, s.slipped, s.detached, s.retouched, s.why.c_str(),
                   s.can_restore ? "" : " (to look at only)");
  }
  return text;
}

std::string describe_warnings(const std::vector<Warning>& warnings) {
  std::string text;
  for (const Warning& w : warnings)
    text += format("increment %d, %.6g s: ", w.increment, w.time) + w.kind + ": " + w.text + "\n";
  return text.empty() ? "no warnings\n" : text;
}

std::string describe_events(const std::vector<ContactEvent>& events, const Snapshot& snapshot,
                            std::size_t number) {
  std::string text;
  for (std::size_t i = events.size() - std::min(number, events.size()); i < events.size(); ++i) {
    const ContactEvent& e = events[i];
    text += format("increment %d, %.6g s: node %d %s (tool %s, %s), normal force %.4g -> %.4g N\n",
                   e.increment, e.time, e.node, to_string(e.kind), name_tool(snapshot, e.tool).c_str(),
                   e.cause.c_str(), e.force_before, e.force_after);
  }
  return text.empty() ? "no events\n" : text;
}

std::string describe_quantities(const Snapshot& snapshot) {
  std::string text;
  for (const auto& [name, value] : snapshot.quantities) text += name + format(" = %.6g\n", value);
  return text.empty() ? "the scene asks for no quantities\n" : text;
}

std::string describe_node(const Snapshot& s, int node) {
  if (node < 0 || node >= static_cast<int>(s.points.size()))
    throw InputError("there is no node " + std::to_string(node) + "; allowed: 0 to " +
                     std::to_string(s.points.size() - 1));
  const auto i = static_cast<std::size_t>(node);
  std::string text = format("node %d at increment %d, %.6g s\n", node, s.increment, s.time);
  text += "  place " + print(s.points[i], "mm") + ", wall " + print(s.thickness[i], "mm") +
          format(", plastic strain %.6g\n", s.plastic_strain[i]);
  text += std::string("  contact ") + name_contact(s.contact_state[i]);
  if (s.contact_tool[i] >= 0) text += " on " + name_tool(s, s.contact_tool[i]);
  text += ", gap " + print(s.gap[i], "mm") + "\n";
  const bool knows_life = !s.toggles.empty();
  if (s.contact_tool[i] >= 0) {
    const Vec3 n = s.tool_normal[i], force = s.contact_force[i];
    const double normal = n.dot(force);
    text += "  normal force " + print(normal, "N") + ", friction " + print((force - normal * n).norm(), "N") +
            ", contact pressure " + print(s.contact_pressure[i], "MPa") + "\n";
    if (knows_life)
      text += "  margin to letting go " + print(calc_release_margin(s, i), "N") + " (it lets go at " +
              print(-s.release_threshold[i], "N") + ")\n";
  }
  if (s.slip[i].norm() > 0.0) text += "  slipped by " + print(s.slip[i], "mm") + "\n";
  if (knows_life && !std::isnan(s.let_go_time[i]))
    text += "  let go at " + print(s.let_go_time[i], "s") + "\n";
  if (knows_life) text += format("  lettings go and comings back: %d\n", s.toggles[i]);
  return text;
}

}  // namespace hydroscope
