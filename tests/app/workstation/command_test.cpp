// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "solver/base/error.h"

namespace hydroscope::test {
namespace {

using testing::HasSubstr;

std::string find_fault(const std::string& text) {
  try {
    parse_command(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no fault";
}

TEST(Command, TextsComeBackAsTheyWere) {
  for (const char* text : {"run", "pause", "step", "step 12", "until pressure 12.5", "until pressure -3",
                           "until time 0.1", "until touch", "until slip", "until detachment", "until yield",
                           "until thinning 0.2", "until node 17", "set tool.die.friction 0.2",
                           "set load.pressure_MPa [[0, 0], [1, 20]]", "back 0", "back 1234", "stop"})
    EXPECT_EQ(to_text(parse_command(text)), text);
}

TEST(Command, EveryFormOfTheHelpIsKnown) {
  for (const CommandHelp& item : steering_help()) {
    std::string text = item.form;
    for (const auto& [name, value] : std::vector<std::pair<std::string, std::string>>{{"[N]", "3"},
                                                                                      {"KEY VALUE", "a.b 1"},
                                                                                      {"INCREMENT", "4"},
                                                                                      {" P", " 1"},
                                                                                      {" T", " 1"},
                                                                                      {" X", " 0.5"},
                                                                                      {" N", " 1"}}) {
      const std::size_t at = text.find(name);
      if (at != std::string::npos) text.replace(at, name.size(), value);
    }
    EXPECT_EQ(find_fault(text), "no fault") << text;
  }
}

TEST(Command, NumbersKeepTheirBits) {
  const double third = 1.0 / 3.0;
  Command command;
  command.kind = Command::Kind::kUntil;
  command.halt = {Halt::Kind::kTime, third, -1};
  EXPECT_EQ(parse_command(to_text(command)).halt.value, third);
}

TEST(Command, BlanksAndEqualSignsDoNotMatter) {
  EXPECT_EQ(to_text(parse_command("  step   3 ")), "step 3");
  EXPECT_EQ(to_text(parse_command("set tool.die.friction=0.1")), "set tool.die.friction 0.1");
  EXPECT_EQ(to_text(parse_command("set tool.die.friction = 0.1")), "set tool.die.friction 0.1");
  EXPECT_EQ(to_text(parse_command("set stop.quantity  \"a  b\" ")), "set stop.quantity \"a  b\"");
}

TEST(Command, FaultsNameTheWordAndWhatIsAllowed) {
  EXPECT_THAT(find_fault("unti touch"), HasSubstr("'unti' is no command; did you mean 'until'?"));
  EXPECT_THAT(find_fault("xyzzy"), HasSubstr("there are: run, pause, step, until, set, back, stop"));
  EXPECT_THAT(find_fault(""), HasSubstr("lacks a command"));
  EXPECT_THAT(find_fault("until"), HasSubstr("'until' lacks what to halt at (pressure P"));
  EXPECT_THAT(find_fault("until touhc"), HasSubstr("did you mean 'touch'?"));
  EXPECT_THAT(find_fault("until pressure"), HasSubstr("'until pressure' lacks a pressure in MPa"));
  EXPECT_THAT(find_fault("until pressure 3MPa"), HasSubstr("'3MPa' is no pressure in MPa"));
  EXPECT_THAT(find_fault("until time inf"), HasSubstr("not a finite number"));
  EXPECT_THAT(find_fault("until thinning 20"), HasSubstr("between 0 and 1"));
  EXPECT_THAT(find_fault("until node -1"), HasSubstr("out of range; allowed: from 0"));
  EXPECT_THAT(find_fault("until touch now"), HasSubstr("'until touch' is complete; 'now' is too much"));
  EXPECT_THAT(find_fault("step 0"), HasSubstr("out of range; allowed: from 1"));
  EXPECT_THAT(find_fault("step 1.5"), HasSubstr("'1.5' is no number of increments"));
  EXPECT_THAT(find_fault("back"), HasSubstr("'back' lacks the increment of a kept state"));
  EXPECT_THAT(find_fault("set tool.die.friction"), HasSubstr("lacks a value"));
  EXPECT_THAT(find_fault("set"), HasSubstr("lacks a key and a value"));
  EXPECT_THAT(find_fault("run fast"), HasSubstr("'fast' is too much"));
}

}  // namespace
}  // namespace hydroscope::test
