// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/follow/follow_detachment.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "app/follow/chart_column.h"
#include "app/follow/close_up.h"
#include "app/results/json.h"
#include "app/results/state_file.h"
#include "render/camera.h"
#include "render/frame_files.h"
#include "render/frame_painter.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

namespace fs = std::filesystem;

constexpr double kViewWidth = 0.6;  // of the frame; the charts have the rest

std::string name_sequence(int patch) { return "detachment-" + std::to_string(patch); }

void remove_earlier(const ResultFolder& folder, const std::vector<int>& patches, bool all) {
  std::vector<std::string> names;
  for (const int patch : patches) names.push_back(name_sequence(patch));
  std::error_code error;
  const std::regex pattern(R"(detachment-\d+)");
  if (all)
    for (const auto& entry : fs::directory_iterator(folder.frames(), error))
      if (std::regex_match(entry.path().filename().string(), pattern))
        names.push_back(entry.path().filename().string());
  remove_frames(folder, names);
  for (const std::string& name : names) fs::remove(folder.frames() / name, error);  // only when empty
}

/// The state that the camera is aimed by: the last one before the letting go; else the first.
std::size_t find_aim(const std::vector<PatchFrame>& frames) {
  std::size_t state = frames.front().state;
  for (const PatchFrame& frame : frames)
    if (frame.phase == Phase::kBefore) state = frame.state;
  return state;
}

Json::Array make_list(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// Draws one patch after the other.
class Follower {
 public:
  Follower(const ResultFolder& folder, const Ledger& ledger, const FollowOptions& options, int total)
      : folder_(folder),
        ledger_(ledger),
        options_(options),
        files_(find_states(folder)),
        model_(read_model(folder.path, files_.front())),
        view_width_(static_cast<int>(std::lround(kViewWidth * options.frames.size[0]))),
        total_(total) {}

  FollowedPatch draw(int number);

 private:
  struct Shot {
    const Patch& patch;
    int number;
    std::vector<int> nodes, charted;
    std::vector<PatchFrame> frames;
    std::vector<NodeStory> stories;
    std::map<std::string, Range> ranges;
  };
  std::shared_ptr<const Snapshot> read(std::size_t state) const {
    return read_state(files_.at(state), model_);
  }
  Shot make_shot(int number) const;
  FrameOptions make_options(const Shot& shot, const Snapshot& before,
                            std::shared_ptr<const SnapshotModel>& cropped) const;
  std::string extend_sidecar(const Shot& shot, const PatchFrame& frame, const std::string& sidecar) const;
  ChartColumn make_charts(const Shot& shot) const;

  ResultFolder folder_;
  const Ledger& ledger_;
  const FollowOptions& options_;
  std::vector<fs::path> files_;
  std::shared_ptr<const SnapshotModel> model_;
  int view_width_;
  int done_ = 0, total_;
};

Follower::Shot Follower::make_shot(int number) const {
  const Patch& patch = ledger_.patches[static_cast<std::size_t>(number - 1)];
  Shot shot{patch, number, find_patch_nodes(ledger_, patch), options_.nodes, {}, {}, {}};
  if (shot.charted.empty()) shot.charted = {find_most_pulled(ledger_, patch)};
  shot.frames = find_patch_frames(ledger_, patch, options_.around);
  for (const int node : shot.charted) shot.stories.push_back(make_node_story(ledger_, node));
  for (const std::string& name : range_names(options_.frames.views.front())) {
    Range all{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const PatchFrame& frame : shot.frames) {
      const Range range = calc_range(name, *read(frame.state));
      all = {std::min(all.low, range.low), std::max(all.high, range.high)};
    }
    shot.ranges[name] = calc_round_range(all);
  }
  return shot;
}

FrameOptions Follower::make_options(const Shot& shot, const Snapshot& before,
                                    std::shared_ptr<const SnapshotModel>& cropped) const {
  FrameOptions options = options_.frames;
  options.size[0] = view_width_;
  options.is_mirrored = false;
  const int centre = find_most_pulled(ledger_, shot.patch);
  const double aspect = static_cast<double>(options.size[0]) / options.size[1];
  const PatchAxes axes =
      find_patch_axes(before, shot.nodes, centre, calc_direction(options.azimuth, options.elevation));
  const CloseUp close = aim_at_patch(before, shot.nodes, centre, axes, aspect, options.zoom);
  cropped = crop_to_patch(before, shot.nodes, axes, close, aspect);
  options.pose = close.pose;
  options.cut = close.cut;
  options.bounds = close.bounds;
  return options;
}

ChartColumn Follower::make_charts(const Shot& shot) const {
  return {ledger_, shot.stories,
          LineChartOptions{.size = {options_.frames.size[0] - view_width_, options_.frames.size[1]},
                           .theme = options_.frames.theme,
                           .text_scale = 1.7,
                           .rasteriser_threads = options_.frames.rasteriser_threads}};
}

std::string Follower::extend_sidecar(const Shot& shot, const PatchFrame& frame,
                                     const std::string& sidecar) const {
  Json::Object json = Json::parse(sidecar).members();
  const SheetState& state = ledger_.sheet.states[frame.state];
  Json::Array charted, centre = make_list(shot.patch.centre);
  for (const int node : shot.charted) {
    const auto i = static_cast<std::size_t>(node);
    charted.push_back(Json::Object{{"node", node},
                                   {"normal_force_N", state.normal_force[i]},
                                   {"gap_mm", state.gap[i]},
                                   {"contact_pressure_MPa", state.contact_pressure[i]}});
  }
  json.emplace_back("patch", Json::Object{{"patch", shot.number},
                                          {"phase", to_string(frame.phase)},
                                          {"nodes", Json::Array(shot.nodes.begin(), shot.nodes.end())},
                                          {"first_increment", shot.patch.first_increment},
                                          {"last_increment", shot.patch.last_increment},
                                          {"first_time_s", shot.patch.first_time},
                                          {"centre_mm", centre},
                                          {"verdict", to_string(shot.patch.verdict)}});
  json.emplace_back("charted", charted);
  for (auto& [key, value] : json)
    if (key == "size_px") value = Json::Array{options_.frames.size[0], options_.frames.size[1]};
  json.emplace_back("view_size_px", Json::Array{view_width_, options_.frames.size[1]});
  return Json(json).write() + "\n";
}

FollowedPatch Follower::draw(int number) {
  const Shot shot = make_shot(number);
  const std::string name = name_sequence(number), view = options_.frames.views.front();
  FollowedPatch followed{number, (folder_.frames() / name).string(), 0};
  if (shot.frames.empty()) return followed;
  std::shared_ptr<const SnapshotModel> cropped;
  FramePainter painter(make_options(shot, *read(find_aim(shot.frames)), cropped));
  const ChartColumn charts = make_charts(shot);
  make_view_folder(folder_.frames().string(), name, true);
  for (const PatchFrame& frame : shot.frames) {
    if (options_.is_stopped && options_.is_stopped()) break;
    const auto whole = read(frame.state);
    Snapshot near = *whole;
    near.model = cropped;
    const FrameNumber place{followed.frames, static_cast<int>(shot.frames.size())};
    Frame drawn = painter.paint(view, near, place, shot.ranges);
    const std::string file = make_frame_name(folder_.frames().string(), name, ++followed.frames);
    Image image = make_image(options_.frames.size[0], options_.frames.size[1], Rgb{255, 255, 255});
    lay_picture(image, drawn.image, 0, 0);
    lay_picture(image, charts.draw({.now = whole->time, .let_go = shot.patch.first_time}), view_width_, 0);
    write_png(file + ".png", image, drawn.texts);
    // Forces and counts of the whole sheet, not of what is shown of it.
    Json::Object sidecar = Json::parse(painter.describe(view, *whole, place, shot.ranges)).members();
    write_whole_file(file + ".json", extend_sidecar(shot, frame, Json(sidecar).write()));
    if (options_.on_progress) options_.on_progress(++done_, total_);
  }
  return followed;
}

}  // namespace

std::vector<int> choose_patches(const Ledger& ledger, const FollowOptions& options, const std::string& name) {
  const int count = static_cast<int>(ledger.patches.size());
  if (count == 0) throw InputError(name + ": nothing let go in this run; there is no detachment to follow");
  const int nodes = static_cast<int>(ledger.sheet.neighbours.size());
  for (const int node : options.nodes)
    if (node < 0 || node >= nodes)
      throw InputError("--node " + std::to_string(node) + ": the sheet has nodes 0 to " +
                       std::to_string(nodes - 1));
  for (const int patch : options.patches)
    if (patch < 1 || patch > count)
      throw InputError("--patch " + std::to_string(patch) + ": the run has patches 1 to " +
                       std::to_string(count) + " (hydroscope inspect " + name + " lists them)");
  if (!options.patches.empty()) return options.patches;
  std::vector<int> patches;
  for (int i = 1; i <= count; ++i) patches.push_back(i);
  std::stable_sort(patches.begin(), patches.end(), [&](int a, int b) {
    return ledger.patches[static_cast<std::size_t>(a - 1)].nodes >
           ledger.patches[static_cast<std::size_t>(b - 1)].nodes;
  });
  patches.resize(std::min(patches.size(), static_cast<std::size_t>(kMostPatches)));
  std::sort(patches.begin(), patches.end());
  return patches;
}

std::vector<FollowedPatch> follow_detachment(const ResultFolder& folder, const Ledger& ledger,
                                             const FollowOptions& options) {
  require(options.frames.views.size() == 1, "a close-up shows one view");
  const std::vector<int> patches = choose_patches(ledger, options, folder.path.string());
  remove_earlier(folder, patches, options.patches.empty());
  int total = 0;
  for (const int patch : patches)
    total += static_cast<int>(
        find_patch_frames(ledger, ledger.patches[static_cast<std::size_t>(patch - 1)], options.around)
            .size());
  Follower follower(folder, ledger, options, total);
  std::vector<FollowedPatch> drawn;
  for (const int patch : patches) {
    if (options.is_stopped && options.is_stopped()) break;
    drawn.push_back(follower.draw(patch));
  }
  return drawn;
}

}  // namespace hydroscope
