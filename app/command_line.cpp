// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <algorithm>
#include <charconv>

#include "solver/base/error.h"
#include "solver/scene/key_suggestion.h"
#include "solver/scene/number_text.h"

namespace hydroscope {
namespace {

const Option kHelp{"--help", "-h", "", "Show this help.", false, {}};

const Option& find_option(const CommandSyntax& syntax, const std::string& name) {
  if (name == kHelp.name || name == kHelp.letter) return kHelp;
  std::vector<std::string> names;
  for (const Option& option : syntax.options) {
    if (option.name == name || (!option.letter.empty() && option.letter == name)) return option;
    names.push_back(option.name);
  }
  const std::string nearest = find_nearest_name(name, names);
  throw InputError("hydroscope " + syntax.name + ": unknown option '" + name + "'" +
                   (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") + " (see hydroscope " +
                   syntax.name + " --help)");
}

std::string join(const std::vector<std::string>& words) {
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : " ") + word;
  return joined;
}

void check_operands(const CommandSyntax& syntax, const Arguments& arguments) {
  const size_t given = arguments.operands.size(), wanted = syntax.operands.size();
  const std::string usage = "; usage: hydroscope " + syntax.name + " " + join(syntax.operands) + " [options]";
  const std::string& instead = syntax.instead_of_operands;
  if (given < wanted && (instead.empty() || !arguments.has(instead)))
    throw InputError("hydroscope " + syntax.name + ": " + syntax.operands[given] + " is missing" + usage);
  if (given > wanted)
    throw InputError("hydroscope " + syntax.name + ": '" + arguments.operands[wanted] + "' is too much" +
                     usage);
}

template <class Number>
Number parse_in_range(const std::string& option, const std::string& text, Number low, Number high,
                      const char* what) {
  Number number{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_number = error == std::errc() && stop == text.data() + text.size();
  if (!is_number || number < low || number > high) {
    throw InputError(option + " " + text + ": " + what + " from " + format_exact(low) + " to " +
                     format_exact(high) + " expected");
  }
  return number;
}

}  // namespace

std::string Arguments::get(const std::string& option, const std::string& standard) const {
  const auto found = values.find(option);
  return found == values.end() ? standard : found->second.back();
}

const std::vector<std::string>& Arguments::get_all(const std::string& option) const {
  static const std::vector<std::string> none;
  const auto found = values.find(option);
  return found == values.end() ? none : found->second;
}

Arguments parse_arguments(const CommandSyntax& syntax, const std::vector<std::string>& words) {
  Arguments arguments;
  bool options_end = false;
  for (size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (options_end || word.size() < 2 || word[0] != '-') {
      arguments.operands.push_back(word);
      continue;
    }
    if (word == "--") {
      options_end = true;
      continue;
    }
    const size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
    const Option& option = find_option(syntax, word.substr(0, equals));
    std::string value;
    if (option.value.empty()) {
      if (equals != std::string::npos) throw InputError(option.name + " takes no value");
    } else if (equals != std::string::npos) {
      value = word.substr(equals + 1);
    } else {
      if (i + 1 == words.size()) throw InputError(word + ": " + option.value + " is missing");
      value = words[++i];
    }
    auto& values = arguments.values[option.name];
    if (!values.empty() && !option.may_repeat && !option.value.empty())
      throw InputError(option.name + " is given twice");
    values.push_back(value);
  }
  if (!arguments.has(kHelp.name)) check_operands(syntax, arguments);
  return arguments;
}

int parse_whole_number(const std::string& option, const std::string& text, int low, int high) {
  return parse_in_range(option, text, low, high, "a whole number");
}

double parse_number(const std::string& option, const std::string& text, double low, double high) {
  return parse_in_range(option, text, low, high, "a number");
}

const CommandSyntax* find_command(const std::string& name) {
  const auto& all = command_syntaxes();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const CommandSyntax& c) { return c.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::string make_help() {
  std::string help =
      "Hydroscope computes how a tube is blown into a die by inner pressure, and draws it.\n\n"
      "usage: hydroscope COMMAND ...\n\ncommands:\n";
  for (const CommandSyntax& command : command_syntaxes()) {
    const std::string usage = command.name + " " + join(command.operands);
    help +=
        "  " + usage + std::string(usage.size() < 20 ? 20 - usage.size() : 1, ' ') + command.summary + "\n";
  }
  help +=
      "\n  hydroscope COMMAND --help tells more of a command; hydroscope --version names the version.\n"
      "\nfirst steps:\n"
      "  hydroscope run scenes/square-bulge.toml -o results/first\n"
      "  hydroscope render results/first --views thickness\n"
      "\nexit codes: 0 done, 1 a check found differences, 2 bad input, 3 ended early by physics (pressure "
      "maximum,\n"
      "bursting, buckling), 4 ended early numerically, 5 disk or renderer failed, 130 interrupted.\n";
  return help;
}

std::string make_command_help(const CommandSyntax& syntax) {
  std::string help = syntax.summary + "\n\nusage: hydroscope " + syntax.name + " " + join(syntax.operands);
  help += syntax.options.empty() ? "\n" : " [options]\n\noptions:\n";
  for (const Option& option : syntax.options) {
    std::string left = "  " + (option.letter.empty() ? "    " : option.letter + ", ") + option.name;
    if (!option.value.empty()) left += " " + option.value;
    help += left + (left.size() < 28 ? std::string(28 - left.size(), ' ') : "\n" + std::string(28, ' '));
    help += option.doc + (option.may_repeat ? " May be repeated." : "") + "\n";
  }
  if (!syntax.details.empty()) help += "\n" + syntax.details;
  return help;
}

}  // namespace hydroscope
