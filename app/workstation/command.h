// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hydroscope {

/// Where a run is to halt.
struct Halt {
  enum class Kind {
    kNever,
    kPressure,    ///< fluid pressure passes `value` [MPa]; met exactly under pressure control
    kTime,        ///< process time reaches `value` [s]; met exactly
    kTouch,       ///< the next node that touches a tool
    kSlip,        ///< the next node that begins to slip
    kDetachment,  ///< the next node that lets go
    kYield,       ///< the first plastic strain anywhere
    kThinning,    ///< the thinnest place has lost `value` of its wall (0.2 = 20 %)
    kNode         ///< node `node` lets go
  };
  Kind kind = Kind::kNever;
  double value = 0.0;
  int node = -1;
};

/// One act of steering, the same whether it is clicked, typed, read from a script or replayed.
struct Command {
  enum class Kind { kRun, kPause, kStep, kUntil, kSet, kBack, kStop };
  Kind kind = Kind::kPause;
  int count = 1;           ///< step: increments
  Halt halt;               ///< until
  std::string key, value;  ///< set: scene key and its TOML value
  int increment = -1;      ///< back: a kept state of the present branch or of its ancestors
};

/// Text of the console to a command:
///   run | pause | step [N] | until pressure P | until time T | until touch|slip|detachment|yield
///   | until thinning X | until node N | set KEY VALUE | back INCREMENT | stop
/// Throws InputError that names the word at fault, what is allowed and the nearest known word.
Command parse_command(const std::string& text);

/// The text that parse_command() reads back to the same command.
std::string to_text(const Command& command);

/// One line a command, for help.
struct CommandHelp {
  std::string form, doc;
};
const std::vector<CommandHelp>& steering_help();

}  // namespace hydroscope
