// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/check/finding.h"
#include "app/results/result_folder.h"
#include "solver/snapshot/snapshot.h"

namespace hydroscope {

/// One saved state, as far as its place in the sequence goes.
struct StateStamp {
  int number = 0;  ///< of its file, from 0
  int increment = 0;
  double time = 0.0;  ///< [s]

  bool operator==(const StateStamp&) const = default;
};

/// The saved states of a run, read one at a time.
class StateSequence {
 public:
  /// `place`: a run's folder, or its folder `states`. Throws InputError when there
  /// are no states or the model cannot be read.
  explicit StateSequence(const std::filesystem::path& place);

  const ResultFolder& folder() const { return folder_; }
  const std::vector<StateStamp>& stamps() const { return stamps_; }
  std::size_t size() const { return files_.size(); }
  std::shared_ptr<const Snapshot> read(std::size_t index) const;

 private:
  ResultFolder folder_;
  std::vector<std::filesystem::path> files_;
  std::shared_ptr<const SnapshotModel> model_;
  std::vector<StateStamp> stamps_;
};

/// Numbers without holes from 0, increments and times that rise.
std::vector<Finding> check_order(const std::vector<StateStamp>& got);

/// As many states as before, and none that is missing or new by its increment.
std::vector<Finding> check_completeness(const std::vector<StateStamp>& expected,
                                        const std::vector<StateStamp>& got);

}  // namespace hydroscope
