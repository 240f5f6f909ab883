// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in for the solver, and everything that the program does around it.
#include "app/record_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/results/json.h"
#include "sample_run.h"
#include "solver/base/error.h"
#include "tests/app/file_size_limit.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kHistoryHead =
    "increment,time_s,pressure_MPa,feed_mm,step_fraction,limited_by,limited_at,n_contact,n_stick,n_slip,n_"
    "detached,"
    "residual,tangential_rest,iterations,factorisations,thickness_min_mm,thickness_max_mm,q.r45_mm,q.t_mm\n";

class RecordRun : public testing::Test {
 protected:
  /// As a solver would: increments until the end or the stop, states at some of them.
  RunSummary solve(const RunObserver& observer, int increments, Outcome outcome) {
    observer.on_start(*model_, 30, 0.1 * increments);
    observer.on_snapshot(make_snapshot(model_, 0), true, true);
    int done = 0;
    while (done < increments && !stop_) {
      ++done;
      IncrementReport report = make_report(done);
      if (done == 2) report.events = {make_event(2, "tension, in a group")};
      if (done == 2) report.warnings = {{2, 0.2, "necking", "at node 3"}};
      observer.on_increment(report);
      if (done % 2 == 0) observer.on_snapshot(make_snapshot(model_, done), true, true);
    }
    observer.on_snapshot(make_snapshot(model_, done), true, false);
    return make_summary(stop_ ? Outcome::kUserStop : outcome, done);
  }

  RecordedRun record(int increments, Outcome outcome, const FrameSink& frames = {}) {
    RunWriter writer(
        make_result_folder(path(), true),
        {"scenes/a.toml", "title = \"a\"\n", {"tool.die.friction=0.1"}, {{"die", "fine\n"}}, 2, 1.0}, *model_,
        {"r45_mm", "t_mm"});
    Progress progress(log_);
    return record_run([&](const RunObserver& observer) { return solve(observer, increments, outcome); },
                      writer, frames, progress, stop_);
  }

  fs::path path() const { return folder_.path() / "run"; }
  std::string read(const std::string& name) const { return read_whole_file(path() / name); }
  ~RecordRun() override { std::fclose(log_); }

  TemporaryFolder folder_;
  std::shared_ptr<const SnapshotModel> model_ = make_model();
  std::atomic<bool> stop_{false};
  std::FILE* log_ = std::tmpfile();
};

TEST_F(RecordRun, WritesEverything) {
  const RecordedRun run = record(5, Outcome::kCompleted);
  EXPECT_EQ(run.exit_code, ExitCode::kDone);
  EXPECT_TRUE(run.is_summary_written);
  const std::string history = read("history.csv");
  EXPECT_THAT(history, StartsWith(kHistoryHead));
  EXPECT_EQ(std::count(history.begin(), history.end(), '\n'), 6);
  EXPECT_THAT(history,
              HasSubstr("\n1,0.1,0.3333333333333333,0,0.75," + std::string(to_string(Limiter::kTouch)) +
                        ",12,3,2,1,0,1.25e-05,0.0625,4,3,1.25,1.5,0.14285714285714285,1.25\n"));
  EXPECT_EQ(read("events.csv"),
            "increment,time_s,kind,node,x_mm,y_mm,z_mm,tool,cause,force_before_N,force_after_N,gap_mm,"
            "patch_pressure_MPa,threshold_N\n2,0.2," +
                std::string(to_string(EventKind::kDetach)) +
                ",7,1,2.5,-3,die,\"tension, in a group\",12.5,-0.75,0.125,-0.5,0.25\n");
  EXPECT_EQ(read("scene.toml"), "title = \"a\"\n");
  EXPECT_EQ(read("overrides.txt"), "tool.die.friction=0.1\n");
  EXPECT_EQ(read("tools/die.txt"), "fine\n");
}

TEST_F(RecordRun, StatesAndTheirIndex) {
  record(5, Outcome::kCompleted);
  const std::string index = read("states.pvd");
  // Initial, 2, 4 and the last one, 5.
  EXPECT_EQ(find_states({path()}).size(), 4U);
  EXPECT_THAT(index, HasSubstr("<DataSet timestep=\"0.2\" part=\"0\" file=\"states/00001.vtp\"/>"));
  EXPECT_THAT(index, HasSubstr("<DataSet timestep=\"0.5\" part=\"0\" file=\"states/00003.vtp\"/>"));
}

TEST_F(RecordRun, LastStateIsNotWrittenTwice) {
  record(4, Outcome::kCompleted);
  EXPECT_EQ(find_states({path()}).size(), 3U);
}

TEST_F(RecordRun, SummaryHasThePromisedKeys) {
  record(5, Outcome::kBursting);
  const Json json = Json::parse(read("summary.json"));
  EXPECT_EQ(json.at("outcome").text(), to_string(Outcome::kBursting));
  EXPECT_EQ(json.at("increments").number(), 5);
  EXPECT_EQ(json.at("factorisations").number(), 10);
  EXPECT_EQ(json.at("degrees_of_freedom").number(), 30);
  EXPECT_GT(json.at("peak_memory_mb").number(), 1.0);
  EXPECT_EQ(json.at("quantities").at("r45_mm").number(), 1.0 / 7.0);
  for (const char* phase :
       {"total", "search", "assemble", "factorise", "solve", "update", "snapshot", "render", "write"}) {
    EXPECT_GE(json.at("wall_s").at(phase).number(), 0.0) << phase;
  }
  EXPECT_EQ(json.at("message").text(), "because");
  EXPECT_EQ(json.at("time_s").number(), 0.5);
  EXPECT_EQ(json.at("warnings").items()[0].at("kind").text(), "necking");
  EXPECT_EQ(json.at("overrides").items()[0].text(), "tool.die.friction=0.1");
  EXPECT_EQ(json.at("version").text(), HYDROSCOPE_VERSION);
}

TEST_F(RecordRun, OutcomeBecomesTheExitCode) {
  const std::vector<std::pair<Outcome, int>> codes = {
      {Outcome::kCompleted, 0}, {Outcome::kPressureMaximum, 3}, {Outcome::kBursting, 3},
      {Outcome::kBuckling, 3},  {Outcome::kSingular, 4},        {Outcome::kStepFloor, 4},
      {Outcome::kUserStop, 130}};
  for (const auto& [outcome, code] : codes) {
    EXPECT_EQ(static_cast<int>(record(1, outcome).exit_code), code) << to_string(outcome);
  }
}

TEST_F(RecordRun, SummaryComesLast) {
  bool was_there = false;
  FrameSink frames;
  frames.finish = [&] {
    was_there = fs::exists(path() / "summary.json");
    return 1.5;
  };
  const RecordedRun run = record(2, Outcome::kCompleted, frames);
  EXPECT_FALSE(was_there);
  EXPECT_EQ(Json::parse(read("summary.json")).at("wall_s").at("render").number(), 1.5);
  EXPECT_EQ(run.render_time, 1.5);
}

TEST_F(RecordRun, FullDiskStopsCleanly) {
  RecordedRun run;
  {
    // Room for the head and some rows of history.csv; states are larger, so they fail first.
    const FileSizeLimit limit(2200);
    run = record(1000, Outcome::kCompleted);
  }
  EXPECT_EQ(run.exit_code, ExitCode::kEnvironment);
  EXPECT_THAT(run.trouble, HasSubstr("cannot be written: File too large"));
  EXPECT_FALSE(run.is_summary_written);
  EXPECT_FALSE(fs::exists(path() / "summary.json")) << "the folder must be known to be unfinished";
  EXPECT_LT(run.summary.increments, 5) << "nobody computes what cannot be kept";
  EXPECT_THAT(read("history.csv"), StartsWith(kHistoryHead));
  EXPECT_EQ(read("history.csv").back(), '\n');
}

TEST_F(RecordRun, FullDiskLaterKeepsWholeRowsAndStates) {
  // Grows history.csv past the limit while states stay below it.
  const FileSizeLimit limit(12000);
  const RecordedRun run = record(1000, Outcome::kCompleted);
  EXPECT_EQ(run.exit_code, ExitCode::kEnvironment);
  EXPECT_THAT(run.trouble, HasSubstr("history.csv: cannot be written"));
  const std::string history = read("history.csv");
  EXPECT_EQ(history.back(), '\n');
  EXPECT_GT(std::count(history.begin(), history.end(), '\n'), 50);
  for (const fs::path& state : find_states({path()})) EXPECT_GT(fs::file_size(state), 2000U);
}

TEST_F(RecordRun, RendererFailureKeepsTheResults) {
  FrameSink frames;
  int submitted = 0;
  frames.submit = [&](auto) {
    if (++submitted == 2) throw EnvironmentError("the renderer broke");
  };
  frames.finish = [&]() -> double { throw EnvironmentError("never asked again"); };
  const RecordedRun run = record(6, Outcome::kCompleted, frames);
  EXPECT_EQ(submitted, 2);
  EXPECT_EQ(run.exit_code, ExitCode::kEnvironment);
  EXPECT_EQ(run.trouble, "frames end here: the renderer broke");
  EXPECT_EQ(run.summary.increments, 6);
  EXPECT_TRUE(run.is_summary_written);
}

TEST_F(RecordRun, StopKeepsWhatThereIs) {
  stop_ = true;
  const RecordedRun run = record(6, Outcome::kCompleted);
  EXPECT_EQ(run.exit_code, ExitCode::kInterrupted);
  EXPECT_TRUE(run.is_summary_written);
}

TEST_F(RecordRun, SolverErrorsPassThrough) {
  RunWriter writer(make_result_folder(path(), true), {}, *model_, {});
  Progress progress(log_);
  const auto broken = [](const RunObserver&) -> RunSummary { throw ContractError("x"); };
  EXPECT_THROW(record_run(broken, writer, {}, progress, stop_), ContractError);
  EXPECT_FALSE(fs::exists(path() / "summary.json"));
}

TEST_F(RecordRun, LogNamesWarnings) {
  record(3, Outcome::kCompleted);
  std::rewind(log_);
  std::string text(1000, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), log_));
  EXPECT_THAT(text, HasSubstr("warning (necking): at node 3\n"));
}

TEST(DescribeRun, SaysHowFarItCame) {
  RecordedRun run;
  run.summary = make_summary(Outcome::kUserStop, 3);
  EXPECT_EQ(describe_run(run, 1.0),
            std::string(to_string(Outcome::kUserStop)) +
                ": reached 0.3 s of 1 s in 3 increments, 6 factorisations\nbecause\n1 warnings; see "
                "summary.json\n  r45_mm = 0.142857\n  t_mm = 1.25\n");
}

}  // namespace
}  // namespace hydroscope::test
