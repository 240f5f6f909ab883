// SPDX-License-Identifier: GPL-3.0-or-later
// Viewers at work: commands, roles, events, pictures, and viewers that behave badly. A stand-in paints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <future>
#include <thread>

#include "app/results/result_folder.h"
#include "app/results/state_file.h"
#include "solver/base/whole_file.h"
#include "tests/app/server/served_scene.h"

namespace hydroscope::test {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Phase = WorkstationStatus::Phase;

class ServerViewers : public testing::Test {
 protected:
  Got frame(const std::string& viewer, const std::string& more) const {
    return scene_.get("/api/frame?viewer=" + viewer + "&w=64&h=64&" + more);
  }
  /// In the background.
  std::future<Got> ask_frame(const std::string& viewer, const std::string& more) const {
    return std::async(std::launch::async, [this, viewer, more] { return frame(viewer, more); });
  }
  Json status(const std::string& viewer = "a") const {
    return scene_.get("/api/status?viewer=" + viewer).json();
  }
  /// Asks until it is so; false after a minute.
  static bool wait_until(const std::function<bool()>& is_so) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!is_so()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(milliseconds(20));
    }
    return true;
  }

  std::shared_ptr<Gate> gate_ = std::make_shared<Gate>();
  ServedScene scene_{make_stand_in(gate_), 60, milliseconds(300)};
};

TEST_F(ServerViewers, CommandsAreDoneOrSayWhatIsWrong) {
  const Got done = scene_.post("/api/command?viewer=a", " step 3\n");
  EXPECT_EQ(done.status, 200);
  EXPECT_TRUE(done.json().at("done").flag());
  EXPECT_EQ(scene_.wait_for([](const auto& s) { return s.increment == 3; }).increment, 3);
  const Got wrong = scene_.post("/api/command?viewer=a", "stepp 3");
  EXPECT_EQ(wrong.status, 400);
  EXPECT_FALSE(wrong.json().at("done").flag());
  EXPECT_THAT(wrong.error(), HasSubstr("step"));
  EXPECT_EQ(scene_.post("/api/command?viewer=a", "set tool.die.friction -1").status, 400);
  EXPECT_THAT(read_whole_file(scene_.results() + "/journal.jsonl"), HasSubstr("\"who\": \"a\""));
}

TEST_F(ServerViewers, OneSteersAndTheOtherMayWhenTheWheelIsFree) {
  EventReader first(scene_, "a");
  ASSERT_TRUE(first.wait_for("event: status"));
  EventReader second(scene_, "b");
  ASSERT_TRUE(second.wait_for("event: status"));
  EXPECT_TRUE(status("a").at("you_steer").flag());
  EXPECT_FALSE(status("b").at("you_steer").flag());
  EXPECT_EQ(status("b").at("steering_viewer").text(), "a");

  const Got refused = scene_.post("/api/command?viewer=b", "step");
  EXPECT_EQ(refused.status, 409);
  EXPECT_NE(refused.error(), "");
  EXPECT_EQ(scene_.post("/api/steer?viewer=b&take=1").status, 409);
  EXPECT_EQ(scene_.workstation->status().increment, 0);

  EXPECT_EQ(scene_.post("/api/steer?viewer=a&take=0").status, 200);
  EXPECT_EQ(scene_.post("/api/steer?viewer=b&take=1").status, 200);
  EXPECT_TRUE(second.wait_for("\"steering_viewer\": \"b\""));
  EXPECT_EQ(scene_.post("/api/command?viewer=b", "step").status, 200);
  EXPECT_EQ(scene_.post("/api/command?viewer=a", "step").status, 409);
  EXPECT_EQ(scene_.post("/api/steer?viewer=a&take=1&force=1").status, 200);
  EXPECT_EQ(scene_.post("/api/command?viewer=a", "step").status, 200);
}

TEST_F(ServerViewers, EventsTellStatusContactAndWarnings) {
  EventReader reader(scene_, "a");
  ASSERT_TRUE(reader.wait_for("event: status"));
  EXPECT_EQ(scene_.run_to_end().phase, Phase::kEnded);
  EXPECT_TRUE(reader.wait_for("\"phase\": \"ended\""));
  // The same counts as in the timeline, increment by increment.
  int touched = 0, told = 0;
  const Json timeline = scene_.get("/api/timeline").json();
  for (const Json& kept : timeline.at("kept").items())
    touched += static_cast<int>(kept.at("touched").number());
  EXPECT_GT(touched, 0);
  std::istringstream lines(reader.text());
  bool is_contact = false;
  for (std::string line; std::getline(lines, line);) {
    if (is_contact && line.rfind("data: ", 0) == 0)
      told += static_cast<int>(Json::parse(line.substr(6)).at("touched").number());
    if (line.rfind("event: ", 0) == 0) is_contact = line == "event: contact";
  }
  EXPECT_EQ(told, touched);
}

TEST_F(ServerViewers, PicturesAreOfTheSizeAndStateThatWereAskedFor) {
  const Got picture = scene_.get("/api/frame?viewer=a&w=100&h=80");
  EXPECT_EQ(picture.status, 200);
  EXPECT_EQ(picture.header("Content-Type"), "image/jpeg");
  EXPECT_THAT(picture.body, StartsWith("\xff\xd8\xff"));
  EXPECT_EQ(picture.header("X-Increment"), "0");
  EXPECT_EQ(picture.header("X-Branch"), "0");
  EXPECT_EQ(picture.header("X-Range"), "1,2.5");
  EXPECT_EQ(frame("a", "az=10").body, frame("a", "az=10").body);
  EXPECT_NE(frame("a", "az=10").body, frame("a", "az=11").body);
  const Got png = frame("a", "format=png&download=1");
  EXPECT_THAT(png.body, StartsWith("\x89PNG"));
  EXPECT_THAT(png.header("Content-Disposition"), HasSubstr("contact-map-0.png"));

  scene_.command("step 2");
  scene_.wait_for([](const auto& s) { return s.increment == 2 && s.phase == Phase::kPaused; });
  EXPECT_TRUE(wait_until([&] { return frame("a", "state=live").header("X-Increment") == "2"; }));
  EXPECT_EQ(frame("a", "state=0.2").header("X-Increment"), "2");  // not kept, but the newest
  EXPECT_EQ(frame("a", "state=0.0&az=10").body, frame("b", "az=10&state=0.0").body);
  EXPECT_EQ(frame("a", "state=0.7").status, 404);
}

TEST_F(ServerViewers, WatchingWaitsForANewState) {
  std::future<Got> waiting = ask_frame("a", "after=0");
  EXPECT_EQ(frame("b", "").status, 200);  // nobody is held up by it
  scene_.command("step");
  const Got picture = waiting.get();
  EXPECT_EQ(picture.status, 200);
  EXPECT_EQ(picture.header("X-Increment"), "1");
  EXPECT_EQ(frame("a", "after=0").header("X-Increment"), "1");
}

TEST_F(ServerViewers, OfOneSlotOnlyTheNewestIsDrawn) {
  gate_->close();
  std::future<Got> drawn = ask_frame("a", "az=1");
  ASSERT_TRUE(gate_->wait_for(1));
  std::future<Got> older = ask_frame("a", "az=2");
  std::future<Got> other_slot = ask_frame("a", "az=4&slot=b");
  // The older one is waiting, or about to: asked again until the answer is that it was replaced.
  std::future<Got> newer = ask_frame("a", "az=3");
  ASSERT_TRUE(wait_until([&] {
    return older.wait_for(milliseconds(0)) == std::future_status::ready ||
           newer.wait_for(milliseconds(0)) == std::future_status::ready;
  }));
  gate_->open();
  EXPECT_EQ(drawn.get().status, 200);
  EXPECT_EQ(other_slot.get().status, 200);
  std::vector<int> statuses = {older.get().status, newer.get().status};
  std::sort(statuses.begin(), statuses.end());
  EXPECT_THAT(statuses, testing::ElementsAre(200, 204));
  EXPECT_EQ(gate_->passes(), 3);
}

TEST_F(ServerViewers, ManyViewersComeAndGoAndCommandsAreStillTaken) {
  constexpr int kMany = 50;
  {
    std::vector<std::unique_ptr<EventReader>> readers;
    for (int i = 0; i < kMany; ++i)
      readers.push_back(std::make_unique<EventReader>(scene_, "v" + std::to_string(i)));
    for (const auto& reader : readers) ASSERT_TRUE(reader->wait_for("event: status"));
    EXPECT_EQ(status().at("viewers").number(), kMany);
    const std::string holder = status().at("steering_viewer").text();
    std::vector<std::future<Got>> pictures;
    for (int i = 0; i < kMany; ++i)
      pictures.push_back(ask_frame("v" + std::to_string(i), "az=" + std::to_string(i)));
    EXPECT_EQ(scene_.post("/api/command?viewer=" + holder, "run").status, 200);
    for (auto& picture : pictures) EXPECT_EQ(picture.get().status, 200);
  }
  EXPECT_TRUE(wait_until([&] { return status().at("viewers").number() == 0; }));
  EXPECT_EQ(scene_.wait_for([](const auto& s) { return s.phase == Phase::kEnded; }).outcome, "completed");
}

TEST_F(ServerViewers, TooManyViewersAreToldSo) {
  std::vector<std::unique_ptr<EventReader>> readers;
  for (int i = 0; i < 60; ++i)
    readers.push_back(std::make_unique<EventReader>(scene_, "v" + std::to_string(i)));
  for (const auto& reader : readers) ASSERT_TRUE(reader->wait_for("event: status"));
  const Got refused = scene_.get("/api/events?viewer=more");
  EXPECT_EQ(refused.status, 503);
  EXPECT_THAT(refused.error(), HasSubstr("60 viewers"));
  EXPECT_EQ(scene_.get("/api/status?viewer=more").status, 200);
}

TEST_F(ServerViewers, AViewerThatStopsReadingIsDroppedAndHoldsNobodyUp) {
  const std::string head = " HTTP/1.1\r\nHost: " + scene_.own_host() + "\r\nAuthorization: Bearer " +
                           scene_.server->token() + "\r\n\r\n";
  const RawConnection picture(scene_.server->port(), 1), events(scene_.server->port(), 1);
  events.send("GET /api/events?viewer=deaf" + head);
  ASSERT_TRUE(wait_until([&] { return status().at("viewers").number() == 1; }));
  // 24 MB that do not compress: no socket holds as much.
  picture.send("GET /api/frame?viewer=deaf&w=3000&h=2000&format=png" + head);
  ASSERT_TRUE(gate_->wait_for(1));
  scene_.post("/api/steer?viewer=a&take=1&force=1");
  EXPECT_EQ(scene_.post("/api/command?viewer=a", "run").status, 200);
  EXPECT_EQ(frame("b", "az=5").status, 200);
  EXPECT_EQ(scene_.wait_for([](const auto& s) { return s.phase == Phase::kEnded; }).outcome, "completed");
  EXPECT_EQ(frame("b", "az=6").status, 200);
  EXPECT_TRUE(picture.wait_for_hang_up());
  EXPECT_LT(picture.read_all().size(), 10'000'000U);
}

TEST_F(ServerViewers, TheRunGoesOnWhenTheBrowserIsClosed) {
  auto reader = std::make_unique<EventReader>(scene_, "a");
  ASSERT_TRUE(reader->wait_for("event: status"));
  std::future<Got> watching = ask_frame("a", "after=0");
  ASSERT_EQ(scene_.post("/api/command?viewer=a", "run").status, 200);
  scene_.wait_for([](const auto& s) { return s.increment >= 3; });
  reader.reset();
  watching.get();
  const WorkstationStatus end = scene_.wait_for([](const auto& s) { return s.phase == Phase::kEnded; });
  EXPECT_EQ(end.outcome, "completed");
  EXPECT_EQ(end.time, 1.0);
  // Nothing is lost: a row an increment, in memory, over HTTP and on disk.
  const auto increments = static_cast<std::size_t>(end.increment);
  EXPECT_EQ(scene_.get("/api/history").json().at("rows").items().size(), increments);
  const std::string table = scene_.get("/api/file?name=history.csv").body;
  EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')), increments + 1);
  EXPECT_EQ(scene_.get("/api/file?name=summary.json").json().at("outcome").text(), "completed");
}

// Single increments are not kept; but what a picture has shown can be picked while the solver is ahead of it.
TEST_F(ServerViewers, WhatWasShownLiveIsWithinReachForAWhile) {
  for (int k = 1; k <= 3; ++k) {
    scene_.command("step");
    ASSERT_TRUE(wait_until([&] { return frame("a", "az=1").header("X-Increment") == std::to_string(k); }));
  }
  const Got passed = scene_.get("/api/node/3?state=0.2");
  ASSERT_EQ(passed.status, 200);
  EXPECT_EQ(passed.json().at("increment").number(), 2);
  EXPECT_EQ(scene_.get("/api/node/3?state=0.4").status, 404);
}

TEST_F(ServerViewers, NodeValuesAreThoseOfTheSavedState) {
  const WorkstationStatus end = scene_.run_to_end();
  const auto model = read_model(scene_.results(), find_states({scene_.results()}).front());
  const auto saved = read_state(find_states({scene_.results()}).back(), model);
  ASSERT_EQ(saved->increment, end.increment);
  const Json history = scene_.get("/api/node/3/history").json();
  const Json node = scene_.get("/api/node/3?state=0." + std::to_string(end.increment)).json();
  EXPECT_EQ(node.at("position_mm").items()[0].number(), saved->points[3].x());
  EXPECT_EQ(node.at("thickness_mm").number(), saved->thickness[3]);
  EXPECT_EQ(node.at("plastic_strain").number(), saved->plastic_strain[3]);
  EXPECT_EQ(node.at("contact_pressure_MPa").number(), saved->contact_pressure[3]);
  EXPECT_EQ(node.at("normal_force_N").number(), saved->contact_force[3].dot(saved->tool_normal[3]));
  const std::vector<Json>& increments = history.at("increment").items();
  EXPECT_EQ(increments.size(), scene_.get("/api/timeline").json().at("kept").items().size());
  EXPECT_EQ(increments.back().number(), end.increment);
  EXPECT_EQ(history.at("thickness_mm").items().back().number(), saved->thickness[3]);
}

TEST_F(ServerViewers, ModelWarningsFilesAndLedger) {
  const Json model = scene_.get("/api/model").json();
  EXPECT_EQ(model.at("elements").number(), 8);
  EXPECT_EQ(model.at("tools").items()[0].text(), "die");
  EXPECT_THAT(scene_.get("/api/model").body, HasSubstr("tool.die.friction"));
  EXPECT_TRUE(scene_.get("/api/ledger").json().at("episodes").items().empty());
  scene_.run_to_end();
  const Json ledger = scene_.get("/api/ledger").json();
  ASSERT_FALSE(ledger.at("episodes").items().empty());
  const Json& episode = ledger.at("episodes").items().front();
  EXPECT_EQ(episode.at("place_mm").items().size(), 3U);
  EXPECT_EQ(ledger.at("increment").number(), scene_.workstation->status().increment);
  EXPECT_EQ(scene_.get("/api/warnings").json().at("warnings").items().size(),
            scene_.workstation->warnings().size());
  EXPECT_THAT(scene_.get("/api/files").body, HasSubstr("\"states/00001.vtp\""));
}

TEST_F(ServerViewers, AFilmIsMadeStepByStep) {
  scene_.run_to_end();
  const std::string target = "/api/animation?viewer=a&w=64&h=64&fps=5";
  const Got begun = scene_.get(target);
  ASSERT_EQ(begun.status, 202) << begun.body;
  EXPECT_EQ(begun.json().at("of").number(), scene_.workstation->status().n_kept + 1);
  Got film;
  ASSERT_TRUE(wait_until([&] {
    film = scene_.get(target);
    return film.status != 202;
  }));
  EXPECT_EQ(film.status, 200) << film.body;
  EXPECT_EQ(film.header("Content-Type"), "image/webp");
  EXPECT_THAT(film.body, StartsWith("RIFF"));
  EXPECT_EQ(film.body.substr(8, 4), "WEBP");
  EXPECT_EQ(gate_->passes(), scene_.workstation->status().n_kept);
}

TEST_F(ServerViewers, TheEndOfTheServerEndsAllStreamsAndWaits) {
  EventReader reader(scene_, "a");
  ASSERT_TRUE(reader.wait_for("event: status"));
  std::future<Got> watching = ask_frame("a", "after=0");
  ASSERT_EQ(scene_.post("/api/command?viewer=a", "run").status, 200);
  gate_->close();
  std::future<Got> held = ask_frame("b", "");
  ASSERT_TRUE(gate_->wait_for(1));
  gate_->open();
  scene_.server.reset();
  EXPECT_TRUE(reader.wait_for_end());
  watching.get();
  held.get();
}

TEST_F(ServerViewers, ResultsOnDiskAreLookedAtOnly) {
  scene_.run_to_end();
  scene_.server.reset();
  scene_.workstation = std::make_unique<Workstation>(std::filesystem::path(scene_.results()));
  ServerOptions options;
  options.painter = make_stand_in(gate_);
  scene_.serve(options);
  EXPECT_FALSE(status().at("can_steer").flag());
  const Got refused = scene_.post("/api/command?viewer=a", "run");
  EXPECT_EQ(refused.status, 409);
  EXPECT_THAT(refused.error(), HasSubstr("results on disk"));
  const Json kept = scene_.get("/api/timeline").json().at("kept");
  ASSERT_GE(kept.items().size(), 2U);
  const int increment = static_cast<int>(kept.items()[1].at("increment").number());
  EXPECT_EQ(frame("a", "state=0." + std::to_string(increment)).header("X-Increment"),
            std::to_string(increment));
  EXPECT_EQ(scene_.get("/api/ledger").status, 200);
  EXPECT_FALSE(scene_.get("/api/history").json().at("rows").items().empty());
}

}  // namespace
}  // namespace hydroscope::test
