// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/check/sample_sequence.h"

#include "app/check/state_painter.h"
#include "app/results/state_file.h"
#include "render/camera.h"
#include "render/overlay.h"
#include "render/stage.h"
#include "render/view_text.h"
#include "render/views.h"

namespace hydroscope::test {

void balance_forces(Snapshot& s) {
  Vec3 contact = Vec3::Zero();
  for (const Vec3& force : s.contact_force) contact += force;
  s.tool_force.assign(s.model->tools.size(), Vec3::Zero());
  if (!s.tool_force.empty()) s.tool_force[0] = contact;
  s.support_force.assign(s.points.size(), Vec3::Zero());
  s.support_force[0] = -contact;
  for (const auto& quad : s.model->quads) {
    const auto x = [&](std::size_t k) { return s.points[static_cast<std::size_t>(quad[k])]; };
    s.support_force[0] -= 0.5 * s.pressure * (x(2) - x(0)).cross(x(3) - x(1));
  }
}

void write_run(const SnapshotModel& model, const std::vector<Snapshot>& states,
               const std::filesystem::path& folder) {
  const ResultFolder results{folder};
  std::filesystem::create_directories(results.states());
  write_model(model, folder);
  for (std::size_t i = 0; i < states.size(); ++i)
    write_state(states[i], folder / ResultFolder::state_name(static_cast<int>(i)));
}

FrameOptions SampleSequence::options() const {
  FrameOptions options;
  options.views = {"contact-map", "tool-normals", "slip", "thickness"};
  options.size = {480, 270};
  options.most_arrows = 400;
  return options;
}

SampleSequence::SampleSequence() {
  const SyntheticBulge bulge{.around = kAround, .along = kAlong};
  model_ = bulge.make_model();
  std::vector<Snapshot> written;
  for (int i = 0; i < kStates; ++i) {
    const auto state = bulge.make_snapshot(model_, 0.4 + 0.25 * i, 10 * i);
    balance_forces(*state);
    states_.push_back(state);
    written.push_back(*state);
  }
  write_run(*model_, written, results());
  renew_baseline(StateSequence(results()), options(), kStates, baseline());
}

const SampleSequence& sample_sequence() {
  static const SampleSequence sequence;
  return sequence;
}

CheckReport check_changed(const std::function<void(SnapshotModel&, std::vector<Snapshot>&)>& change) {
  const SampleSequence& sample = sample_sequence();
  auto model = std::make_shared<SnapshotModel>(*sample.model());
  std::vector<Snapshot> states;
  for (const auto& state : sample.states()) {
    states.push_back(*state);
    states.back().model = model;
  }
  change(*model, states);
  const TemporaryFolder folder;
  write_run(*model, states, folder.path());
  return check_states(StateSequence(folder.path()), sample.baseline(), 1);
}

Drawn paint_changed(const std::string& view, const Snapshot& snapshot,
                    const std::function<void(DrawList&, CameraPose&)>& change,
                    const std::string& time_label) {
  const SampleSequence& sample = sample_sequence();
  const FrameOptions options = sample.options();
  static const std::map<std::string, Range> ranges = calc_ranges(StateSequence(sample.results()), options);
  static Stage stage({.width = options.size[0], .height = options.size[1], .smoothing = options.smoothing});
  Snapshot first = *sample.states().front();
  first.model = snapshot.model;
  Views views(first, options);
  CameraPose camera = calc_camera(options, views.bounds(), std::nullopt, 0, 1);
  DrawList list = views.make_draw_list(view, snapshot, camera, ranges);
  if (change) change(list, camera);
  const Theme& colours = theme(options.theme);
  Drawn drawn{stage.draw(list, camera, colours), {}};
  drawn.lettering =
      draw_overlay(drawn.image, list.legend, snapshot.model->title,
                   time_label.empty() ? make_time_label(snapshot) : time_label, camera, colours);
  return drawn;
}

}  // namespace hydroscope::test
