// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check/state_check.h"

#include <algorithm>
#include <chrono>
#include <set>

#include "app/check/frame_comparison.h"
#include "app/check/sidecar_comparison.h"
#include "app/check/state_painter.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

namespace fs = std::filesystem;

class Checker {
 public:
  Checker(const fs::path& folder, const StateSequence& states)
      : folder_(folder), baseline_(read_baseline(folder)), states_(states) {}

  CheckReport run(int rasteriser_threads, const StopRequest& is_stopped);

 private:
  void compare_renderers();
  void compare_frame(const StateFrame& got);
  void compare_picture(const StateFrame& got, const Json& expected_sidecar, const Json& got_sidecar);
  void add(std::vector<Finding> findings) {
    for (Finding& finding : findings) report_.findings.push_back(std::move(finding));
  }
  /// By stage, and within a stage in the order in which they were found.
  void sort_findings();

  fs::path folder_;
  Baseline baseline_;
  const StateSequence& states_;
  PictureRule rule_;
  int told_frame_ = 0;
  std::set<std::string> told_;  ///< differences of that frame
  CheckReport report_;
};

void Checker::compare_renderers() {
  const RendererFingerprint now = calc_renderer_fingerprint(baseline_.options.rasteriser_threads);
  const RendererFingerprint& then = baseline_.fingerprint;
  rule_ = {now.is_same(then), now.has_same_lettering(then)};
  report_.renderer = now.renderer.renderer + ", OpenGL " + now.renderer.version;
  report_.is_same_renderer = rule_.is_same_renderer;
  if (!rule_.is_same_renderer)
    report_.notes.push_back("the baseline was drawn by another renderer (" + then.renderer.renderer +
                            ", probe " + then.probe + " instead of " + now.probe +
                            "): pictures are compared by their structure");
  if (!rule_.has_same_lettering)
    report_.notes.push_back("lettering in '" + now.font + "' instead of '" + then.font +
                            "': text and legends of pictures are left out, their words are compared");
}

void Checker::compare_picture(const StateFrame& got, const Json& expected_sidecar, const Json& got_sidecar) {
  const PngPicture expected = read_baseline_picture(folder_, got.view, got.frame);
  std::vector<PixelBox> lettering = read_lettering(expected_sidecar);
  const std::vector<PixelBox> more = read_lettering(got_sidecar);
  lettering.insert(lettering.end(), more.begin(), more.end());
  const PictureVerdict verdict = compare_pictures(expected.image, got.image, rule_, lettering);
  ++report_.pictures_compared;
  report_.largest_share_off = std::max(report_.largest_share_off, verdict.share_off);
  report_.largest_difference = std::max(report_.largest_difference, verdict.largest_difference);
  report_.least_likeness = std::min(report_.least_likeness, verdict.likeness);
  if (verdict.text.empty()) return;
  report_.findings.push_back({CheckStage::kPixels, got.view, got.frame, verdict.text});
  report_.pictures.push_back({got.view, got.frame, verdict.text, expected.image, got.image});
}

void Checker::compare_frame(const StateFrame& got) {
  if (got.frame > static_cast<int>(baseline_.states.size())) return;  // check_completeness() has said so
  const Json expected = read_baseline_sidecar(folder_, got.view, got.frame);
  const Json sidecar = Json::parse(got.sidecar);
  if (got.frame != told_frame_) told_.clear();
  told_frame_ = got.frame;
  for (const std::string& text : compare_sidecars(expected, sidecar)) {
    // What all views of a frame have in common is told once.
    const bool is_of_view = text.starts_with("range.") || text.starts_with("nodes_without_value");
    if (is_of_view || told_.insert(text).second)
      report_.findings.push_back({CheckStage::kValues, is_of_view ? got.view : "", got.frame, text});
  }
  ++report_.sidecars_compared;
  if (got.has_image) compare_picture(got, expected, sidecar);
}

void Checker::sort_findings() {
  std::stable_sort(report_.findings.begin(), report_.findings.end(),
                   [](const Finding& a, const Finding& b) { return a.stage < b.stage; });
}

CheckReport Checker::run(int rasteriser_threads, const StopRequest& is_stopped) {
  const auto start = std::chrono::steady_clock::now();
  add(check_order(states_.stamps()));
  add(check_completeness(baseline_.states, states_.stamps()));
  baseline_.options.rasteriser_threads = rasteriser_threads;
  compare_renderers();
  report_.frames = static_cast<int>(states_.size());
  StatePainting painting;
  painting.options = baseline_.options;
  painting.expected_frames = static_cast<int>(baseline_.states.size());
  painting.wants_picture = [this](int frame) { return baseline_.has_picture(frame); };
  painting.on_frame = [this](const StateFrame& got) { compare_frame(got); };
  painting.on_state = [this](int frame, const Snapshot& snapshot, const ClassAgreement& agreement) {
    add(check_balance(snapshot, frame));
    add(check_classes(agreement, frame));
    ++report_.class_passes;
    if (agreement.unseen > 0)
      report_.notes.push_back("frame " + std::to_string(frame) + ": " + std::to_string(agreement.unseen) +
                              " of " + std::to_string(agreement.nodes) + " nodes are hidden by other walls");
  };
  painting.is_stopped = is_stopped;
  paint_states(states_, painting);
  sort_findings();
  report_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::move(report_);
}

}  // namespace

CheckReport check_states(const StateSequence& states, const fs::path& baseline_folder, int rasteriser_threads,
                         const StopRequest& is_stopped) {
  return Checker(baseline_folder, states).run(rasteriser_threads, is_stopped);
}

Baseline renew_baseline(const StateSequence& states, const FrameOptions& options, int most_pictures,
                        const fs::path& folder) {
  Baseline baseline;
  baseline.options = options;
  baseline.fingerprint = calc_renderer_fingerprint(options.rasteriser_threads);
  baseline.states = states.stamps();
  baseline.pictures = pick_pictures(static_cast<int>(states.size()), most_pictures);
  for (const std::string& view : options.views) make_folder(folder / view);
  StatePainting painting;
  painting.options = options;
  painting.expected_frames = static_cast<int>(states.size());
  painting.wants_picture = [&baseline](int frame) { return baseline.has_picture(frame); };
  painting.on_frame = [&folder](const StateFrame& made) {
    const std::string name = make_baseline_name(folder, made.view, made.frame).string();
    write_whole_file(name + ".json", made.sidecar);
    if (made.has_image) write_png(name + ".png", made.image, made.texts, PngSize::kSmall);
  };
  paint_states(states, painting);
  write_baseline(baseline, folder);
  return baseline;
}

}  // namespace hydroscope
