// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the server that need neither network nor threads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "app/server/access.h"
#include "app/server/api_json.h"
#include "app/server/contact_counts.h"
#include "app/server/node_values.h"
#include "app/server/query.h"
#include "app/server/run_files.h"
#include "app/server/view_query.h"
#include "app/server/viewers.h"
#include "solver/base/error.h"
#include "tests/app/sample_run.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;

/// What an InputError says; empty when there is none.
template <class Action>
std::string find_error(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

class Access : public testing::Test {
 protected:
  int find_status(const std::string& host, const std::string& origin = "") const {
    RequestFacts facts;
    facts.hosts = {host};
    if (!origin.empty()) facts.origins = {origin};
    const std::optional<Refusal> refusal = check_place(rules_, facts);
    return refusal ? refusal->status : 200;
  }
  AccessRules rules_{"0123abcd", 8080, {"workshop"}, false};
};

TEST_F(Access, TokensAreLongHexadecimalAndNeverTheSame) {
  std::set<std::string> tokens;
  for (int i = 0; i < 50; ++i) tokens.insert(make_token());
  EXPECT_EQ(tokens.size(), 50U);
  EXPECT_EQ(tokens.begin()->size(), 40U);
  EXPECT_EQ(tokens.begin()->find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST_F(Access, SecretsAreEqualOnlyAsAWhole) {
  EXPECT_TRUE(is_equal_secret("abc", "abc"));
  for (const char* wrong : {"", "a", "ab", "abd", "bbc", "abca", "abcabc"})
    EXPECT_FALSE(is_equal_secret(wrong, "abc")) << wrong;
  EXPECT_FALSE(is_equal_secret("", ""));
  EXPECT_FALSE(is_equal_secret("abc", ""));
}

TEST_F(Access, OnlyOwnNamesWithTheRightPortAreAnswered) {
  for (const char* host :
       {"127.0.0.1:8080", "localhost:8080", "LocalHost:8080", "[::1]:8080", "workshop:8080"})
    EXPECT_EQ(find_status(host), 200) << host;
  for (const char* host : {"127.0.0.1", "127.0.0.1:80", "localhost:80800", "evil.example:8080", "", ":8080",
                           "127.0.0.1.evil.example:8080", "localhost:8080:8080", "[::1]8080", "::1:8080",
                           "10.0.0.7:8080", "localhost:8080 "})
    EXPECT_EQ(find_status(host), 421) << host;
  rules_.any_address = true;
  EXPECT_EQ(find_status("10.0.0.7:8080"), 200);
  EXPECT_EQ(find_status("[fe80::1]:8080"), 200);
  EXPECT_EQ(find_status("evil.example:8080"), 421);
}

TEST_F(Access, TwoHostHeadersOrNoneAreMalformed) {
  RequestFacts facts;
  EXPECT_EQ(check_place(rules_, facts)->status, 400);
  facts.hosts = {"localhost:8080", "localhost:8080"};
  EXPECT_EQ(check_place(rules_, facts)->status, 400);
}

TEST_F(Access, AnOriginMustBeTheAddressItself) {
  EXPECT_EQ(find_status("localhost:8080", "http://localhost:8080"), 200);
  for (const char* origin : {"http://localhost:8081", "https://localhost:8080", "http://127.0.0.1:8080",
                             "null", "http://evil.example", "http://localhost:8080.evil.example"})
    EXPECT_EQ(find_status("localhost:8080", origin), 403) << origin;
}

TEST_F(Access, ABrowserTellsWhereARequestComesFrom) {
  RequestFacts facts;
  facts.hosts = {"localhost:8080"};
  for (const char* site : {"same-origin", "none", ""}) {
    facts.fetch_site = site;
    EXPECT_FALSE(check_place(rules_, facts)) << site;
  }
  for (const char* site : {"same-site", "cross-site"}) {
    facts.fetch_site = site;
    EXPECT_EQ(check_place(rules_, facts)->status, 403) << site;
  }
  facts.is_page = true;  // a link to the page may stand anywhere
  EXPECT_FALSE(check_place(rules_, facts));
}

TEST_F(Access, TokenInCookieOrHeaderAndInTheAddressOfThePageOnly) {
  RequestFacts facts;
  EXPECT_FALSE(has_token(rules_, facts));
  facts.cookies = {"a=b; hydroscope_8080=0123abcd; c=d"};
  EXPECT_TRUE(has_token(rules_, facts));
  facts.cookies = {"hydroscope_8081=0123abcd", "xhydroscope_8080=0123abcd", "hydroscope_8080=0123abc"};
  EXPECT_FALSE(has_token(rules_, facts));
  facts.authorization = "Bearer 0123abcd";
  EXPECT_TRUE(has_token(rules_, facts));
  facts.authorization = "bearer0123abcd";
  EXPECT_FALSE(has_token(rules_, facts));
  facts.url_token = "0123abcd";
  EXPECT_FALSE(has_token(rules_, facts));
  facts.is_page = true;
  EXPECT_TRUE(has_token(rules_, facts));
}

TEST(ServerQuery, ReadsNumbersFlagsAndLists) {
  const Query query = Query::parse("x=-1.5e2&n=7&on=1&name=a%2Fb+c&list=3,1,2");
  EXPECT_EQ(query.number("x", -1000, 1000, 0.0), -150.0);
  EXPECT_EQ(query.number("y", -1000, 1000, 4.0), 4.0);
  EXPECT_EQ(query.whole("n", 0, 9, 1), 7);
  EXPECT_TRUE(query.flag("on", false));
  EXPECT_EQ(query.text("name"), "a/b c");
  EXPECT_THAT(query.whole_list("list", 3, 0, 9), ElementsAre(3, 1, 2));
  EXPECT_TRUE(query.whole_list("none", 3, 0, 9).empty());
}

TEST(ServerQuery, ErrorsNameTheParameterItsValueAndWhatIsAllowed) {
  const Query query = Query::parse("x=nan&y=1.5x&z=12&f=yes&l=1,2,&m=1,2,3,4&e=");
  EXPECT_EQ(find_error([&] { query.number("x", 0, 1, 0); }), "parameter 'x': 'nan' is not a number");
  EXPECT_EQ(find_error([&] { query.number("y", 0, 1, 0); }), "parameter 'y': '1.5x' is not a number");
  EXPECT_EQ(find_error([&] { query.number("z", 0, 1, 0); }),
            "parameter 'z': '12' is out of range; allowed: 0 to 1");
  EXPECT_EQ(find_error([&] { query.whole("z", 0, 9, 0); }),
            "parameter 'z': '12' is out of range; allowed: 0 to 9");
  EXPECT_THAT(find_error([&] { query.whole("y", 0, 9, 0); }), HasSubstr("is not a whole number"));
  EXPECT_THAT(find_error([&] { query.flag("f", false); }), HasSubstr("one of: 0, 1"));
  EXPECT_THAT(find_error([&] { query.whole_list("l", 9, 0, 9); }), HasSubstr("'l'"));
  EXPECT_THAT(find_error([&] { query.whole_list("m", 3, 0, 9); }), HasSubstr("at most 3"));
  EXPECT_THAT(find_error([&] { query.need("e"); }), HasSubstr("'e' is missing"));
  EXPECT_THAT(find_error([&] { query.allow({"x", "y", "zoom"}); }), HasSubstr("unknown parameter"));
  EXPECT_THAT(find_error([] { Query::parse("zoon=1").allow({"zoom"}); }), HasSubstr("did you mean 'zoom'"));
}

TEST(ServerQuery, BrokenTextIsRefused) {
  for (const char* text : {"a=%", "a=%2", "a=%zz", "a=%00", "a=%0a", "a=1&a=2", "a%01=1"})
    EXPECT_NE(find_error([&] { Query::parse(text); }), "") << text;
  EXPECT_NE(find_error([] { Query::parse("viewer=a/b").need_id("viewer"); }), "");
  EXPECT_NE(find_error([] { Query::parse("viewer=" + std::string(65, 'a')).need_id("viewer"); }), "");
}

TEST(ServerQuery, MakesTheViewThatIsAskedFor) {
  const LiveView view = make_live_view(Query::parse(
      "view=slip&w=640&h=360&smooth=2&az=10&el=-20&zoom=3&px=0.1&py=-0.2&fx=1&fy=2&fz=3&clip=y&share=0.25&"
      "flip=1"
      "&opacity=0.5&mirror=0&edges=1&features=0&density=2&scale=0.5&lo=1&hi=2&theme=dark&text=0&marked=4,5"));
  EXPECT_EQ(view.view, "slip");
  EXPECT_EQ(view.width, 640);
  EXPECT_EQ(view.height, 360);
  EXPECT_EQ(view.smoothing, 2);
  EXPECT_EQ(view.azimuth, 10);
  EXPECT_EQ(view.elevation, -20);
  EXPECT_EQ(view.zoom, 3);
  EXPECT_EQ(view.pan_x, 0.1);
  EXPECT_EQ(view.pan_y, -0.2);
  EXPECT_EQ(*view.focus, Vec3(1, 2, 3));
  EXPECT_EQ(view.clip_axis, 1);
  EXPECT_EQ(view.clip_share, 0.25);
  EXPECT_TRUE(view.clip_flip);
  EXPECT_EQ(view.tool_opacity, 0.5);
  EXPECT_FALSE(view.is_mirrored);
  EXPECT_TRUE(view.element_edges);
  EXPECT_FALSE(view.feature_edges);
  EXPECT_EQ(view.glyph_density, 2);
  EXPECT_EQ(view.glyph_scale, 0.5);
  EXPECT_EQ(view.range->low, 1);
  EXPECT_EQ(view.range->high, 2);
  EXPECT_EQ(view.theme, "dark");
  EXPECT_FALSE(view.has_text);
  EXPECT_THAT(view.marked, ElementsAre(4, 5));
}

TEST(ServerQuery, RefusesViewsThatCannotBeOrCostTooMuch) {
  for (const char* text :
       {"view=nothing", "w=1", "w=100000", "w=8000&h=8000", "az=x", "fx=1", "lo=2&hi=1", "lo=2", "clip=w",
        "marked=1,,2", "theme=blue", "mirror=2", "el=91", "state=live.1"})
    EXPECT_NE(find_error([&] {
                const Query query = Query::parse(text);
                make_live_view(query);
                read_state_key(query, "state");
              }),
              "")
        << text;
  EXPECT_EQ(read_state_key(Query::parse("state=live"), "state"), std::nullopt);
  EXPECT_EQ(read_state_key(Query::parse("state=2.17"), "state"), (StateKey{2, 17}));
}

class Wheel : public testing::Test {
 protected:
  Viewers viewers_{2, seconds(5)};
  Viewers::Time start_ = Viewers::Time{} + std::chrono::hours(1);
};

TEST_F(Wheel, TheFirstViewerHasItAndTheSecondDoesNot) {
  EXPECT_TRUE(viewers_.enter("a", start_));
  EXPECT_TRUE(viewers_.enter("b", start_));
  EXPECT_EQ(viewers_.steering(start_), "a");
  EXPECT_TRUE(viewers_.may_steer("a", start_));
  EXPECT_FALSE(viewers_.may_steer("b", start_ + std::chrono::hours(1)));
  EXPECT_FALSE(viewers_.take("b", false, start_));
  EXPECT_TRUE(viewers_.take("b", true, start_));
  EXPECT_EQ(viewers_.steering(start_), "b");
}

TEST_F(Wheel, IsFreeWhenGivenOrWhenItsHolderHasBeenGoneForAWhile) {
  viewers_.enter("a", start_);
  viewers_.enter("b", start_);
  viewers_.give("b");  // not his to give
  EXPECT_EQ(viewers_.steering(start_), "a");
  viewers_.leave("a", start_);
  EXPECT_FALSE(viewers_.may_steer("b", start_ + seconds(5)));
  EXPECT_TRUE(viewers_.may_steer("b", start_ + milliseconds(5001)));
  viewers_.give("b");
  EXPECT_EQ(viewers_.steering(start_), "");
}

TEST_F(Wheel, AHolderWhoComesBackInTimeKeepsIt) {
  viewers_.enter("a", start_);
  viewers_.enter("b", start_);
  viewers_.leave("a", start_);
  viewers_.enter("a", start_ + seconds(4));
  EXPECT_FALSE(viewers_.may_steer("b", start_ + seconds(60)));
}

TEST_F(Wheel, SecondStreamsOfOneViewerCountOnceAndTooManyViewersAreRefused) {
  EXPECT_TRUE(viewers_.enter("a", start_));
  EXPECT_TRUE(viewers_.enter("a", start_));
  EXPECT_TRUE(viewers_.enter("b", start_));
  EXPECT_FALSE(viewers_.enter("c", start_));
  EXPECT_EQ(viewers_.count(), 2);
  viewers_.leave("a", start_);
  EXPECT_EQ(viewers_.count(), 2);
  viewers_.leave("a", start_);
  EXPECT_TRUE(viewers_.enter("c", start_));
}

class RunFolder : public testing::Test {
 protected:
  RunFolder() {
    fs::create_directories(folder_.path() / "run/states");
    write("run/history.csv", "a,b\n");
    write("run/states/00001.vtp", "vtp");
    write("run/.hidden", "x");
    write("secret", "s");
    fs::create_symlink("../secret", folder_.path() / "run/link");
    fs::create_directory_symlink("..", folder_.path() / "run/up");
  }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name) << text;
  }
  fs::path run() const { return folder_.path() / "run"; }
  TemporaryFolder folder_;
};

TEST_F(RunFolder, GivesOutItsFiles) {
  EXPECT_EQ(open_run_file(run(), "history.csv").read(0, 100), "a,b\n");
  EXPECT_EQ(open_run_file(run(), "states/00001.vtp").read(1, 1), "t");
  EXPECT_EQ(open_run_file(run(), "states/00001.vtp").size(), 3U);
}

TEST_F(RunFolder, GivesOutNothingElse) {
  for (const char* name : {"../secret", "states/../../secret", "./history.csv", "/etc/passwd", "", "/",
                           "states", "states/", "link", "up/secret", "up/run/history.csv", ".hidden",
                           "states//00001.vtp", "..", "history.csv/", "none", "..\\secret"})
    EXPECT_THROW(open_run_file(run(), name), InputError) << name;
  EXPECT_THROW(open_run_file(run(), std::string("history.csv\0x", 13)), InputError);
}

TEST_F(RunFolder, ListsWhatItGivesOut) {
  std::vector<std::string> names;
  for (const RunFile& file : list_run_files(run(), 100)) names.push_back(file.name);
  EXPECT_THAT(names, ElementsAre("history.csv", "states/00001.vtp"));
  EXPECT_EQ(list_run_files(run(), 1).size(), 1U);
}

TEST(ServerJson, ALineHasNoBreaksAndKeepsTexts) {
  const Json json = Json::Object{{"a", Json::Array{1, 2.5}}, {"b", "two\n  lines"}, {"c", Json::Object{}}};
  const std::string line = to_line(json);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(Json::parse(line).write(), json.write());
}

TEST(ServerJson, StatusSaysWhoSteers) {
  WorkstationStatus status;
  status.phase = WorkstationStatus::Phase::kRunning;
  const Json mine = make_status_json(status, {2, "a", "a"}, {}),
             other = make_status_json(status, {2, "a", "b"}, {});
  EXPECT_EQ(mine.at("phase").text(), "running");
  EXPECT_TRUE(mine.at("you_steer").flag());
  EXPECT_FALSE(other.at("you_steer").flag());
  EXPECT_EQ(other.at("steering_viewer").text(), "a");
  EXPECT_TRUE(make_status_json(status, {0, "", ""}, {}).at("steering_viewer").is_null());
  EXPECT_FALSE(make_status_json(status, {0, "", ""}, {}).at("you_steer").flag());
}

TEST(ServerJson, HistoryHasARowAnIncrementWithItsQuantities) {
  const Json history = make_history_json({make_report(3), make_report(4)}, {"r45_mm", "t_mm"});
  ASSERT_EQ(history.at("rows").items().size(), 2U);
  const Json& row = history.at("rows").items()[1];
  EXPECT_EQ(row.at("increment").number(), 4);
  EXPECT_EQ(row.at("limited_by").text(), "touch");
  EXPECT_EQ(row.at("quantities").at("t_mm").number(), 1.25);
  EXPECT_EQ(history.at("columns").items().size(), row.members().size());
}

TEST(ContactCount, OneAnIncrementThatHasEvents) {
  std::vector<ContactEvent> events;
  for (const auto& [increment, kind] : std::vector<std::pair<int, EventKind>>{{1, EventKind::kTouch},
                                                                              {1, EventKind::kTouch},
                                                                              {1, EventKind::kStick},
                                                                              {2, EventKind::kStick},
                                                                              {3, EventKind::kDetach},
                                                                              {3, EventKind::kRetouch},
                                                                              {3, EventKind::kSlip},
                                                                              {3, EventKind::kTakenBack}}) {
    events.push_back(make_event(increment, ""));
    events.back().kind = kind;
  }
  const std::vector<ContactCounts> counts = count_contact(events);
  ASSERT_EQ(counts.size(), 2U);
  EXPECT_EQ(counts[0].increment, 1);
  EXPECT_EQ(counts[0].touched, 2);
  EXPECT_EQ(counts[1].increment, 3);
  EXPECT_EQ(counts[1].detached, 1);
  EXPECT_EQ(counts[1].retouched, 1);
  EXPECT_EQ(counts[1].slipped, 1);
}

/// A node that presses with 8 N, lets go under a tension of 2 N, and slides with 6 N.
std::shared_ptr<Snapshot> make_pressing_state() {
  auto state = std::make_shared<Snapshot>(*make_snapshot(make_model(), 2));
  state->contact_state[1] = ContactClass::kSlip;
  state->contact_tool[1] = 0;
  state->tool_normal[1] = Vec3(0, 0.6, 0.8);
  state->contact_force[1] = 8.0 * Vec3(0, 0.6, 0.8) + Vec3(6, 0, 0);
  state->release_threshold[1] = 2.0;
  state->release_reference[1] = 40.0;
  state->slip[1] = Vec3(3, 4, 0);
  return state;
}

TEST(NodeValues, ForcesAreTakenApartAndTheMarginIsWhatMayStillBeLost) {
  const auto state = make_pressing_state();
  const auto first = make_snapshot(make_model(), 0);
  const Json record = make_node_record(*state, *first, 1, 5);
  EXPECT_EQ(record.at("contact").text(), "slip");
  EXPECT_EQ(record.at("tool").text(), "die");
  EXPECT_EQ(record.at("branch").number(), 5);
  EXPECT_NEAR(record.at("normal_force_N").number(), 8.0, 1e-12);  // rounding of 0.6^2 + 0.8^2
  EXPECT_NEAR(record.at("friction_N").number(), 6.0, 1e-12);
  EXPECT_NEAR(record.at("margin_N").number(), 10.0, 1e-12);
  EXPECT_NEAR(record.at("margin_share").number(), 0.25, 1e-12);
  EXPECT_EQ(record.at("slip_mm").number(), 5.0);
  const Vec3 moved = state->points[1] - first->points[1];
  EXPECT_EQ(record.at("displacement_mm").items()[1].number(), moved.y());
  EXPECT_EQ(record.at("thickness_mm").number(), state->thickness[1]);
}

TEST(NodeValues, WhatIsNotKnownIsNull) {
  auto state = std::make_shared<Snapshot>(*make_snapshot(make_model(), 0));
  const Json free = Json::parse(Json(make_node_record(*state, *state, 0, 0)).write());
  for (const char* key : {"tool", "tool_normal", "normal_force_N", "friction_N", "margin_N"})
    EXPECT_TRUE(free.at(key).is_null()) << key;
  EXPECT_EQ(Json(make_node_record(*state, *state, 3, 0)).at("contact").text(), "detached");
  state->toggles.clear();
  state->let_go_time.clear();
  state->release_reference.clear();
  state->release_threshold.clear();
  const Json old = Json::parse(Json(make_node_record(*state, *state, 1, 0)).write());
  for (const char* key : {"let_go_time_s", "toggles", "margin_N"}) EXPECT_TRUE(old.at(key).is_null()) << key;
  EXPECT_THROW(make_node_record(*state, *state, 6, 0), InputError);
  EXPECT_THROW(make_node_record(*state, *state, -1, 0), InputError);
}

TEST(NodeValues, HistoryHasAnEntryAState) {
  NodeHistory history(1);
  history.add(*make_snapshot(make_model(), 0));
  history.add(*make_pressing_state());
  const Json json = history.make_json();
  for (const char* key : {"increment", "time_s", "pressure_MPa", "thickness_mm", "plastic_strain", "gap_mm",
                          "normal_force_N", "margin_N", "contact", "slip_mm"})
    EXPECT_EQ(json.at(key).items().size(), 2U) << key;
  EXPECT_NEAR(json.at("margin_N").items()[1].number(), 10.0, 1e-12);
}

TEST(NodeValues, SummaryCountsClassesAndSpreads) {
  const auto state = make_snapshot(make_model(), 2);  // classes 0 1 2 3 0 1; the gap of node 2 is not known
  const Json summary = make_nodes_summary(*state, {0, 1, 2, 4});
  EXPECT_EQ(summary.at("contact").at("free").number(), 2);
  EXPECT_EQ(summary.at("contact").at("stick").number(), 1);
  EXPECT_EQ(summary.at("contact").at("detached").number(), 0);
  EXPECT_EQ(summary.at("gap_mm").at("count").number(), 3);
  EXPECT_EQ(summary.at("thickness_mm").at("max").number(), state->thickness[0]);
  EXPECT_EQ(summary.at("thickness_mm").at("min").number(), state->thickness[4]);
}

}  // namespace
}  // namespace hydroscope::test
