// SPDX-License-Identifier: GPL-3.0-or-later
// A coarse tube blown into a box die (corner.toml), and one whose die is taken away (leaving.toml), steered.
#include "app/workstation/workstation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "app/workstation/journal.h"
#include "app/workstation/replay.h"
#include "solver/base/error.h"
#include "solver/scene/scene_reader.h"
#include "tests/app/file_size_limit.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Phase = WorkstationStatus::Phase;

const std::string kCorner = "tests/baselines/corner.toml", kLeaving = "tests/baselines/leaving.toml";

class WorkstationTest : public testing::Test {
 protected:
  std::unique_ptr<Workstation> open(const std::string& file = kCorner, const std::string& name = "run",
                                    const std::vector<std::string>& sets = {}) {
    WorkstationOptions options;
    options.output = folder_.path() / name;
    for (const std::string& set : sets) options.overrides.push_back(make_override(set));
    return std::make_unique<Workstation>(read_scene(file, options.overrides), options);
  }
  /// The command takes effect; then waits until nothing runs.
  WorkstationStatus obey(Workstation& w, const std::string& text) {
    const CommandReply reply = w.command(text, "test");
    EXPECT_TRUE(reply.is_done) << text << ": " << reply.text;
    return w.wait_halted();
  }
  std::string refusal(Workstation& w, const std::string& text) {
    const CommandReply reply = w.command(text, "test");
    EXPECT_FALSE(reply.is_done) << text;
    return reply.text;
  }
  /// Repeats `from`/journal.jsonl in a folder of its own.
  fs::path replay(const fs::path& from) {
    const JournalContents journal = read_journal(from / "journal.jsonl");
    WorkstationOptions options;
    options.output = folder_.path() / "replayed";
    options.overrides = make_overrides(journal.head);
    Board board;
    Steering steering(read_scene(journal.head.scene, options.overrides), options, board);
    const std::atomic<bool> stop{false};
    Replay(journal, steering).run(stop);
    return options.output;
  }
  TemporaryFolder folder_;
};

void expect_same_tables_and_states(const fs::path& a, const fs::path& b) {
  EXPECT_EQ(read_text(a / "history.csv"), read_text(b / "history.csv"));
  EXPECT_EQ(read_text(a / "events.csv"), read_text(b / "events.csv"));
  EXPECT_EQ(read_text(a / "overrides.txt"), read_text(b / "overrides.txt"));
  const auto states = find_states({a});
  ASSERT_EQ(states.size(), find_states({b}).size());
  for (const fs::path& state : states)
    EXPECT_TRUE(read_text(state) == read_text(b / "states" / state.filename())) << state;
}

TEST_F(WorkstationTest, StandsPausedAtTheStart) {
  const auto w = open();
  const WorkstationStatus s = w->status();
  EXPECT_EQ(s.phase, Phase::kPaused);
  EXPECT_EQ(s.increment, 0);
  EXPECT_EQ(s.end_time, 1.0);
  EXPECT_EQ(s.thickness_min, 1.0);
  EXPECT_EQ(w->newest()->increment, 0);
  EXPECT_EQ(w->kept_states().size(), 1U);
  EXPECT_EQ(obey(*w, "step 2").increment, 2);
  EXPECT_EQ(obey(*w, "step").increment, 3);
  EXPECT_EQ(w->history().size(), 3U);
  EXPECT_EQ(w->history(2).size(), 2U);
}

TEST_F(WorkstationTest, HaltsExactlyAtPressureAndTime) {
  const auto w = open();
  WorkstationStatus s = obey(*w, "until pressure 7.3");
  EXPECT_NEAR(s.pressure, 7.3, 1e-12);
  EXPECT_EQ(s.phase, Phase::kPaused);
  s = obey(*w, "until time 0.4");
  EXPECT_EQ(s.time, 0.4);
  EXPECT_EQ(s.until, "");
  EXPECT_THAT(refusal(*w, "until pressure 7.3"), HasSubstr("does not pass 7.3 MPa any more"));
  EXPECT_THAT(refusal(*w, "until time 0.2"), HasSubstr("is not ahead; allowed: after 0.4 s"));
  EXPECT_THAT(refusal(*w, "until node 4711"), HasSubstr("there is no node 4711; allowed: 0 to"));
}

TEST_F(WorkstationTest, HaltsAtTheFirstIncrementOfAnEvent) {
  const auto w = open(kLeaving);
  obey(*w, "until yield");
  EXPECT_GT(*std::max_element(w->newest()->plastic_strain.begin(), w->newest()->plastic_strain.end()), 0.0);
  obey(*w, "back 0");
  const int yield = w->kept_states().back().increment;
  obey(*w, yield > 1 ? "step " + std::to_string(yield - 1) : "step");
  EXPECT_EQ(*std::max_element(w->newest()->plastic_strain.begin(), w->newest()->plastic_strain.end()), 0.0);
  obey(*w, "until touch");
  EXPECT_GT(w->history().back().n_contact, 0);
  EXPECT_EQ((w->history().end() - 2)->n_contact, 0);
  EXPECT_THAT(refusal(*w, "until yield"), HasSubstr("yield already"));
  obey(*w, "until detachment");
  EXPECT_GT(w->history().back().n_detached, 0);
  const auto rows = w->history();
  for (auto row = rows.begin(); row + 1 != rows.end(); ++row) EXPECT_EQ(row->n_detached, 0);
}

TEST_F(WorkstationTest, HaltsWhereANodeLetsGo) {
  const auto w = open(kLeaving);
  const WorkstationStatus s = obey(*w, "until node 3");  // at the latest when the die is taken away
  ASSERT_EQ(s.phase, Phase::kPaused);
  const std::vector<ContactEvent> events = w->events();
  const auto lets_go = [](const ContactEvent& e) { return e.kind == EventKind::kDetach && e.node == 3; };
  ASSERT_EQ(std::count_if(events.begin(), events.end(), lets_go), 1);
  EXPECT_EQ(std::find_if(events.begin(), events.end(), lets_go)->increment, s.increment);
}

TEST_F(WorkstationTest, HaltsAtSlipAndThinning) {
  const auto w = open();
  WorkstationStatus s = obey(*w, "until thinning 0.02");
  EXPECT_LE(s.thickness_min, 0.98);
  EXPECT_GT((w->history().end() - 2)->thickness_min, 0.98);
  EXPECT_THAT(refusal(*w, "until thinning 0.02"), HasSubstr("already"));
  s = obey(*w, "until slip");
  EXPECT_GT(s.n_slip, 0);
  EXPECT_THAT(s.message, HasSubstr("began to slip"));
}

TEST_F(WorkstationTest, UnderVolumeControlHaltsPastThePressure) {
  const auto w = open(kLeaving, "run", {"load.control=volume", "load.volume_ratio=[[0, 1], [1, 1.05]]"});
  const WorkstationStatus s = obey(*w, "until pressure 5");
  const auto rows = w->history();
  ASSERT_GE(rows.size(), 2U);
  EXPECT_GE(s.pressure, 5.0);
  EXPECT_LT((rows.end() - 2)->pressure, 5.0);
}

TEST_F(WorkstationTest, BranchesAreCompleteAndLoseNothing) {
  auto w = open();
  obey(*w, "until time 0.3");
  const int fork = w->status().increment;
  obey(*w, "until time 0.8");
  const std::string before = read_text(w->folder() / "history.csv");
  const std::shared_ptr<const Snapshot> left = w->newest();
  obey(*w, "back " + std::to_string(fork));
  EXPECT_EQ(w->status().branch, 1);
  EXPECT_EQ(w->status().time, 0.3);
  EXPECT_TRUE(fs::exists(folder_.path() / "run/summary.json")) << "what is left has its summary";
  EXPECT_EQ(read_text(folder_.path() / "run/history.csv"), before);
  obey(*w, "until time 0.8");
  EXPECT_EQ(w->newest()->points, left->points) << "the same acts, the same bits";
  EXPECT_EQ(read_text(w->folder() / "history.csv"), before);
  obey(*w, "back " + std::to_string(fork));  // of the parent: a second branch from there
  EXPECT_EQ(w->status().branch, 2);
  EXPECT_THAT(refusal(*w, "back 1"), HasSubstr("is not among the states that can be gone back to"));
  EXPECT_EQ(w->kept(1, fork)->time, 0.3) << "a branch has its parent's states up to the fork";
  EXPECT_EQ(w->kept(2, left->increment), nullptr) << "but not later ones";
  w.reset();
  for (const char* branch : {"run", "run/branches/1", "run/branches/2"}) {
    const fs::path folder = folder_.path() / branch;
    EXPECT_TRUE(fs::exists(folder / "summary.json")) << branch;
    EXPECT_NO_THROW(Workstation(folder).status()) << branch;
    EXPECT_FALSE(find_states({folder}).empty());
  }
}

TEST_F(WorkstationTest, ReplaysEverythingBitForBit) {
  {
    const auto w = open(kCorner, "run", {"states.number=6"});
    obey(*w, "until pressure 9.1");
    obey(*w, "set tool.die.friction 0.2");
    obey(*w, "set load.pressure_MPa [[1.1, 24]]");
    obey(*w, "until touch");
    const int touch = w->status().increment;
    obey(*w, "step 3");
    EXPECT_FALSE(w->command("until pressure 1", "test").is_done);  // no act
    obey(*w, "back " + std::to_string(touch));
    obey(*w, "set increment.largest 0.01");
    w->command("run", "test");
    w->command("pause", "test");  // wherever it stands by then
    obey(*w, "run");
    EXPECT_EQ(w->status().outcome, "completed");
    obey(*w, "back 0");
    w->command("run", "test");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }  // closed while it runs
  const fs::path run = folder_.path() / "run", again = replay(run);
  expect_same_tables_and_states(run, again);
  expect_same_tables_and_states(run / "branches/1", again / "branches/1");
  expect_same_tables_and_states(run / "branches/2", again / "branches/2");
  EXPECT_NE(read_text(run / "history.csv"), read_text(run / "branches/1/history.csv"));
}

TEST_F(WorkstationTest, AReplayThatDiffersSaysWhere) {
  {
    const auto w = open();
    obey(*w, "step 5");
    obey(*w, "stop");
  }
  const fs::path file = folder_.path() / "run/journal.jsonl";
  std::string text = read_text(file);
  const std::size_t at = text.rfind("\"state\": \"") + 10;
  text[at] = text[at] == '0' ? '1' : '0';
  std::ofstream(file) << text;
  try {
    replay(folder_.path() / "run");
    ADD_FAILURE();
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("at increment 5 of branch 0"));
    EXPECT_THAT(error.what(), HasSubstr("the state differs"));
  }
}

TEST_F(WorkstationTest, AfterTheEndGoingBackStillWorks) {
  const auto w = open();
  EXPECT_EQ(obey(*w, "run").phase, Phase::kEnded);
  EXPECT_EQ(w->status().outcome, "completed");
  EXPECT_THAT(refusal(*w, "run"), HasSubstr("'back INCREMENT' goes on from a kept state"));
  const int last = w->status().increment;
  obey(*w, "back " + std::to_string(last));
  EXPECT_THAT(refusal(*w, "run"), HasSubstr("all paths end here"));
  obey(*w, "set load.pressure_MPa [[1.1, 21]]");
  EXPECT_EQ(obey(*w, "run").time, 1.1);
  EXPECT_EQ(find_exit_code(w->close()), ExitCode::kDone);
}

TEST_F(WorkstationTest, AChangeThatIsRefusedChangesNothing) {
  const auto w = open();
  obey(*w, "step 4");
  const std::string journal = read_text(folder_.path() / "run/journal.jsonl");
  EXPECT_THAT(refusal(*w, "set tube.thickness_mm 2"), HasSubstr("cannot be changed while the run goes on"));
  EXPECT_THAT(refusal(*w, "set load.pressure_MPa [[0, 1], [1, 2]]"), HasSubstr("would jump"));
  EXPECT_THAT(refusal(*w, "sett a.b 1"), HasSubstr("did you mean 'set'?"));
  EXPECT_EQ(read_text(folder_.path() / "run/journal.jsonl"), journal);
  EXPECT_FALSE(w->settable().empty());
}

TEST_F(WorkstationTest, ManyThreadsMayCommandAndLook) {
  const auto w = open();
  std::atomic<int> done{0};
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&, k] {
      const std::string who = "thread " + std::to_string(k);
      for (int i = 0; i < 6; ++i) {
        done += w->command(i % 2 == 0 ? "step 2" : "pause", who).is_done ? 1 : 0;
        w->kept(0, 0);
        w->history();
        w->events();
        w->warnings();
        w->kept_states();
        w->wait_status(w->status().version, std::chrono::milliseconds(1));
        EXPECT_GE(w->newest()->increment, 0);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(done, 24);
  const std::size_t increment = static_cast<std::size_t>(w->wait_halted().increment);
  EXPECT_EQ(w->history().size(), increment);
}

TEST_F(WorkstationTest, ClosedWhileRunningItWritesItsSummary) {
  {
    const auto w = open();
    w->command("run", "test");
  }
  EXPECT_THAT(read_text(folder_.path() / "run/summary.json"), HasSubstr("\"user stop\""));
  EXPECT_TRUE(read_journal(folder_.path() / "run/journal.jsonl").entries.back().is_end());
}

TEST_F(WorkstationTest, AFinishedFolderIsLookedAt) {
  std::vector<KeptState> kept;
  std::vector<IncrementReport> rows;
  std::size_t events = 0;
  {
    const auto w = open();
    obey(*w, "until touch");
    obey(*w, "step 2");
    obey(*w, "back 0");
    obey(*w, "run");
    kept = w->kept_states();
    rows = w->history();
    events = w->events().size();
  }
  Workstation w(folder_.path() / "run");
  EXPECT_FALSE(w.status().can_steer);
  EXPECT_EQ(w.status().outcome, "completed");
  EXPECT_EQ(w.status().branch, 1);
  EXPECT_THAT(refusal(w, "run"), HasSubstr("finished run"));
  ASSERT_EQ(w.kept_states().size(), kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const KeptState state = w.kept_states()[i];
    EXPECT_EQ(state.increment, kept[i].increment);
    EXPECT_EQ(state.branch, kept[i].branch);
    EXPECT_EQ(state.touched, kept[i].touched);
    ASSERT_NE(w.kept(state.branch, state.increment), nullptr);
    EXPECT_EQ(w.kept(state.branch, state.increment)->increment, state.increment);
  }
  ASSERT_EQ(w.history().size(), rows.size());
  EXPECT_EQ(w.history().back().pressure, rows.back().pressure);
  EXPECT_EQ(w.history().back().limited_by, rows.back().limited_by);
  EXPECT_EQ(w.history().back().quantities, rows.back().quantities);
  EXPECT_EQ(w.events().size(), events);
  EXPECT_THROW(Workstation(folder_.path()), InputError);
}

TEST_F(WorkstationTest, AFullDiskEndsTheRunAndIsSaid) {
  const auto w = open();
  {
    const FileSizeLimit limit(4000);
    w->command("run", "test");
    w->wait_halted();
  }
  const WorkstationStatus s = w->status();
  EXPECT_EQ(s.phase, Phase::kEnded);
  EXPECT_EQ(s.outcome, "error");
  EXPECT_THAT(s.message, HasSubstr("cannot be written"));
  EXPECT_FALSE(fs::exists(folder_.path() / "run/summary.json"));
  EXPECT_EQ(find_exit_code(s), ExitCode::kEnvironment);
  obey(*w, "back 0");  // there is room again
  EXPECT_EQ(obey(*w, "step 3").increment, 3);
}

TEST(RestorePoints, AreThinnedOutEvenly) {
  RestorePoints points(5);
  int dropped = 0;
  points.on_drop = [&dropped](int, int) { ++dropped; };
  for (int i = 0; i <= 20; ++i) {
    RunPoint point;
    point.state.increment = i;
    point.state.time = 0.1 * i;
    points.add(0, point);
  }
  const std::vector<int> left = points.increments(0);
  ASSERT_EQ(left.size(), 5U);
  EXPECT_EQ(dropped, 16);
  EXPECT_EQ(left.front(), 0);
  EXPECT_EQ(left.back(), 20);
  for (std::size_t i = 1; i < left.size(); ++i) EXPECT_LE(left[i] - left[i - 1], 10);
}

}  // namespace
}  // namespace hydroscope::test
