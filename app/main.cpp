// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>
#include <new>

#include "app/commands.h"
#include "solver/base/error.h"
#include "solver/scene/key_suggestion.h"
#include "solver/scene/scene_reference.h"

namespace hydroscope {
namespace {

ExitCode print(const std::string& text) {
  const bool done = std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  return done ? ExitCode::kDone : ExitCode::kEnvironment;
}

ExitCode run_command(const CommandSyntax& command, const std::vector<std::string>& words) {
  const Arguments arguments = parse_arguments(command, words);
  if (arguments.has("--help")) return print(make_command_help(command));
  if (command.name == "run")
    return arguments.has("--replay") ? replay_journal(arguments) : run_scene(arguments);
  if (command.name == "console") return open_console(arguments);
  if (command.name == "render") return render_results(arguments);
  if (command.name == "check") return check_results(arguments);
  if (command.name == "serve") return serve(arguments);
  if (command.name == "inspect") return inspect_contact(arguments);
  if (command.name == "chart") return chart_study(arguments);
  if (command.name == "tool") return inspect_tool_mesh(arguments);
  if (command.name == "reference") return print(make_scene_reference());
  return print(make_completion(arguments.operands.front()));
}

ExitCode run_program(const std::vector<std::string>& words) {
  if (words.empty()) {
    std::fputs(make_help().c_str(), stderr);
    return ExitCode::kBadInput;
  }
  const std::string& first = words.front();
  if (first == "--version" || first == "-V")
    return print("hydroscope " HYDROSCOPE_VERSION "\nGPL-3.0-or-later; comes without any warranty\n");
  const CommandSyntax* asked = words.size() > 1 ? find_command(words[1]) : nullptr;
  if (first == "--help" || first == "-h" || first == "help") {
    return print(asked != nullptr ? make_command_help(*asked) : make_help());
  }
  if (const CommandSyntax* command = find_command(first))
    return run_command(*command, {words.begin() + 1, words.end()});
  std::vector<std::string> names = {"--help", "--version"};
  for (const CommandSyntax& command : command_syntaxes()) names.push_back(command.name);
  const std::string nearest = find_nearest_name(first, names);
  throw InputError("'" + first + "' is no command" +
                   (nearest.empty() ? "" : "; did you mean '" + nearest + "'?") + " (see hydroscope --help)");
}

int guard(const std::vector<std::string>& words) {
  const auto fail = [](const char* start, const char* what, ExitCode code) {
    std::fprintf(stderr, "%s%s\n", start, what);
    return static_cast<int>(code);
  };
  try {
    return static_cast<int>(run_program(words));
  } catch (const InputError& error) {
    return fail("error: ", error.what(), ExitCode::kBadInput);
  } catch (const EnvironmentError& error) {
    return fail("error: ", error.what(), ExitCode::kEnvironment);
  } catch (const std::bad_alloc&) {
    return fail("error: ", "out of memory", ExitCode::kEnvironment);
  } catch (const std::exception& error) {
    return fail("internal error (please report it with the scene): ", error.what(), ExitCode::kInternal);
  }
}

}  // namespace
}  // namespace hydroscope

int main(int argc, char** argv) { return hydroscope::guard({argv + 1, argv + argc}); }
