// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/study_runner.h"

#include <algorithm>
#include <cstdlib>

#include "app/chart/child_process.h"
#include "app/chart/study_charts.h"
#include "render/image/png_file.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

namespace fs = std::filesystem;

StudyJob make_job(const Study& study, const StudyCase& one, const StudyRun& run, int repeat,
                  const StudyOptions& options, const std::string& program_hash) {
  const int threads = repeat > 0 ? study.threads : 1;
  StudyJob job{&one, run, repeat, threads, options.output / "runs" / one.name / run.id, {}};
  if (repeat > 0) job.folder += ".t" + std::to_string(repeat);
  job.time_limit = run.is_finest ? study.finest_time_limit : study.time_limit;
  job.key = calc_run_key(program_hash, one.scene, run, threads);
  return job;
}

std::vector<StudyJob> make_accuracy_jobs(const Study& study, const StudyOptions& options,
                                         const std::string& hash) {
  std::vector<StudyJob> jobs;
  for (const StudyCase& one : study.cases)
    for (const StudyRun& run : make_study_runs(one))
      jobs.push_back(make_job(study, one, run, 0, options, hash));
  // The finest runs take longest: first, so that nobody waits for them at the end.
  std::stable_partition(jobs.begin(), jobs.end(), [](const StudyJob& job) { return job.run.is_finest; });
  return jobs;
}

/// Interleaved: all runs of a case once, then again. What failed is not timed, what takes long once.
std::vector<StudyJob> make_timed_jobs(const Study& study, const std::vector<CaseResult>& results,
                                      const StudyOptions& options, const std::string& hash) {
  std::vector<StudyJob> jobs;
  for (const CaseResult& result : results)
    for (int repeat = 1; repeat <= study.repeats && result.one->is_timed; ++repeat)
      for (const RunResult& run : result.runs)
        if (!run.is_failed() && (repeat == 1 || run.own_wall < study.timed_once_from))
          jobs.push_back(make_job(study, *result.one, run.run, repeat, options, hash));
  return jobs;
}

bool run_all(const std::vector<StudyJob>& jobs, const QueueOptions& options, const char* what,
             const std::atomic<bool>& stop) {
  const auto is_waiting = [&](const StudyJob& job) { return !is_done(job); };
  const auto waiting = static_cast<int>(std::count_if(jobs.begin(), jobs.end(), is_waiting));
  std::fprintf(stderr, "%s: %d runs, %d of them done before, %d at a time\n", what,
               static_cast<int>(jobs.size()), static_cast<int>(jobs.size()) - waiting, options.jobs);
  StudyProgress progress(stderr, waiting);
  const bool is_whole = run_jobs(jobs, options, progress, stop);
  progress.finish();
  return is_whole;
}

/// The revision of the sources that the study lies in, if git knows one.
std::string find_revision(const fs::path& study_file, const fs::path& output) {
  const fs::path note = output / "runs" / ".revision";
  fs::create_directories(note.parent_path());
  const fs::path folder = fs::absolute(study_file).parent_path();
  ChildProcess git({"git", "-C", folder.string(), "describe", "--always", "--dirty", "--tags"}, note);
  while (!git.has_ended()) continue;
  std::string text = git.exit_code() == 0 ? read_whole_file(note) : "";
  std::erase(text, '\n');
  std::error_code ignored;
  fs::remove(note, ignored);
  return text;
}

}  // namespace

bool run_study(const Study& study, const StudyOptions& options, const std::atomic<bool>& stop) {
  const std::string hash = calc_file_hash(options.program);
  QueueOptions queue{options.program, options.jobs};
  if (!run_all(make_accuracy_jobs(study, options, hash), queue, "accuracy", stop)) return false;
  const auto timed = make_timed_jobs(study, read_study_results(study, options), options, hash);
  queue.jobs = 1;
  return timed.empty() || run_all(timed, queue, "timing", stop);
}

std::vector<CaseResult> read_study_results(const Study& study, const StudyOptions& options) {
  const std::string hash = calc_file_hash(options.program);
  std::vector<CaseResult> results;
  for (const StudyCase& one : study.cases) {
    CaseResult result{.one = &one};
    for (const StudyRun& run : make_study_runs(one)) {
      const StudyJob job = make_job(study, one, run, 0, options, hash);
      auto end = read_run_end(record_file(job));
      if (end && end->key != job.key && !options.takes_any) end.reset();  // of other settings: not this run's
      RunResult read = read_run_result(one, run, job.folder, end);
      for (int repeat = 1; repeat <= study.repeats && one.is_timed && !run.is_finest; ++repeat) {
        const StudyJob timed = make_job(study, one, run, repeat, options, hash);
        const auto timed_end = read_run_end(record_file(timed));
        if (!timed_end || (timed_end->key != timed.key && !options.takes_any)) continue;
        const double wall = read_solving_time(timed.folder);
        if (wall > 0.0) read.walls.push_back(wall);
      }
      if (run.is_finest)
        result.finest = std::move(read);
      else
        result.runs.push_back(std::move(read));
    }
    compare_case(result);
    results.push_back(std::move(result));
  }
  return results;
}

void write_study(const Study& study, const std::vector<CaseResult>& results, const StudyOptions& options) {
  LineChartPainter painter({.size = options.size, .theme = options.theme});
  const auto write_chart = [&](const StudyChart& chart) {
    const fs::path stem = options.output / chart.name;
    write_png(stem.string() + ".png", painter.draw(chart.chart),
              {{"Renderer", painter.renderer()}, {"Software", "Hydroscope " HYDROSCOPE_VERSION}},
              PngSize::kSmall);
    write_whole_file(stem.string() + ".csv", make_chart_csv(chart.chart));
    return chart.name;
  };
  std::vector<ReportedCase> cases;
  for (const CaseResult& result : results) {
    ReportedCase reported{&result, {}};
    for (const StudyChart& chart : make_case_charts(result)) reported.charts.push_back(write_chart(chart));
    write_whole_file(options.output / (result.one->name + "-runs.csv"), make_case_csv(result));
    write_whole_file(options.output / (result.one->name + "-values.csv"), make_values_csv(result));
    cases.push_back(std::move(reported));
  }
  std::vector<std::string> plots;
  for (const StudyPlot& plot : study.plots) plots.push_back(write_chart(make_plot_chart(plot)));
  const ReportFacts facts{
      find_machine(), HYDROSCOPE_VERSION,
      calc_file_hash(options.program) + (options.takes_any ? "; drawn again, runs as they were found" : ""),
      find_revision(study.file, options.output), painter.renderer()};
  write_whole_file(options.output / "report.md", make_study_report(study, cases, plots, facts));
  write_whole_file(options.output / "study.toml", read_whole_file(study.file));
}

}  // namespace hydroscope
