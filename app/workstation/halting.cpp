// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/halting.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "solver/base/error.h"
#include "solver/scene/number_text.h"

namespace hydroscope {

namespace {

std::string print_short(double number) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.6g", number);
  return text.data();
}

bool is_yielding(const State& state) {
  return std::any_of(state.layers.begin(), state.layers.end(),
                     [](const LayerState& layer) { return layer.point.plastic_strain > 0.0; });
}

/// Share of its wall that the thinnest place has lost.
double calc_thinning(const SteeredRun& run) {
  const auto& wall = run.state().wall;
  return 1.0 - *std::min_element(wall.begin(), wall.end()) / run.model().thickness;
}

std::string describe_node(const ContactEvent& event, const SteeredRun& run) {
  std::string text = "node " + std::to_string(event.node);
  if (event.tool >= 0) text += " (tool " + run.model().tools[static_cast<std::size_t>(event.tool)].name + ")";
  return text;
}

/// "3 nodes began to slip, first node 7 (tool die)"; empty when no event fits.
template <class Fits>
std::string count_events(const StepResult& step, const SteeredRun& run, const char* what, const Fits& fits) {
  int number = 0;
  std::string first;
  for (const ContactEvent& event : step.report.events) {
    if (fits(event) && number++ == 0) first = describe_node(event, run);
  }
  if (number == 0) return {};
  return number == 1 ? first + " " + what : std::to_string(number) + " nodes " + what + ", first " + first;
}

/// A node may slip from its first touch on.
bool begins_to_slip(const ContactEvent& event, const SteeredRun& run) {
  if (event.kind == EventKind::kSlip) return true;
  if (event.kind != EventKind::kTouch && event.kind != EventKind::kRetouch) return false;
  const auto t = static_cast<std::size_t>(event.tool), i = static_cast<std::size_t>(event.node);
  return run.model().tools[t].friction > 0.0 && run.state().contacts[t][i].status == ContactStatus::kSlip;
}

}  // namespace

void Halting::arm(const Halt& halt, const SteeredRun& run) {
  Halting armed;
  armed.halt_ = halt;
  armed.pressure_before_ = run.state().pressure;
  armed.aim(run);
  *this = armed;
}

void Halting::aim(const SteeredRun& run) {
  const Model& model = run.model();
  const State& state = run.state();
  switch (halt_.kind) {
    case Halt::Kind::kTime:
      if (halt_.value <= state.time * (1.0 + 1e-12) || halt_.value > model.end_time)
        throw InputError("time " + print_short(halt_.value) + " s is not ahead; allowed: after " +
                         format_exact(state.time) + " s, up to " + print_short(model.end_time) + " s");
      time_ = halt_.value;
      break;
    case Halt::Kind::kPressure:
      if (model.use_volume_control) {
        if (halt_.value == state.pressure)
          throw InputError("the pressure is " + print_short(halt_.value) + " MPa now");
        break;
      }
      time_ = find_crossing(model.pressure, state.time, halt_.value);
      if (time_ == kNoHalt)
        throw InputError("the pressure path does not pass " + print_short(halt_.value) +
                         " MPa any more; it is " + print_short(model.pressure(state.time)) + " MPa now");
      break;
    case Halt::Kind::kYield:
      if (is_yielding(state)) throw InputError("the wall has begun to yield already");
      break;
    case Halt::Kind::kThinning:
      if (calc_thinning(run) >= halt_.value)
        throw InputError("the thinnest place has lost " + print_short(calc_thinning(run)) +
                         " of its wall already");
      break;
    case Halt::Kind::kNode:
      if (halt_.node >= model.n_nodes())
        throw InputError("there is no node " + std::to_string(halt_.node) + "; allowed: 0 to " +
                         std::to_string(model.n_nodes() - 1));
      break;
    default:
      break;
  }
}

std::string Halting::text() const {
  Command command;
  command.kind = Command::Kind::kUntil;
  command.halt = halt_;
  return is_armed() ? to_text(command) : std::string();
}

std::string Halting::judge(const StepResult& step, const SteeredRun& run) const {
  const State& state = run.state();
  const auto is_kind = [](EventKind kind) {
    return [kind](const ContactEvent& event) { return event.kind == kind; };
  };
  const bool has_arrived = state.time >= time_ * (1.0 - 1e-12);
  switch (halt_.kind) {
    case Halt::Kind::kTime:
      return has_arrived ? "time " + print_short(halt_.value) + " s reached" : "";
    case Halt::Kind::kPressure: {
      const bool has_passed =
          pressure_before_ < halt_.value ? state.pressure >= halt_.value : state.pressure <= halt_.value;
      const bool is_there = run.model().use_volume_control ? has_passed : has_arrived;
      return is_there ? "pressure " + print_short(state.pressure) + " MPa reached" : "";
    }
    case Halt::Kind::kTouch:
      return count_events(step, run, "touched", [](const ContactEvent& event) {
        return event.kind == EventKind::kTouch || event.kind == EventKind::kRetouch;
      });
    case Halt::Kind::kSlip:
      return count_events(step, run, "began to slip",
                          [&run](const ContactEvent& event) { return begins_to_slip(event, run); });
    case Halt::Kind::kDetachment:
      return count_events(step, run, "let go", is_kind(EventKind::kDetach));
    case Halt::Kind::kNode:
      return count_events(step, run, "let go", [this](const ContactEvent& event) {
        return event.kind == EventKind::kDetach && event.node == halt_.node;
      });
    case Halt::Kind::kYield:
      return is_yielding(state) ? "the wall begins to yield at " + print_short(state.pressure) + " MPa" : "";
    case Halt::Kind::kThinning: {
      const double thinning = calc_thinning(run);
      return thinning >= halt_.value ? "the thinnest place has lost " + print_short(thinning) + " of its wall"
                                     : "";
    }
    case Halt::Kind::kNever:
      break;
  }
  return {};
}

}  // namespace hydroscope
