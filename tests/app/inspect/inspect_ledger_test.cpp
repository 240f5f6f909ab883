// SPDX-License-Identifier: GPL-3.0-or-later
// Episodes, figures, verdicts, patches, filters and reports, on a strip made by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "app/inspect/figure_text.h"
#include "app/inspect/ledger_record.h"
#include "app/inspect/ledger_report.h"
#include "tests/app/inspect/small_strip.h"

namespace hydroscope::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string touch_and_let_go(int node, int increment, const std::string& rest = "die,tension,0.5,0,0.01") {
  return make_event_line(increment, "detach", node, rest);
}

/// Touches at increment 1, so that every node may let go later.
std::string touches(const std::vector<int>& nodes) {
  std::string lines;
  for (const int node : nodes) lines += make_event_line(1, "touch", node, "die,gap closed,0,0.5,0");
  return lines;
}

ContactEvent make_release(const char* cause = "tension") {
  ContactEvent event;
  event.kind = EventKind::kDetach;
  event.increment = 10;
  event.cause = cause;
  event.gap = 0.001;
  return event;
}

ReleaseFigures make_figures(double gap, double force_share, int toggles = 1) {
  ReleaseFigures f;
  f.gap_reached = gap;
  f.force_share = force_share;
  f.toggles = toggles;
  return f;
}

VerdictBounds make_bounds() {
  VerdictBounds bounds;
  bounds.opening = 0.002;
  return bounds;
}

TEST(InspectLedger, EpisodesOfANode) {
  const ContactLog log = make_log(make_event_line(2, "touch", 3) + make_event_line(4, "slip", 3) +
                                  make_event_line(5, "stick", 3) + make_event_line(9, "detach", 3) +
                                  make_event_line(12, "retouch", 3) + make_event_line(15, "detach", 3));
  const auto episodes = make_episodes(log);
  ASSERT_EQ(episodes.size(), 2U);
  EXPECT_EQ(episodes[0].touched, 0U);
  EXPECT_THAT(episodes[0].changes, ElementsAre(1U, 2U));
  EXPECT_EQ(episodes[0].let_go, 3U);
  EXPECT_EQ(episodes[0].back, 4U);
  EXPECT_EQ(episodes[1].touched, 4U);
  EXPECT_EQ(episodes[1].let_go, 5U);
  EXPECT_FALSE(episodes[1].back);
}

TEST(InspectLedger, ANodeMayTouchTwoToolsAtOnce) {
  const ContactLog log =
      make_log(make_event_line(2, "touch", 3) + make_event_line(3, "touch", 3, "punch,gap closed,0,1,0") +
               make_event_line(5, "detach", 3));
  const auto episodes = make_episodes(log);
  ASSERT_EQ(episodes.size(), 2U);
  EXPECT_TRUE(episodes[0].let_go);
  EXPECT_FALSE(episodes[1].let_go);
}

TEST(InspectLedger, TogglesWithinAWindowOfFiveIncrements) {
  EXPECT_EQ(count_toggles({10, 14}, 10), 2);
  EXPECT_EQ(count_toggles({10, 15}, 10), 1);
  EXPECT_EQ(count_toggles({8, 10, 12, 14}, 10), 3);  // 8 to 12, or 10 to 14
  EXPECT_EQ(count_toggles({1, 2, 3, 30}, 30), 1);    // only windows that hold it
}

TEST(InspectLedger, FiguresOfALettingGo) {
  Snapshot before = make_strip_state(7), at = make_strip_state(9), later = make_strip_state(12);
  before.contact_pressure[3] = 4.0;
  at.gap[3] = 0.01;
  later.gap[3] = 0.07;
  const Ledger ledger =
      make_small_ledger(touches({3}) + make_event_line(9, "detach", 3, "die,tension,-0.5,0,0.01") +
                            make_event_line(14, "retouch", 3),
                        {before, at, later, make_strip_state(14)});
  const ReleaseFigures& f = ledger.episodes.at(0).figures;
  EXPECT_EQ(f.pressure_before, 10.0);
  EXPECT_EQ(f.pressure, 9.0);
  EXPECT_EQ(f.area, 2.0);
  EXPECT_EQ(f.fluid_share, 20.0);
  EXPECT_EQ(f.force_share, -0.025);
  EXPECT_EQ(f.contact_pressure_before, 4.0);
  EXPECT_EQ(f.state_before, 7);
  EXPECT_EQ(f.contact_pressure_after, 0.0);
  EXPECT_EQ(f.state_after, 9);
  EXPECT_EQ(f.gap_reached, 0.07);            // the state of increment 14, 1 mm, is after coming back
  EXPECT_NEAR(f.opening_speed, 0.1, 1e-12);  // 0.01 mm in 0.1 s; round-off of the times
  EXPECT_NEAR(f.gap_growth, 0.06 / 0.3, 1e-12);
  EXPECT_EQ(f.toggles, 1);  // 9 and 14 are six increments, end to end
}

TEST(InspectLedger, FiguresThatNobodyKnowsAreNotMadeUp) {
  const Ledger ledger =
      make_small_ledger(touches({3}) + make_event_line(9, "detach", 3) + make_event_line(10, "retouch", 3),
                        {make_strip_state(9 + 3)});
  const ReleaseFigures& f = ledger.episodes.at(0).figures;
  EXPECT_TRUE(std::isnan(f.area) && std::isnan(f.force_share));
  EXPECT_TRUE(std::isnan(f.contact_pressure_before) && std::isnan(f.contact_pressure_after));
  EXPECT_EQ(f.state_after, -1);
  EXPECT_EQ(f.gap_reached, 0.01);
}

TEST(InspectLedger, LeavingTheReachOfAllToolsIsOpen) {
  Snapshot far = make_strip_state(12);
  far.gap[3] = kUnknown;
  const Ledger ledger = make_small_ledger(
      touches({3}) + make_event_line(9, "detach", 3, "die,tension,0.5,0,0.0001"), {make_strip_state(0), far});
  EXPECT_TRUE(std::isinf(ledger.episodes.at(0).figures.gap_reached));
  EXPECT_EQ(ledger.episodes[0].verdict, Verdict::kPhysical);
}

TEST(InspectLedger, Verdicts) {
  const auto verdict = [](const ContactEvent& event, std::optional<int> back, const ReleaseFigures& f) {
    return judge_release(event, back, f, make_bounds()).verdict;
  };
  // Opened or not: the bound itself is not open.
  EXPECT_EQ(verdict(make_release(), {}, make_figures(0.0021, 0.05)), Verdict::kPhysical);
  EXPECT_EQ(verdict(make_release(), {}, make_figures(0.002, 0.05)), Verdict::kNoise);
  EXPECT_EQ(verdict(make_release(), 11, make_figures(0.0021, 0.05, 2)), Verdict::kPhysical);
  // Pulled for sure: physical unless taken back within the window.
  EXPECT_EQ(verdict(make_release(), {}, make_figures(0.001, -0.011)), Verdict::kPhysical);
  EXPECT_EQ(verdict(make_release(), {}, make_figures(0.001, -0.009)), Verdict::kNoise);
  EXPECT_EQ(verdict(make_release(), 15, make_figures(0.001, -0.5, 2)), Verdict::kNoise);
  EXPECT_EQ(verdict(make_release(), 16, make_figures(0.001, -0.5, 1)), Verdict::kPhysical);
  EXPECT_EQ(verdict(make_release(), {}, make_figures(0.001, kUnknown)), Verdict::kNoise);
  // Or the patch was: the rim of what lifts off opens little.
  ReleaseFigures rim = make_figures(0.001, 0.05);
  rim.patch_force_share = -0.02;
  EXPECT_EQ(verdict(make_release(), {}, rim), Verdict::kPhysical);
  EXPECT_EQ(verdict(make_release(), 12, rim), Verdict::kNoise);
  // To and fro is chatter however far it opens.
  EXPECT_EQ(verdict(make_release(), 11, make_figures(1.0, -0.5, 3)), Verdict::kChatter);
  EXPECT_EQ(verdict(make_release("edge"), 11, make_figures(1.0, 0.1, 3)), Verdict::kChatter);
  // Over the edge or with the tool: whatever the gap says.
  EXPECT_EQ(verdict(make_release("edge"), {}, make_figures(0.0, 0.5)), Verdict::kPhysical);
  EXPECT_EQ(verdict(make_release("tool taken away"), {}, make_figures(0.0, 0.5)), Verdict::kPhysical);
}

TEST(InspectLedger, AReasonHasItsFigures) {
  ReleaseFigures f = make_figures(0.05, 0.06);
  f.pressure_before = 18.0;
  f.pressure = 16.5;
  EXPECT_EQ(
      judge_release(make_release(), {}, f, make_bounds()).reason,
      "opened by 0.05 mm, above 0.002 mm; it stayed away; force before: 6 % of the fluid's share (facet "
      "noise: not known); unloading: the fluid went from 18 to 16.5 MPa");
  EXPECT_THAT(judge_release(make_release(), 11, make_figures(1e-5, 0.1, 3), make_bounds()).reason,
              HasSubstr("3 times let go or back within 5 increments"));
}

TEST(InspectLedger, PatchesAreNeighboursInTheMeshAndInTime) {
  const std::string lines = touches({0, 1, 2, 3, 5}) + touch_and_let_go(0, 9) + touch_and_let_go(1, 10) +
                            touch_and_let_go(5, 10) + touch_and_let_go(2, 14) + touch_and_let_go(3, 19);
  const Ledger ledger = make_small_ledger(lines, {make_strip_state(0)});
  ASSERT_EQ(ledger.patches.size(), 3U);  // 0-1-2 as a front; 5 is far; 3 is five increments late
  EXPECT_EQ(ledger.patches[0].nodes, 3);
  EXPECT_EQ(ledger.patches[0].first_increment, 9);
  EXPECT_EQ(ledger.patches[0].last_increment, 14);
  EXPECT_EQ(ledger.patches[0].area, 5.0);
  EXPECT_EQ(ledger.patches[0].force_before, 1.5);
  EXPECT_EQ(ledger.patches[0].fluid_share, 10.0 * 1.0 + 9.0 * 2.0 + 9.0 * 2.0);
  EXPECT_NEAR((ledger.patches[0].centre - Vec3(2, 0, 0)).norm(), 0.0, 1e-12);  // round-off of thirds
  EXPECT_EQ(ledger.episodes[ledger.patches[0].episodes[0]].figures.patch_force_share, 1.5 / 46.0);
  EXPECT_EQ(ledger.patches[1].nodes, 1);
  EXPECT_EQ(ledger.episodes[ledger.patches[1].episodes[0]].node, 5);
  EXPECT_EQ(ledger.episodes[ledger.patches[2].episodes[0]].node, 3);
}

TEST(InspectLedger, NeighboursAcrossADiagonalAndToolsApart) {
  const Ledger diagonal =
      make_small_ledger(touches({0, 7}) + touch_and_let_go(0, 9) + touch_and_let_go(7, 9), {});
  EXPECT_EQ(diagonal.patches.size(), 1U);
  const Ledger apart =
      make_small_ledger(touches({0}) + make_event_line(1, "touch", 1, "punch,gap closed,0,1,0") +
                            touch_and_let_go(0, 9) + touch_and_let_go(1, 9, "punch,tension,1,0,0.01"),
                        {});
  EXPECT_EQ(apart.patches.size(), 2U);
}

TEST(InspectLedger, OfEqualNumbersAPatchHasTheMoreDoubtfulVerdict) {
  // Both press before; node 1 opens, node 2 does not.
  const std::string lines = touches({1, 2}) + make_event_line(9, "detach", 1, "die,tension,1,0,0.01") +
                            make_event_line(9, "detach", 2, "die,tension,1,0,0.001") +
                            make_event_line(11, "retouch", 1) + make_event_line(11, "retouch", 2);
  const Ledger ledger = make_small_ledger(lines, {make_strip_state(0)});
  ASSERT_EQ(ledger.patches.size(), 1U);
  EXPECT_THAT(ledger.patches[0].verdicts, ElementsAre(1, 1, 0));
  EXPECT_EQ(ledger.patches[0].verdict, Verdict::kNoise);
}

/// Node 1 opens, node 3 is taken back, node 5 goes to and fro, node 8 stays.
Ledger make_mixed_ledger() {
  Snapshot later = make_strip_state(28);
  later.gap[1] = 0.5;
  return make_small_ledger(
      touches({1, 3, 5, 8}) + make_event_line(9, "detach", 1, "die,tension,2,0,0.01") +
          make_event_line(12, "detach", 3, "die,tension,-1,0,0.001") + make_event_line(13, "retouch", 3) +
          make_event_line(20, "detach", 5, "die,edge,0.5,0,0.001") + make_event_line(21, "retouch", 5) +
          make_event_line(22, "detach", 5, "die,edge,0.5,0,0.001"),
      {make_strip_state(0), later});
}

std::vector<int> list_nodes(const Ledger& ledger, const LedgerFilter& filter) {
  std::vector<int> nodes;
  for (const std::size_t i : select_episodes(ledger, filter)) nodes.push_back(ledger.episodes[i].node);
  return nodes;
}

TEST(InspectLedger, FiltersAndSorts) {
  const Ledger ledger = make_mixed_ledger();
  LedgerFilter f;
  EXPECT_THAT(list_nodes(ledger, f), ElementsAre(1, 3, 5, 5));
  f.sort = "force";
  EXPECT_THAT(list_nodes(ledger, f), ElementsAre(3, 5, 5, 1));
  f.sort = "gap";
  EXPECT_EQ(list_nodes(ledger, f).front(), 5);  // free again at 28: the state has 1 mm
  f.sort = "toggles";
  EXPECT_THAT(list_nodes(ledger, f), ElementsAre(5, 5, 3, 1));
  f.sort = "verdict";
  EXPECT_THAT(list_nodes(ledger, f), ElementsAre(5, 5, 3, 1));
  f = {};
  f.verdicts = {Verdict::kNoise, Verdict::kPhysical};
  EXPECT_THAT(list_nodes(ledger, f), ElementsAre(1, 3));
  f = {};
  f.kinds = {EventKind::kRetouch};
  EXPECT_THAT(list_nodes(ledger, f), ElementsAre(3, 5));  // the episodes that began with it
  f = {};
  f.kinds = {EventKind::kTouch};
  f.nodes = {{5, 8}};
  EXPECT_THAT(list_nodes(ledger, f), testing::UnorderedElementsAre(5, 8));
  f = {};
  f.from = 1.2;
  f.to = 2.0;
  EXPECT_THAT(list_nodes(ledger, f), ElementsAre(3, 5));
  f = {};
  f.region = {{5.0, 7.0, -1.0, 1.0, -1.0, 1.0}};
  EXPECT_THAT(list_nodes(ledger, f), ElementsAre(3));
  f = {};
  f.tool = 1;
  EXPECT_THAT(list_nodes(ledger, f), IsEmpty());
}

TEST(InspectLedger, TextStartsWithTheSummary) {
  const Ledger ledger = make_mixed_ledger();
  const std::string text = make_ledger_text(ledger, select_episodes(ledger, {}), "run", 2);
  EXPECT_THAT(text,
              HasSubstr("run: Strip\n4 detachments in 3 patches: 1 physical, 1 noise, 2 chatter; 2 came "
                        "back\ncauses: tension 2, edge 2\n"));
  EXPECT_THAT(text, HasSubstr("release @3"));  // what limited increment 9
  EXPECT_THAT(text, HasSubstr("... and 1 more (--limit 0 shows all)"));
  EXPECT_THAT(make_ledger_text(ledger, {}, "run", 2), HasSubstr("nothing let go"));
}

TEST(InspectLedger, JsonAndCsvSayTheSame) {
  const Ledger ledger = make_mixed_ledger();
  const auto chosen = select_episodes(ledger, {});
  const Json json = Json::parse(make_ledger_json(ledger, chosen));
  EXPECT_EQ(json.at("summary").at("chatter").number(), 2);
  ASSERT_EQ(json.at("episodes").items().size(), 4U);
  EXPECT_EQ(json.at("patches").items().size(), 3U);  // node 5 twice, two increments apart
  const Json& first = json.at("episodes").items().front();
  EXPECT_EQ(first.at("limited_by").text(), "release");
  EXPECT_EQ(first.at("limited_at").number(), 3);
  EXPECT_TRUE(first.at("back_increment").is_null());
  const CsvTable csv = CsvTable::parse(make_ledger_csv(ledger, chosen), "ledger.csv");
  ASSERT_EQ(csv.rows(), 4U);
  for (const auto& [key, value] : first.members()) {
    if (value.is_number()) {
      EXPECT_EQ(csv.number(0, csv.column(key)), value.number()) << key;
    }
    if (value.is_null()) {
      EXPECT_EQ(csv.text(0, csv.column(key)), "") << key;
    }
  }
  EXPECT_EQ(csv.text(0, csv.column("reason")), first.at("reason").text());
}

TEST(InspectLedger, CellsWithCommasAndQuotesReadBack) {
  const std::string text =
      make_csv({{"a", {}}, {"b", {}}}, {{{"a", "x, \"y\""}, {"b", 1.5}}, {{"a", "z"}, {"b", {}}}});
  EXPECT_EQ(text, "a,b\n\"x, \"\"y\"\"\",1.5\nz,\n");
  EXPECT_EQ(CsvTable::parse(text, "a.csv").text(0, 0), "x, \"y\"");
}

TEST(InspectLedger, ReleasesTakenBackAtOnceAreCountedAndSpeakForNoise) {
  const std::string back = make_event_line(8, "taken-back", 3, "die,tension,2,-1,0");
  const std::string pulled = make_event_line(9, "detach", 3, "die,tension,-1,-1,0.001");
  const Ledger sure = make_small_ledger(touches({3}) + pulled, {make_strip_state(0)}, 9);
  EXPECT_EQ(sure.episodes.at(0).verdict, Verdict::kPhysical);  // pulled, and the run ends
  const Ledger ledger = make_small_ledger(touches({3}) + back + pulled, {make_strip_state(0)}, 9);
  ASSERT_EQ(ledger.episodes.size(), 1U);  // no detachment of its own
  EXPECT_EQ(ledger.episodes[0].figures.taken_back, 1);
  EXPECT_EQ(ledger.episodes[0].verdict, Verdict::kNoise);
  EXPECT_THAT(ledger.episodes[0].reason, HasSubstr("taken back at once 1 time"));
  const Ledger early =
      make_small_ledger(touches({3}) + make_event_line(4, "taken-back", 3, "die,tension,2,-1,0") + pulled,
                        {make_strip_state(0)}, 9);
  EXPECT_EQ(early.episodes[0].verdict, Verdict::kPhysical) << "five increments before is long ago";
  const auto chosen = select_episodes(ledger, {});
  EXPECT_THAT(make_ledger_text(ledger, chosen, "run", 9), HasSubstr("1 release taken back at once (noise)"));
  EXPECT_EQ(Json::parse(make_ledger_json(ledger, chosen)).at("summary").at("taken_back").number(), 1);
  EXPECT_THAT(make_life_text(ledger, 3, "run"), HasSubstr("increment 8: noise, the fluid pushed it back"));
  LedgerFilter filter;
  filter.kinds = {EventKind::kTakenBack};
  EXPECT_THAT(list_nodes(ledger, filter), ElementsAre(3));
}

TEST(InspectLedger, WhatItsToolAndTheOthersDid) {
  Snapshot before = make_strip_state(8);
  before.tool_normal[3] = Vec3::UnitY();
  SheetHistory sheet;
  sheet.states = {make_sheet_state(before)};
  sheet.neighbours = std::vector<std::vector<int>>(12);
  const std::string lines = touches({3, 4}) + make_event_line(9, "detach", 3, "die,tension,1,0,0.01");
  const auto find = [&](double die, double punch) {
    const std::vector<ToolMotion> motions = {{"die", {{0.8, 0, 0, 0}, {1.0, 5, die, 0}}},
                                             {"punch", {{0.8, 0, 0, 0}, {1.0, punch, 0, 0}}}};
    return make_ledger(make_log(lines, 10), sheet, {}, {}, motions).episodes.at(0).figures;
  };
  // Half of the way lies in increment 9, from 0.8 to 0.9 s; what goes along the face does not count.
  EXPECT_NEAR(find(-4.0, 0.0).tool_retreat, 2.0, 1e-9);
  EXPECT_EQ(find_drive(find(-4.0, 0.0)), "tool withdrawn");
  EXPECT_EQ(find_drive(find(0.0, 3.0)), "unloading");  // 10 to 9 MPa
  ReleaseFigures held = find(4.0, 3.0);
  EXPECT_EQ(held.moving_tool, "punch");
  EXPECT_NEAR(held.moving_way, 1.5, 1e-9);
  held.pressure = held.pressure_before;
  EXPECT_EQ(find_drive(held), "tool comes on");
  held.tool_retreat = 0.0;
  EXPECT_EQ(find_drive(held), "tool moves");
  held.moving_tool.clear();
  EXPECT_EQ(find_drive(held), "steady");
}

TEST(InspectLedger, ASignRuleThatLetsGoWhatIsPressedIsNoise) {
  ContactEvent event = make_release("sign rule");
  event.force_before = 3.0;
  EXPECT_EQ(judge_release(event, 40, make_figures(0.01, 0.5), make_bounds()).verdict, Verdict::kNoise);
  EXPECT_EQ(judge_release(event, {}, make_figures(0.01, 0.5), make_bounds()).verdict, Verdict::kPhysical);
  event.force_before = -3.0;
  EXPECT_EQ(judge_release(event, 40, make_figures(0.01, -0.5), make_bounds()).verdict, Verdict::kPhysical);
}

TEST(InspectLedger, OpeningLessThanFacetsStandOffIsNoiseUnlessSomethingGoesBack) {
  ReleaseFigures f = make_figures(0.05, -0.5);
  f.facet_sagitta = 0.06;
  EXPECT_EQ(judge_release(make_release(), {}, f, make_bounds()).verdict, Verdict::kNoise);
  f.tool_retreat = 0.1;
  EXPECT_EQ(judge_release(make_release(), {}, f, make_bounds()).verdict, Verdict::kPhysical);
  f.tool_retreat = 0.0;
  f.gap_reached = 0.07;
  EXPECT_EQ(judge_release(make_release(), {}, f, make_bounds()).verdict, Verdict::kPhysical);
}

TEST(InspectLedger, LifeOfANodeHasEventsAndStates) {
  const Ledger ledger = make_mixed_ledger();
  std::vector<std::string> what;
  const Json json = Json::parse(make_life_json(ledger, 5));
  for (const Json& line : json.at("life").items()) what.push_back(line.at("what").text());
  EXPECT_THAT(what, ElementsAre("state", "touch", "detach", "retouch", "detach", "state"));
  EXPECT_EQ(json.at("episodes").items().size(), 2U);
  EXPECT_THAT(make_life_text(ledger, 5, "run"), HasSubstr("increment 22: chatter, 3 times"));
  EXPECT_THAT(make_life_text(ledger, 0, "run"), HasSubstr("it never let go"));
  EXPECT_EQ(CsvTable::parse(make_life_csv(ledger, 5), "life.csv").rows(), 6U);
}

TEST(InspectLedger, ColumnsAreAligned) {
  EXPECT_EQ(format_columns({{"a", "word"}, {"10", "x"}, {"-", "yy"}}), " a  word\n10  x\n -  yy\n");
  EXPECT_EQ(format_figure(kUnknown), "-");
  EXPECT_EQ(format_figure(0.00056099), "0.000561");
}

}  // namespace
}  // namespace hydroscope::test
