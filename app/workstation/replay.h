// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>

#include "app/workstation/journal.h"
#include "app/workstation/steering.h"

namespace hydroscope {

/// Checks that scene and files are still those of the journal. Throws InputError naming both digests.
void check_digests(const JournalHead& written, const JournalHead& now);

/// The overrides that a journal's run began with.
std::vector<SceneOverride> make_overrides(const JournalHead& head);

/// Repeats all acts of a journal on a run that stands at its start: the same states come out, bit for bit,
/// which is checked at each line. A journal without an end goes on as its last act has left it.
/// Throws EnvironmentError where the run comes to another state than the journal's.
class Replay {
 public:
  Replay(const JournalContents& journal, Steering& steering) : journal_(journal), steering_(steering) {}
  /// Called after each increment.
  std::function<void()> on_increment;
  /// Ends early, with all written, once the flag is up.
  void run(const std::atomic<bool>& stop);

 private:
  void repeat(const JournalEntry& entry, const std::atomic<bool>& stop);
  void check_place(const JournalEntry& entry) const;
  void advance();
  [[noreturn]] void fail(const JournalEntry& entry, const std::string& what) const;

  const JournalContents& journal_;
  Steering& steering_;
};

}  // namespace hydroscope
