// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/command.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "solver/base/error.h"
#include "solver/scene/key_suggestion.h"
#include "solver/scene/number_text.h"

namespace hydroscope {
namespace {

struct HaltWord {
  const char* word;
  Halt::Kind kind;
  const char* argument;  ///< what follows; empty: nothing
};

constexpr HaltWord kHalts[] = {{"pressure", Halt::Kind::kPressure, "P"},    {"time", Halt::Kind::kTime, "T"},
                               {"touch", Halt::Kind::kTouch, ""},           {"slip", Halt::Kind::kSlip, ""},
                               {"detachment", Halt::Kind::kDetachment, ""}, {"yield", Halt::Kind::kYield, ""},
                               {"thinning", Halt::Kind::kThinning, "X"},    {"node", Halt::Kind::kNode, "N"}};

struct CommandWord {
  const char* word;
  Command::Kind kind;
};

constexpr CommandWord kCommands[] = {{"run", Command::Kind::kRun},   {"pause", Command::Kind::kPause},
                                     {"step", Command::Kind::kStep}, {"until", Command::Kind::kUntil},
                                     {"set", Command::Kind::kSet},   {"back", Command::Kind::kBack},
                                     {"stop", Command::Kind::kStop}};

[[noreturn]] void fail_word(const std::string& given, const std::string& what,
                            const std::vector<std::string>& known) {
  const std::string nearest = find_nearest_name(given, known);
  std::string list;
  for (const std::string& word : known) list += (list.empty() ? "" : ", ") + word;
  throw InputError("'" + given + "' is no " + what +
                   (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") + " (there are: " + list +
                   ")");
}

/// The words of a command, taken one after the other.
class Words {
 public:
  explicit Words(const std::string& text) : stream_(text) {}

  /// The next word; `what` is missed when there is none.
  std::string take(const std::string& what) {
    std::string word;
    if (!(stream_ >> word)) throw InputError("'" + before_ + "' lacks " + what);
    before_ += (before_.empty() ? "" : " ") + word;
    return word;
  }
  std::string take_or(const std::string& standard) {
    std::string word;
    return stream_ >> word ? word : standard;
  }
  std::string rest() {
    std::string text;
    std::getline(stream_ >> std::ws, text);
    const std::size_t last = text.find_last_not_of(" \t\r\n");
    return last == std::string::npos ? std::string() : text.substr(0, last + 1);
  }
  void end() {
    const std::string more = rest();
    if (!more.empty()) throw InputError("'" + before_ + "' is complete; '" + more + "' is too much");
  }

 private:
  std::istringstream stream_;
  std::string before_;
};

template <class Number>
Number parse_as(const std::string& text, const std::string& what) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    throw InputError("'" + text + "' is no " + what);
  return number;
}

int parse_count(const std::string& text, const std::string& what, int low) {
  const int number = parse_as<int>(text, what);
  if (number < low)
    throw InputError(what + " " + text + " is out of range; allowed: from " + std::to_string(low));
  return number;
}

double parse_value(const std::string& text, const std::string& what) {
  const double number = parse_as<double>(text, what);
  if (!std::isfinite(number)) throw InputError(what + " " + text + " is not a finite number");
  return number;
}

Halt parse_halt(Words& words) {
  std::vector<std::string> known;
  for (const HaltWord& halt : kHalts) known.emplace_back(halt.word);
  const std::string word = words.take(
      "what to halt at (pressure P, time T, touch, slip, detachment, yield, "
      "thinning X, node N)");
  Halt halt;
  for (const HaltWord& item : kHalts) {
    if (word == item.word) halt.kind = item.kind;
  }
  switch (halt.kind) {
    case Halt::Kind::kPressure:
      halt.value = parse_value(words.take("a pressure in MPa"), "pressure in MPa");
      break;
    case Halt::Kind::kTime:
      halt.value = parse_value(words.take("a process time in s"), "process time in s");
      break;
    case Halt::Kind::kThinning:
      halt.value = parse_value(words.take("a share of the wall (0.2: 20 %)"), "share of the wall");
      if (halt.value <= 0.0 || halt.value >= 1.0)
        throw InputError("thinning " + format_exact(halt.value) +
                         " is out of range; allowed: between 0 and 1 (0.2: 20 % of the wall)");
      break;
    case Halt::Kind::kNode:
      halt.node = parse_count(words.take("the number of a node"), "node", 0);
      break;
    case Halt::Kind::kNever:
      fail_word(word, "place to halt at", known);
    default:
      break;
  }
  return halt;
}

std::string halt_text(const Halt& halt) {
  for (const HaltWord& item : kHalts) {
    if (item.kind != halt.kind) continue;
    std::string text = std::string("until ") + item.word;
    if (halt.kind == Halt::Kind::kNode) return text + " " + std::to_string(halt.node);
    return *item.argument == '\0' ? text : text + " " + format_exact(halt.value);
  }
  return "run";
}

void parse_set(Words& words, Command& command) {
  command.key = words.take("a key and a value");
  const std::size_t equals = command.key.find('=');
  if (equals != std::string::npos) {  // as on the command line
    command.value = command.key.substr(equals + 1);
    command.key.resize(equals);
  }
  const std::string rest = words.rest();
  command.value += (command.value.empty() || rest.empty() ? "" : " ") + rest;
  if (command.value.starts_with("="))
    command.value = command.value.substr(command.value.find_first_not_of("= \t"));
  if (command.key.empty() || command.value.empty())
    throw InputError("'set " + command.key +
                     "' lacks a value (set KEY VALUE, e.g. set tool.die.friction 0.1)");
}

}  // namespace

Command parse_command(const std::string& text) {
  std::vector<std::string> known;
  for (const CommandWord& item : kCommands) known.emplace_back(item.word);
  Words words(text);
  const std::string word = words.take("a command");
  Command command;
  bool is_known = false;
  for (const CommandWord& item : kCommands) {
    if (word != item.word) continue;
    command.kind = item.kind;
    is_known = true;
  }
  if (!is_known) fail_word(word, "command", known);
  if (command.kind == Command::Kind::kStep)
    command.count = parse_count(words.take_or("1"), "number of increments", 1);
  if (command.kind == Command::Kind::kUntil) command.halt = parse_halt(words);
  if (command.kind == Command::Kind::kSet) parse_set(words, command);
  if (command.kind == Command::Kind::kBack)
    command.increment = parse_count(words.take("the increment of a kept state"), "increment", 0);
  words.end();
  return command;
}

std::string to_text(const Command& command) {
  switch (command.kind) {
    case Command::Kind::kRun:
      return "run";
    case Command::Kind::kPause:
      return "pause";
    case Command::Kind::kStep:
      return command.count == 1 ? "step" : "step " + std::to_string(command.count);
    case Command::Kind::kUntil:
      return halt_text(command.halt);
    case Command::Kind::kSet:
      return "set " + command.key + " " + command.value;
    case Command::Kind::kBack:
      return "back " + std::to_string(command.increment);
    case Command::Kind::kStop:
      break;
  }
  return "stop";
}

const std::vector<CommandHelp>& steering_help() {
  static const std::vector<CommandHelp> help = {
      {"run", "Go on to the end of the paths, or to the next pause."},
      {"pause", "Halt after the increment at work."},
      {"step [N]", "N increments (1), then halt."},
      {"until pressure P", "Halt where the pressure passes P MPa; exactly there under pressure control."},
      {"until time T", "Halt exactly at process time T s."},
      {"until touch", "Halt after the next increment in which a node touches a tool."},
      {"until slip", "... in which a node begins to slip."},
      {"until detachment", "... in which a node lets go."},
      {"until yield", "... with the first plastic strain anywhere."},
      {"until thinning X", "... in which the thinnest place has lost the share X of its wall (0.2: 20 %)."},
      {"until node N", "... in which node N lets go."},
      {"set KEY VALUE",
       "Change what is ahead: paths, friction, limits of increments ... (scene key, TOML value)."},
      {"back INCREMENT", "Go back to a kept state; what follows is a new branch."},
      {"stop", "End the run and write its summary."},
  };
  return help;
}

}  // namespace hydroscope
