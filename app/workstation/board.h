// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

#include "app/workstation/workstation.h"

namespace hydroscope {

/// What is known of one branch of an analysis, from increment 0 on.
struct BranchRecord {
  int parent = -1, from = 0;     ///< it begins at this increment of that branch
  std::filesystem::path folder;  ///< results of its own
  std::vector<IncrementReport> rows;
  std::vector<ContactEvent> events;
  std::vector<Warning> warnings;
};

/// Where one thread writes how an analysis gets on and all others read. Its lock is held for copying only.
class Board {
 public:
  // For the thread that computes.
  /// Changes the status; its version grows and who waits is woken.
  void update(const std::function<void(WorkstationStatus&)>& change);
  void set_settable(std::vector<std::string> keys);
  void set_model(std::shared_ptr<const SnapshotModel> model, std::vector<std::string> quantity_names);
  /// Makes a branch that goes on from `increment` of `parent` (-1: the first) the present one.
  int add_branch(int parent, int increment, const std::filesystem::path& folder);
  /// Where a branch whose tables come from disk began.
  void set_parent(int branch, int parent, int increment);
  void add_increment(const IncrementReport& report);
  void add_events(const std::vector<ContactEvent>& events);
  void add_warnings(const std::vector<Warning>& warnings);
  void set_newest(std::shared_ptr<const Snapshot> snapshot);
  /// `file`: where the state lies on disk.
  void add_kept(const KeptState& state, const std::filesystem::path& file);
  void set_restorable(int branch, int increment, bool can_restore);

  // For everybody.
  WorkstationStatus status() const;
  WorkstationStatus wait(const std::function<bool(const WorkstationStatus&)>& is_done,
                         std::chrono::milliseconds patience) const;
  std::shared_ptr<const Snapshot> newest() const;
  /// Of this branch, or of the ones that it came from up to where it left them; read from disk.
  std::shared_ptr<const Snapshot> kept(int branch, int increment) const;
  std::vector<KeptState> kept_states() const;
  std::vector<IncrementReport> history(int from) const;
  std::vector<std::string> quantity_names() const;
  std::vector<std::string> settable() const;
  std::vector<ContactEvent> events(std::size_t from) const;
  std::vector<Warning> warnings() const;
  BranchRecord branch(int number) const;
  std::filesystem::path folder() const;

 private:
  struct Kept {
    KeptState state;
    std::filesystem::path file;
  };
  struct Cached {
    std::filesystem::path file;
    std::shared_ptr<const Snapshot> snapshot;
  };
  const BranchRecord& present() const { return branches_[static_cast<std::size_t>(status_.branch)]; }
  BranchRecord& present() { return branches_[static_cast<std::size_t>(status_.branch)]; }
  /// The caller holds the lock.
  const Kept* find_kept(int branch, int increment) const;
  void note_change();

  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  WorkstationStatus status_;
  std::shared_ptr<const SnapshotModel> model_;
  std::vector<std::string> quantity_names_, settable_;
  std::vector<BranchRecord> branches_;
  std::vector<Kept> kept_;
  std::shared_ptr<const Snapshot> newest_;
  mutable std::vector<Cached> cache_;  ///< read last, newest behind
};

}  // namespace hydroscope
