// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/check/state_check.h"
#include "render/draw_list.h"
#include "render/image/pixel_box.h"
#include "tests/render/synthetic.h"
#include "tests/temporary_folder.h"

namespace hydroscope::test {

/// A short sequence of states on disk, and its baseline: made once for all tests.
class SampleSequence {
 public:
  SampleSequence();

  static constexpr int kStates = 3;
  const std::shared_ptr<const SnapshotModel>& model() const { return model_; }
  const std::vector<std::shared_ptr<const Snapshot>>& states() const { return states_; }
  std::filesystem::path results() const { return folder_.path() / "run"; }
  std::filesystem::path baseline() const { return folder_.path() / "baseline"; }
  FrameOptions options() const;

 private:
  TemporaryFolder folder_;
  std::shared_ptr<const SnapshotModel> model_;
  std::vector<std::shared_ptr<const Snapshot>> states_;
};

const SampleSequence& sample_sequence();

/// Forces that add up, with what the solver would say of tools and supports.
void balance_forces(Snapshot& snapshot);

/// Writes model and states as a run would.
void write_run(const SnapshotModel& model, const std::vector<Snapshot>& states,
               const std::filesystem::path& folder);

/// A node of the flat that faces the camera, in the middle of nodes that stick.
constexpr int kAround = 16, kAlong = 16;
constexpr std::size_t find_node(int along, int around) {
  return static_cast<std::size_t>(along * (kAround + 1) + around);
}

/// The copied states, changed, checked against the baseline.
CheckReport check_changed(const std::function<void(SnapshotModel&, std::vector<Snapshot>&)>& change);

struct Drawn {
  Image image;
  std::vector<PixelBox> lettering;
};

/// Picture of a view whose draw list is changed on its way to the renderer: what a fault
/// there would show, while all numbers stay right.
Drawn paint_changed(const std::string& view, const Snapshot& snapshot,
                    const std::function<void(DrawList&, CameraPose&)>& change = {},
                    const std::string& time_label = "");

}  // namespace hydroscope::test
