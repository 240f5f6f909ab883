// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/replay.h"

#include "solver/base/error.h"

namespace hydroscope {

void check_digests(const JournalHead& written, const JournalHead& now) {
  const auto check = [](const std::string& file, const std::string& was, const std::string& is) {
    if (was != is)
      throw InputError(file + ": has changed since the journal was written: its digest is " + is +
                       ", the journal says " + was);
  };
  check(now.scene, written.scene_digest, now.scene_digest);
  if (written.files.size() != now.files.size())
    throw InputError(now.scene + ": names " + std::to_string(now.files.size()) +
                     " files, the journal's scene " + std::to_string(written.files.size()));
  for (std::size_t i = 0; i < now.files.size(); ++i)
    check(now.files[i].first, written.files[i].second, now.files[i].second);
}

std::vector<SceneOverride> make_overrides(const JournalHead& head) {
  std::vector<SceneOverride> overrides;
  for (const std::string& text : head.overrides) overrides.push_back(make_override(text));
  return overrides;
}

void Replay::run(const std::atomic<bool>& stop) {
  for (const JournalEntry& entry : journal_.entries) {
    if (stop) break;
    repeat(entry, stop);
  }
  while (!stop && steering_.is_running()) advance();  // a journal that was broken off
  steering_.finish();
}

void Replay::repeat(const JournalEntry& entry, const std::atomic<bool>& stop) {
  const bool is_closing = entry.outcome == to_string(Outcome::kUserStop);
  while (!stop && steering_.is_running() &&
         ((entry.is_end() && !is_closing) || steering_.increment() < entry.increment))
    advance();
  if (stop) return;
  if (is_closing) steering_.finish();  // as an act, or because the program ended
  check_place(entry);
  if (entry.is_end()) return;
  try {
    steering_.apply(parse_command(entry.command), entry.who);
  } catch (const InputError& error) {
    fail(entry, "'" + entry.command + "' is refused: " + error.what());
  }
}

void Replay::check_place(const JournalEntry& entry) const {
  if (entry.is_end() && !steering_.has_ended()) fail(entry, "the run has not ended");
  if (steering_.branch() != entry.branch || steering_.increment() != entry.increment)
    fail(entry, "the replay stands at increment " + std::to_string(steering_.increment()) + " of branch " +
                    std::to_string(steering_.branch()));
  if (steering_.state_hash() != entry.state) fail(entry, "the state differs from the one that was");
}

void Replay::advance() {
  steering_.advance();
  if (on_increment) on_increment();
}

void Replay::fail(const JournalEntry& entry, const std::string& what) const {
  steering_.finish();
  throw EnvironmentError("replay: at increment " + std::to_string(entry.increment) + " of branch " +
                         std::to_string(entry.branch) + " (" +
                         (entry.is_end() ? entry.outcome : entry.command) + "): " + what +
                         (journal_.head.version == HYDROSCOPE_VERSION
                              ? "; was the journal written by another build of the program?"
                              : "; the journal was written by version " + journal_.head.version));
}

}  // namespace hydroscope
