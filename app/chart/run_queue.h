// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "app/chart/run_record.h"
#include "app/chart/study_progress.h"

namespace hydroscope {

/// One process to be run: a run of the grid, or one of its timed repeats.
struct StudyJob {
  const StudyCase* one = nullptr;
  StudyRun run;
  int repeat = 0;  ///< 0: for accuracy; 1, 2, ...: timed
  int threads = 1;
  std::filesystem::path folder;  ///< of the results; the record is FOLDER.json, the log FOLDER.log
  std::string key;
  double time_limit = 600.0;  ///< [s]
};

struct QueueOptions {
  std::string program;  ///< what is started: this program itself
  int jobs = 1;
};

std::filesystem::path record_file(const StudyJob& job);

/// Whether the job has been done with the same key. A run that met a shorter time limit is done again.
bool is_done(const StudyJob& job);

/// Runs what is not done, up to `jobs` at a time, in the order given. Returns false when `stop` was
/// raised: the runs under way are ended and will be run again. Throws EnvironmentError.
bool run_jobs(const std::vector<StudyJob>& jobs, const QueueOptions& options, StudyProgress& progress,
              const std::atomic<bool>& stop);

}  // namespace hydroscope
