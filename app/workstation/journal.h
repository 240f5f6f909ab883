// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "solver/base/whole_file.h"
#include "solver/scene/scene.h"

namespace hydroscope {

/// The first line of a journal: what the run was started with.
struct JournalHead {
  std::string version;                                     ///< of the program
  std::string scene;                                       ///< file, as named by the user
  std::string scene_digest;                                ///< of its text
  std::vector<std::pair<std::string, std::string>> files;  ///< named by the scene, and their digests
  std::vector<std::string> overrides;                      ///< "key=value", in order
  int threads = 1;
  std::string started;  ///< wall clock, UTC
};

/// A further line: an act that took effect, or how a branch ended.
struct JournalEntry {
  int branch = 0, increment = 0;  ///< where it took effect: between this increment and the next
  double time = 0.0;              ///< process time [s]
  std::string who, command;       ///< of an act
  std::string outcome, message;   ///< of an end; empty: an act
  std::uint64_t state = 0;        ///< calc_hash() of the state it met
  std::string at;                 ///< wall clock, UTC

  bool is_end() const { return !outcome.empty(); }
};

struct JournalContents {
  JournalHead head;
  std::vector<JournalEntry> entries;
  std::string trouble;  ///< what is wrong with its last line; empty: nothing
};

/// Writes `journal.jsonl`, line by line: what is there survives the end of the program at any moment.
class Journal {
 public:
  /// Throws EnvironmentError, as add() does.
  Journal(const std::filesystem::path& path, const JournalHead& head);
  void add(JournalEntry entry);

 private:
  LineFile file_;
};

/// Reads a journal; a broken last line is left out and noted. Throws InputError with file and line.
JournalContents read_journal(const std::filesystem::path& path);

/// Digest of a text, 16 hexadecimal digits (64-bit FNV-1a).
std::string make_digest(const std::string& text);
/// Digests of the scene's text and of all files that it names.
JournalHead make_journal_head(const Scene& scene, const std::string& text);

}  // namespace hydroscope
