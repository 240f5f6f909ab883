// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/frame_options.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Arguments parse_run(const std::vector<std::string>& words) {
  return parse_arguments(*find_command("run"), words);
}

std::string error_of(const std::vector<std::string>& words) {
  try {
    make_overrides(parse_run(words));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(CommandLine, OperandsAndOptionsInAnyOrder) {
  const Arguments a = parse_run({"--force", "a.toml", "-o", "out", "--set", "x=1", "--set=y=2"});
  EXPECT_THAT(a.operands, ElementsAre("a.toml"));
  EXPECT_TRUE(a.has("--force"));
  EXPECT_EQ(a.get("--output"), "out");
  EXPECT_THAT(a.get_all("--set"), ElementsAre("x=1", "y=2"));
  EXPECT_EQ(a.get("--threads", "2"), "2");
  EXPECT_THAT(parse_run({"--", "-odd.toml"}).operands, ElementsAre("-odd.toml"));
}

TEST(CommandLine, ErrorsAreClear) {
  EXPECT_EQ(error_of({"a.toml", "--vews", "x"}),
            "hydroscope run: unknown option '--vews'; did you mean '--views'? (see hydroscope run --help)");
  EXPECT_EQ(error_of({}), "hydroscope run: SCENE is missing; usage: hydroscope run SCENE [options]");
  EXPECT_EQ(error_of({"a", "b"}), "hydroscope run: 'b' is too much; usage: hydroscope run SCENE [options]");
  EXPECT_EQ(error_of({"a", "-o"}), "-o: DIR is missing");
  EXPECT_EQ(error_of({"a", "--force=yes"}), "--force takes no value");
  EXPECT_EQ(error_of({"a", "-o", "x", "-o", "y"}), "--output is given twice");
  EXPECT_EQ(error_of({"a", "--size", "100"}), "--size 100: write it as WIDTHxHEIGHT, e.g. --size 1280x720");
  EXPECT_EQ(error_of({"a", "--size", "100x9"}), "--size 9: a whole number from 64 to 8192 expected");
}

TEST(CommandLine, FrameOptionsBecomeSceneKeys) {
  const auto overrides =
      make_overrides(parse_run({"a.toml", "--views", "slip,gap", "--frames", "9", "--size", "640x480",
                                "--camera", "look-at:12", "--theme", "dark", "--set", "frames.zoom=2"}));
  std::string text;
  for (const SceneOverride& item : overrides) text += item.key + "=" + item.value + ";";
  EXPECT_EQ(
      text,
      "frames.views=[\"slip\", \"gap\"];frames.pick=\"number\";frames.number=9;frames.size_px=[640, 480];"
      "frames.theme=\"dark\";frames.camera=\"look-at\";frames.look_at_node=12;frames.zoom=2;");
  EXPECT_EQ(overrides[0].shown, "--views slip,gap");
}

TEST(CommandLine, HelpNamesEveryCommandAndOption) {
  for (const CommandSyntax& command : command_syntaxes()) {
    EXPECT_THAT(make_help(), HasSubstr("\n  " + command.name + " "));
    const std::string help = make_command_help(command);
    for (const Option& option : command.options) EXPECT_THAT(help, HasSubstr(option.name));
    EXPECT_TRUE(parse_arguments(command, {"--help"}).has("--help"));
  }
  std::istringstream lines(make_help() + make_command_help(*find_command("run")));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 115U) << line;
}

TEST(CommandLine, CompletionIsValidShell) {
  const TemporaryFolder folder;
  const auto script = folder.path() / "c.bash";
  write_whole_file(
      script,
      make_completion("bash") +
          "COMP_WORDS=(hydroscope run --fo); COMP_CWORD=2; _hydroscope\n[ \"$COMPREPLY\" = --force ] || exit "
          "3\n"
          "COMP_WORDS=(hydroscope ren); COMP_CWORD=1; _hydroscope\n[ \"$COMPREPLY\" = render ] || exit 4\n"
          "COMP_WORDS=(hydroscope render --views pla); COMP_CWORD=3; _hydroscope\n"
          "[ \"$COMPREPLY\" = plastic-strain ] || exit 5\n");
  EXPECT_EQ(std::system(("bash " + script.string()).c_str()), 0);
  EXPECT_THAT(make_completion("zsh"), HasSubstr("#compdef hydroscope"));
  EXPECT_THROW(make_completion("fish"), InputError);
}

}  // namespace
}  // namespace hydroscope::test
