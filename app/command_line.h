// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace hydroscope {

/// One option of a command; help, parsing and shell completion come from it.
struct Option {
  std::string name;    ///< "--views"
  std::string letter;  ///< "-o", or ""
  std::string value;   ///< what its value is called in the help; "" for a flag
  std::string doc;
  bool may_repeat = false;
  std::vector<std::string> choices;  ///< for completion; parsing leaves values to whoever uses them
};

struct CommandSyntax {
  std::string name;                   ///< "run"
  std::vector<std::string> operands;  ///< {"SCENE"}: all required
  std::string operand_files;  ///< ending of the operand's files for completion: "toml", "" any, "/" folders
  std::string summary;        ///< one line
  std::string details;        ///< paragraphs and examples below the options
  std::vector<Option> options;
  std::vector<std::string> operand_choices;  ///< for completion
  std::string instead_of_operands{};         ///< an option with which the operands may be left out
};

/// A parsed command line.
class Arguments {
 public:
  std::vector<std::string> operands;
  std::map<std::string, std::vector<std::string>> values;  ///< by option name; a flag has one empty value

  bool has(const std::string& option) const { return values.count(option) > 0; }
  std::string get(const std::string& option, const std::string& standard = "") const;
  const std::vector<std::string>& get_all(const std::string& option) const;
};

/// Parses what follows the command's name. Throws InputError: unknown option with the
/// nearest known one, missing value, too many or too few operands.
Arguments parse_arguments(const CommandSyntax& syntax, const std::vector<std::string>& words);

/// A whole number from `low` to `high`, or InputError naming `option`.
int parse_whole_number(const std::string& option, const std::string& text, int low, int high);
double parse_number(const std::string& option, const std::string& text, double low, double high);

/// All commands, in the order in which help lists them.
const std::vector<CommandSyntax>& command_syntaxes();
const CommandSyntax* find_command(const std::string& name);

std::string make_help();
std::string make_command_help(const CommandSyntax& syntax);

/// Completion script for "bash" or "zsh"; throws InputError for other shells.
std::string make_completion(const std::string& shell);

}  // namespace hydroscope
