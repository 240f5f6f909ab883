// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/chart/study_grid.h"

namespace hydroscope {

/// How a run of a study ended, kept beside its folder so that it is not run again.
struct RunEnd {
  std::string key;          ///< of what it was run with
  int exit_code = 0;        ///< of the program; negative: minus the signal
  double elapsed = 0.0;     ///< [s] from start to end of the process
  double time_limit = 0.0;  ///< [s] that it ran into; 0: it did not
  std::string message;      ///< the program's last words when it failed
};

/// What identifies a run: program, scene and the files that the scene names, settings. The same key,
/// the same result.
std::string calc_run_key(const std::string& program_hash, const std::string& scene_file, const StudyRun& run,
                         int threads);

/// FNV-1a over the bytes of a file, as 16 hexadecimal digits. Throws InputError when it cannot be read.
std::string calc_file_hash(const std::filesystem::path& file);
std::string calc_text_hash(const std::string& text);

/// Nothing when there is none, or it is broken.
std::optional<RunEnd> read_run_end(const std::filesystem::path& file);
void write_run_end(const std::filesystem::path& file, const RunEnd& end);

}  // namespace hydroscope
