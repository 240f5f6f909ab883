// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"
#include "solver/base/error.h"

namespace hydroscope {
namespace {

std::string join(const std::vector<std::string>& words) {
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : " ") + word;
  return joined;
}

/// What the shell offers for an operand of the command.
std::string make_bash_operand(const CommandSyntax& command) {
  if (!command.operand_choices.empty())
    return "compgen -W '" + join(command.operand_choices) + "' -- \"$word\"";
  if (command.operands.empty()) return ":";
  if (command.operand_files == "/") return "compgen -d -- \"$word\"";
  if (command.operand_files.empty()) return "compgen -f -- \"$word\"";
  return "compgen -d -- \"$word\"; compgen -f -X '!*." + command.operand_files + "' -- \"$word\"";
}

std::string make_bash() {
  std::string names;
  for (const CommandSyntax& command : command_syntaxes()) names += command.name + " ";
  std::string script =
      "# Completion of hydroscope for bash: eval \"$(hydroscope completion bash)\"\n"
      "_hydroscope() {\n"
      "  local word=\"${COMP_WORDS[COMP_CWORD]}\" last=\"${COMP_WORDS[COMP_CWORD-1]}\" IFS=$'\\n'\n"
      "  COMPREPLY=()\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(IFS=' '; compgen -W '" +
      names +
      "--help --version' -- \"$word\"))\n"
      "    return\n  fi\n"
      "  case \"${COMP_WORDS[1]} $last\" in\n";
  std::string options;
  for (const CommandSyntax& command : command_syntaxes()) {
    std::string flags;
    for (const Option& option : command.options) {
      flags += option.name + " ";
      const std::string names_of_option =
          "'" + command.name + " " + option.name + "'" +
          (option.letter.empty() ? "" : "|'" + command.name + " " + option.letter + "'");
      if (!option.choices.empty()) {
        script += "    " + names_of_option + ") COMPREPLY=($(IFS=' '; compgen -W '" + join(option.choices) +
                  "' -- \"$word\")); return ;;\n";
      } else if (!option.value.empty()) {
        script += "    " + names_of_option + ") COMPREPLY=($(compgen -f -- \"$word\")); return ;;\n";
      }
    }
    options += "    " + command.name + ") case \"$word\" in\n      -*) COMPREPLY=($(IFS=' '; compgen -W '" +
               flags + "--help' -- \"$word\")) ;;\n      *) COMPREPLY=($(" + make_bash_operand(command) +
               ")) ;;\n      esac ;;\n";
  }
  return script + "  esac\n  case \"${COMP_WORDS[1]}\" in\n" + options +
         "  esac\n}\ncomplete -o filenames -F _hydroscope hydroscope\n";
}

/// Brackets, colons and quotes end a part of a zsh specification.
std::string escape_zsh(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\n') break;
    if (c == '[' || c == ']' || c == ':') escaped += '\\';
    if (c == '\'') escaped += "'\\'";
    escaped += c;
  }
  return escaped;
}

std::string make_zsh_option(const Option& option) {
  std::string action;
  if (!option.choices.empty())
    action = ":" + option.value + ":(" + join(option.choices) + ")";
  else if (!option.value.empty())
    action = ":" + option.value + ":_files";
  const std::string doc = "[" + escape_zsh(option.doc) + "]";
  std::string lines =
      "        '" + std::string(option.may_repeat ? "*" : "") + option.name + doc + action + "' \\\n";
  if (!option.letter.empty()) lines += "        '" + option.letter + doc + action + "' \\\n";
  return lines;
}

std::string make_zsh() {
  std::string script =
      "#compdef hydroscope\n# Completion of hydroscope for zsh: put it as _hydroscope into a folder of "
      "$fpath.\n_hydroscope() {\n  if (( CURRENT == 2 )); then\n    local -a commands=(\n";
  for (const CommandSyntax& command : command_syntaxes())
    script += "      '" + command.name + ":" + escape_zsh(command.summary) + "'\n";
  script +=
      "    )\n    _describe command commands\n    return\n  fi\n  local command=${words[2]}\n  shift words; "
      "(( CURRENT-- ))\n  case $command in\n";
  for (const CommandSyntax& command : command_syntaxes()) {
    script += "    " + command.name + ")\n      _arguments \\\n";
    for (const Option& option : command.options) script += make_zsh_option(option);
    std::string files = "_files";
    if (!command.operand_choices.empty())
      files = "(" + join(command.operand_choices) + ")";
    else if (command.operand_files == "/")
      files = "_files -/";
    else if (!command.operand_files.empty())
      files = "_files -g \"*." + command.operand_files + "\"";
    if (!command.operands.empty())
      script += "        '1:" + command.operands.front() + ":" + files + "' \\\n";
    script += "        '--help[Show the help of the command]' ;;\n";
  }
  return script + "  esac\n}\ncompdef _hydroscope hydroscope\n";
}

}  // namespace

std::string make_completion(const std::string& shell) {
  if (shell == "bash") return make_bash();
  if (shell == "zsh") return make_zsh();
  throw InputError("hydroscope completion " + shell + ": there is completion for bash and zsh");
}

}  // namespace hydroscope
