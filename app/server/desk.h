// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/results/json.h"
#include "app/server/film_maker.h"
#include "app/server/frame_service.h"
#include "app/server/ledger_cache.h"
#include "app/server/news.h"
#include "app/server/viewers.h"
#include "app/workstation/workstation.h"

namespace hydroscope {

/// All that answers are made of: the workstation, and what looks at it.
struct Desk {
  Desk(Workstation& given, std::vector<std::string> settable_keys, const PicturePainterFactory& painter,
       int most_viewers);

  Workstation& workstation;
  const std::vector<std::string> settable;      ///< keys that `set` may change
  const std::filesystem::path folder;           ///< of the run, branches below it
  const std::shared_ptr<const Snapshot> first;  ///< fixes the camera's box
  Viewers viewers;
  LedgerCache ledger;
  FrameService frames;
  FilmMaker films;

  /// A kept state, one of the last that were shown live, or the newest for none. Null when it is not there.
  std::shared_ptr<const Snapshot> find_state(const std::optional<StateKey>& key) const;
  /// What may have been kept of a branch and of those it came from, in order; find_state() knows.
  std::vector<StateKey> list_line(int branch) const;
  Json make_status(const WorkstationStatus& status, const std::string& viewer) const;
  /// Nobody waits any more.
  void close();

 private:
  struct Shown {
    StateKey key;
    std::shared_ptr<const Snapshot> snapshot;
  };
  /// A new newest state, for pictures; it stays within reach for a while.
  void show(std::shared_ptr<const Snapshot> snapshot, int branch, bool is_solving);

  mutable std::mutex mutex_;
  std::deque<Shown> recent_;  ///< newest last

 public:
  News news;  ///< last: its thread uses the rest
};

}  // namespace hydroscope
