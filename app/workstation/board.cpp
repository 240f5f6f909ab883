// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workstation/board.h"

#include <algorithm>

#include "app/results/state_file.h"
#include "solver/base/error.h"

namespace hydroscope {

namespace {

constexpr std::size_t kCached = 24;  // states read back from disk that stay in memory

}  // namespace

void Board::note_change() {
  ++status_.version;
  changed_.notify_all();
}

void Board::update(const std::function<void(WorkstationStatus&)>& change) {
  const std::lock_guard lock(mutex_);
  change(status_);
  note_change();
}

void Board::set_model(std::shared_ptr<const SnapshotModel> model, std::vector<std::string> quantity_names) {
  const std::lock_guard lock(mutex_);
  model_ = std::move(model);
  quantity_names_ = std::move(quantity_names);
}

void Board::set_settable(std::vector<std::string> keys) {
  const std::lock_guard lock(mutex_);
  settable_ = std::move(keys);
}

int Board::add_branch(int parent, int increment, const std::filesystem::path& folder) {
  const std::lock_guard lock(mutex_);
  BranchRecord branch;
  if (parent >= 0) branch = branches_[static_cast<std::size_t>(parent)];
  branch.parent = parent;
  branch.from = increment;
  branch.folder = folder;
  const auto is_later = [increment](const auto& item) { return item.increment > increment; };
  std::erase_if(branch.rows, is_later);
  std::erase_if(branch.events, is_later);
  std::erase_if(branch.warnings, is_later);
  branches_.push_back(std::move(branch));
  status_.branch = static_cast<int>(branches_.size()) - 1;
  status_.n_events = static_cast<int>(present().events.size());
  status_.n_warnings = static_cast<int>(present().warnings.size());
  note_change();
  return status_.branch;
}

void Board::set_parent(int branch, int parent, int increment) {
  const std::lock_guard lock(mutex_);
  BranchRecord& record = branches_.at(static_cast<std::size_t>(branch));
  record.parent = parent;
  record.from = increment;
}

void Board::add_increment(const IncrementReport& report) {
  IncrementReport row = report;
  row.events.clear();
  const std::lock_guard lock(mutex_);
  present().rows.push_back(std::move(row));
}

void Board::add_events(const std::vector<ContactEvent>& events) {
  const std::lock_guard lock(mutex_);
  present().events.insert(present().events.end(), events.begin(), events.end());
  status_.n_events = static_cast<int>(present().events.size());
}

void Board::add_warnings(const std::vector<Warning>& warnings) {
  const std::lock_guard lock(mutex_);
  present().warnings.insert(present().warnings.end(), warnings.begin(), warnings.end());
  status_.n_warnings = static_cast<int>(present().warnings.size());
}

void Board::set_newest(std::shared_ptr<const Snapshot> snapshot) {
  const std::lock_guard lock(mutex_);
  newest_ = std::move(snapshot);
}

void Board::add_kept(const KeptState& state, const std::filesystem::path& file) {
  const std::lock_guard lock(mutex_);
  kept_.push_back({state, file});
  status_.n_kept = static_cast<int>(kept_.size());
  note_change();
}

void Board::set_restorable(int branch, int increment, bool can_restore) {
  const std::lock_guard lock(mutex_);
  for (Kept& kept : kept_) {
    if (kept.state.branch == branch && kept.state.increment == increment)
      kept.state.can_restore = can_restore;
  }
  note_change();
}

WorkstationStatus Board::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

WorkstationStatus Board::wait(const std::function<bool(const WorkstationStatus&)>& is_done,
                              std::chrono::milliseconds patience) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [&] { return is_done(status_); });
  return status_;
}

std::shared_ptr<const Snapshot> Board::newest() const {
  const std::lock_guard lock(mutex_);
  return newest_;
}

const Board::Kept* Board::find_kept(int branch, int increment) const {
  for (int b = branch; b >= 0 && b < static_cast<int>(branches_.size());) {
    for (const Kept& kept : kept_) {
      if (kept.state.branch == b && kept.state.increment == increment) return &kept;
    }
    const BranchRecord& record = branches_[static_cast<std::size_t>(b)];
    if (increment > record.from) return nullptr;  // what the parent did later is not this branch's
    b = record.parent;
  }
  return nullptr;
}

std::shared_ptr<const Snapshot> Board::kept(int branch, int increment) const {
  std::filesystem::path file;
  std::shared_ptr<const SnapshotModel> model;
  {
    const std::lock_guard lock(mutex_);
    const Kept* found = find_kept(branch, increment);
    if (found == nullptr) return nullptr;
    for (const Cached& cached : cache_) {
      if (cached.file == found->file) return cached.snapshot;
    }
    file = found->file;
    model = model_;
  }
  std::shared_ptr<const Snapshot> snapshot;
  try {
    snapshot = read_state(file, model);
  } catch (const InputError&) {  // removed or damaged since: there is none to look at
    return nullptr;
  }
  const std::lock_guard lock(mutex_);
  if (cache_.size() >= kCached) cache_.erase(cache_.begin());
  cache_.push_back({file, snapshot});
  return snapshot;
}

std::vector<KeptState> Board::kept_states() const {
  const std::lock_guard lock(mutex_);
  std::vector<KeptState> states;
  for (const Kept& kept : kept_) states.push_back(kept.state);
  return states;
}

std::vector<IncrementReport> Board::history(int from) const {
  const std::lock_guard lock(mutex_);
  const auto& rows = present().rows;
  const auto first = std::lower_bound(rows.begin(), rows.end(), from,
                                      [](const IncrementReport& row, int i) { return row.increment < i; });
  return {first, rows.end()};
}

std::vector<std::string> Board::quantity_names() const {
  const std::lock_guard lock(mutex_);
  return quantity_names_;
}

std::vector<std::string> Board::settable() const {
  const std::lock_guard lock(mutex_);
  return settable_;
}

std::vector<ContactEvent> Board::events(std::size_t from) const {
  const std::lock_guard lock(mutex_);
  const auto& events = present().events;
  return {events.begin() + static_cast<std::ptrdiff_t>(std::min(from, events.size())), events.end()};
}

std::vector<Warning> Board::warnings() const {
  const std::lock_guard lock(mutex_);
  return present().warnings;
}

BranchRecord Board::branch(int number) const {
  const std::lock_guard lock(mutex_);
  return branches_.at(static_cast<std::size_t>(number));
}

std::filesystem::path Board::folder() const {
  const std::lock_guard lock(mutex_);
  return present().folder;
}

}  // namespace hydroscope
