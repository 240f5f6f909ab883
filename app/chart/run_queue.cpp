// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/run_queue.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <sstream>
#include <thread>

#include "app/chart/child_process.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kGrace = 10.0;  ///< [s] for a run to end when it is asked to

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Active {
  const StudyJob* job = nullptr;
  std::unique_ptr<ChildProcess> process{};
  Clock::time_point start = Clock::now();
  bool is_late = false;
};

fs::path log_file(const StudyJob& job) { return job.folder.string() + ".log"; }

Active start(const StudyJob& job, const QueueOptions& options) {
  std::error_code ignored;
  fs::remove(record_file(job), ignored);
  std::vector<std::string> command = {options.program,
                                      "run",
                                      job.one->scene,
                                      "--no-frames",
                                      "--force",
                                      "--threads",
                                      std::to_string(job.threads),
                                      "-o",
                                      job.folder.string()};
  for (const SceneOverride& item : job.run.overrides) {
    command.push_back("--set");
    command.push_back(item.key + "=" + item.value);
  }
  return {&job, std::make_unique<ChildProcess>(command, log_file(job))};
}

/// The line that begins with "error", or else the last one.
std::string find_last_words(const fs::path& log) {
  std::error_code error;
  if (!fs::exists(log, error)) return {};
  std::istringstream text(read_whole_file(log));
  std::string last, said;
  for (std::string line; std::getline(text, line);) {
    if (!line.empty()) last = line;
    if (line.find("error") != std::string::npos && said.empty()) said = line;
  }
  return said.empty() ? last : said;
}

void finish(const Active& active) {
  RunEnd end;
  end.key = active.job->key;
  end.exit_code = active.process->exit_code();
  end.elapsed = seconds_since(active.start);
  if (active.is_late) end.time_limit = active.job->time_limit;
  if (end.exit_code != 0) end.message = find_last_words(log_file(*active.job));
  write_run_end(record_file(*active.job), end);
}

void stop_all(std::vector<Active>& active) {
  for (Active& one : active) one.process->stop(false);
  const auto since = Clock::now();
  const auto is_any_left = [&] {
    return std::any_of(active.begin(), active.end(), [](Active& one) { return !one.process->has_ended(); });
  };
  while (is_any_left() && seconds_since(since) < kGrace)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

}  // namespace

fs::path record_file(const StudyJob& job) { return job.folder.string() + ".json"; }

bool is_done(const StudyJob& job) {
  const auto end = read_run_end(record_file(job));
  return end && end->key == job.key && (end->time_limit == 0.0 || end->time_limit >= job.time_limit);
}

bool run_jobs(const std::vector<StudyJob>& jobs, const QueueOptions& options, StudyProgress& progress,
              const std::atomic<bool>& stop) {
  std::vector<const StudyJob*> waiting;
  for (const StudyJob& job : jobs)
    if (!is_done(job)) waiting.push_back(&job);
  std::reverse(waiting.begin(), waiting.end());
  std::vector<Active> active;
  while (!waiting.empty() || !active.empty()) {
    if (stop) {
      stop_all(active);
      return false;
    }
    while (!waiting.empty() && static_cast<int>(active.size()) < options.jobs) {
      fs::create_directories(waiting.back()->folder.parent_path());
      active.push_back(start(*waiting.back(), options));
      waiting.pop_back();
    }
    for (Active& one : active) {
      const double elapsed = seconds_since(one.start);
      if (elapsed > one.job->time_limit && !one.is_late) {
        one.is_late = true;
        one.process->stop(false);
      }
      if (elapsed > one.job->time_limit + kGrace) one.process->stop(true);
      if (!one.process->has_ended()) continue;
      // Somebody else ended it, as at the end of a session: not a result.
      const bool is_cut_off =
          !one.is_late && (one.process->exit_code() == 130 || one.process->exit_code() == -15);
      if (!is_cut_off) finish(one);
      progress.add_done(one.process->exit_code() == 0 || one.process->exit_code() == 3);
    }
    std::erase_if(active, [](Active& one) { return one.process->has_ended(); });
    progress.show(static_cast<int>(active.size()),
                  active.empty() ? "" : active.back().job->one->name + "/" + active.back().job->run.id);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

}  // namespace hydroscope
