// SPDX-License-Identifier: GPL-3.0-or-later
// What hydroscope inspect reads, and how it says what is wrong with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/inspect/inspect_options.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "tests/app/inspect/small_strip.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string table_error(const std::string& text) {
  return error_of([&] {
    const CsvTable table = CsvTable::parse(text, "a.csv");
    table.number(0, table.column("x"));
    table.whole_number(0, table.column("x"));
  });
}

TEST(InspectReading, TableWithQuotedCells) {
  const CsvTable table = CsvTable::parse("x,why\r\n1.5,\"a, \"\"b\"\"\nc\"\n-2,d\n", "a.csv");
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.number(0, 0), 1.5);
  EXPECT_EQ(table.text(0, 1), "a, \"b\"\nc");
  EXPECT_EQ(table.whole_number(1, 0), -2);
  EXPECT_EQ(table.line(1), 4);  // the quoted cell has a newline
}

TEST(InspectReading, DamagedTablesNameFileAndLine) {
  EXPECT_EQ(table_error(""), "a.csv:1: the head line is missing");
  EXPECT_EQ(table_error("y\n1\n"), "a.csv:1: there is no column 'x'");
  EXPECT_EQ(table_error("x,y\n1\n"), "a.csv:2: 1 cells instead of 2");
  EXPECT_EQ(table_error("x\n1"), "a.csv:2: the line is cut off");
  EXPECT_EQ(table_error("x\n\"1\n2\n"), "a.csv:2: a quoted cell does not end");
  EXPECT_EQ(table_error("x\nnan\n"), "a.csv:2: x = 'nan': a finite number expected");
  EXPECT_EQ(table_error("x\n1.0 \n"), "a.csv:2: x = '1.0 ': a finite number expected");
  EXPECT_EQ(table_error("x\n1.5\n"), "a.csv:2: x = '1.5': a whole number expected");
}

TEST(InspectReading, EventsThatCannotBe) {
  const auto error = [](const std::string& lines) {
    return error_of([&] { make_episodes(make_log(lines)); });
  };
  const std::string touch = make_event_line(3, "touch", 2);
  EXPECT_EQ(error(touch), "no error");
  EXPECT_EQ(
      error(make_event_line(3, "detatch", 2)),
      "events.csv:2: 'detatch' is no kind of event; did you mean 'detach'? (touch, stick, slip, detach, "
      "retouch, taken-back)");
  EXPECT_EQ(error(touch + "4,0.4,slip,12,0,0,0,die,x,0,0,0\n"),
            "events.csv:3: node 12: the sheet has nodes 0 to 11");
  EXPECT_EQ(error(touch + make_event_line(4, "slip", 2, "dye,x,0,0,0")),
            "events.csv:3: the run has no tool 'dye'");
  EXPECT_EQ(error(touch + make_event_line(2, "touch", 1)), "events.csv:3: increments do not rise");
  EXPECT_EQ(error(make_event_line(0, "touch", 1)), "events.csv:2: increment 0 is not in history.csv");
  EXPECT_EQ(error(touch + touch), "events.csv:3: node 2 touches without having let go before");
  const std::string detach = make_event_line(5, "detach", 2);
  EXPECT_EQ(error(touch + detach + detach),
            "events.csv:4: node 2 is free, and cannot stick, slide or let go");
}

TEST(InspectReading, EventsOfAnUnfinishedIncrementAreLeftOut) {
  const ContactLog log = make_log(make_event_line(3, "touch", 2) + make_event_line(8, "detach", 2), 7);
  EXPECT_EQ(log.events.size(), 1U);
}

TEST(InspectReading, HistoryMustRise) {
  const std::string head = make_history(2);
  const std::string twice = head + head.substr(head.rfind("2,0.2"));
  EXPECT_EQ(error_of([&] {
              make_contact_log(CsvTable::parse(make_events(""), "e"), CsvTable::parse(twice, "h.csv"), {});
            }),
            "h.csv:4: increments do not rise");
}

TEST(InspectReading, FolderOfARun) {
  const TemporaryFolder folder;
  write_small_run(folder.path(), make_event_line(3, "touch", 2) + make_event_line(9, "detach", 2),
                  {make_strip_state(0), make_strip_state(9)});
  const Ledger ledger = read_ledger({folder.path()});
  EXPECT_EQ(ledger.title, "Strip");
  ASSERT_EQ(ledger.episodes.size(), 1U);
  EXPECT_EQ(ledger.bounds.opening, 0.008);  // twice the tolerance of overrides.txt
  EXPECT_EQ(ledger.episodes[0].figures.gap_reached, 1.0);
  EXPECT_EQ(ledger.episodes[0].figures.fluid_share, 20.0);  // 10 MPa before, 2 mm^2
}

TEST(InspectReading, FoldersThatAreNone) {
  const auto error = [](const std::filesystem::path& path) { return error_of([&] { read_ledger({path}); }); };
  const TemporaryFolder folder;
  EXPECT_THAT(error(folder / "nowhere"), EndsWith("there is no such folder"));
  EXPECT_THAT(error(folder.path()), HasSubstr("no saved states here"));
  write_small_run(folder.path(), make_event_line(3, "tuch", 2), {make_strip_state(0), make_strip_state(9)});
  EXPECT_THAT(error(folder.path()), HasSubstr("events.csv:2: 'tuch' is no kind of event"));
  write_small_run(folder.path(), "", {make_strip_state(9), make_strip_state(9)});
  EXPECT_THAT(error(folder.path()), HasSubstr("00001.vtp: its increment is not above"));
  std::filesystem::remove(folder.path() / "events.csv");
  write_small_run(folder.path(), "", {make_strip_state(8), make_strip_state(9)});
  std::filesystem::remove(folder.path() / "history.csv");
  EXPECT_THAT(error(folder.path()), HasSubstr("history.csv"));
}

TEST(InspectReading, OptionsThatAreWrong) {
  const auto error = [](std::vector<std::string> words) {
    words.insert(words.begin(), "DIR");
    return error_of([&] {
      const auto options = parse_inspect_options(parse_arguments(*find_command("inspect"), words));
      make_inspect_report(make_small_ledger("", {make_strip_state(0)}), options, "run");
    });
  };
  EXPECT_EQ(error({"--sort", "gap", "--limit", "0", "--tool", "punch"}), "no error");
  EXPECT_EQ(error({"--tool", "dye"}), "--tool dye: one of die, punch expected; did you mean 'die'?");
  EXPECT_THAT(error({"--kind", "detsch"}), HasSubstr("did you mean 'detach'?"));
  EXPECT_THAT(error({"--verdict", "nois"}), HasSubstr("did you mean 'noise'?"));
  EXPECT_THAT(error({"--sort", "gapp"}), HasSubstr("did you mean 'gap'?"));
  EXPECT_THAT(error({"--region", "1,2"}), HasSubstr("X0,X1,Y0,Y1,Z0,Z1"));
  EXPECT_EQ(error({"--region", "0,1,2,1,0,0"}), "--region 0,1,2,1,0,0: 2 is above 1");
  EXPECT_EQ(error({"--node-range", "5-3"}), "--node-range 5-3: the first is above the last");
  EXPECT_EQ(error({"--from", "2", "--to", "1"}), "--from 2: is after --to");
  EXPECT_EQ(error({"--node", "12"}), "--node 12: the sheet has nodes 0 to 11");
  EXPECT_THAT(error({"--node", "1", "--sort", "gap"}), HasSubstr("leave it out"));
  EXPECT_EQ(error({"--json", "--csv"}), "--csv: not together with --json");
  EXPECT_THAT(error({"--json", "--limit", "3"}), HasSubstr("always give all"));
}

}  // namespace
}  // namespace hydroscope::test
