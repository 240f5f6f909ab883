// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/inspect/ledger.h"

#include <algorithm>
#include <sstream>

#include "app/results/state_file.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "solver/scene/scene_reader.h"
#include "solver/scene/scene_source.h"

namespace hydroscope {
namespace {

Scene read_run_scene(const ResultFolder& folder) {
  std::vector<SceneOverride> overrides;
  std::istringstream lines(read_whole_file(folder.overrides()));
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) overrides.push_back(make_override(line));
  return parse_scene(read_whole_file(folder.scene()), folder.scene().string(), overrides);
}

/// The run's own tolerances; a touch counts as open beyond twice its tolerance (mechanics 9.4).
VerdictBounds make_bounds(const ContactScene& contact, const std::vector<double>& thickness) {
  const double thickest = thickness.empty() ? 0.0 : *std::max_element(thickness.begin(), thickness.end());
  const double touch = contact.tolerance > 0.0 ? contact.tolerance : 1e-3 * thickest;
  VerdictBounds bounds;
  bounds.opening = 2.0 * touch;
  bounds.tension = contact.release_tolerance;
  return bounds;
}

FacetNoiseModel make_noise_model(const Scene& scene, const SnapshotModel& model) {
  FacetNoiseModel noise;
  noise.modulus = scene.material.youngs_modulus / (1.0 - scene.material.poisson * scene.material.poisson);
  for (const SnapshotModel::Tool& tool : model.tools) {
    const auto found = scene.tools.find(tool.name);
    noise.tools.emplace_back();
    if (found == scene.tools.end()) continue;
    const ToolScene& keys = found->second;
    noise.tools.back() = {tool.mesh, find_tool_form(keys.shape, keys.surface), keys.crease_angle};
  }
  return noise;
}

std::vector<ToolMotion> gather_motions(const Scene& scene, const SnapshotModel& model) {
  std::vector<ToolMotion> motions;
  for (const SnapshotModel::Tool& tool : model.tools) {
    const auto found = scene.tools.find(tool.name);
    motions.push_back({tool.name, {}});
    if (found != scene.tools.end()) motions.back().rows = found->second.motion;
  }
  return motions;
}

SheetState read_sheet_state(const std::filesystem::path& file,
                            const std::shared_ptr<const SnapshotModel>& model, const SheetState* before) {
  const auto snapshot = read_state(file, model);
  try {
    SheetState state = make_sheet_state(*snapshot);
    if (before != nullptr && state.increment <= before->increment)
      throw InputError("its increment is not above that of the state before");
    if (before != nullptr && state.gap.size() != before->gap.size())
      throw InputError("it has another number of nodes than the state before");
    return state;
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

}  // namespace

Ledger make_ledger(ContactLog log, SheetHistory sheet, const VerdictBounds& bounds,
                   const FacetNoiseModel& noise, const std::vector<ToolMotion>& motions) {
  Ledger ledger;
  ledger.log = std::move(log);
  ledger.sheet = std::move(sheet);
  ledger.bounds = bounds;
  ledger.episodes = make_episodes(ledger.log);
  measure_releases(ledger.log, ledger.sheet, noise, motions, ledger.episodes);
  ledger.patches = make_patches(ledger.log, ledger.sheet.neighbours, ledger.episodes);
  for (Episode& episode : ledger.episodes) {
    if (!episode.let_go) continue;
    std::optional<int> back;
    if (episode.back) back = ledger.event(*episode.back).increment;
    const Judgement judged = judge_release(ledger.event(*episode.let_go), back, episode.figures, bounds);
    episode.verdict = judged.verdict;
    episode.reason = judged.reason;
  }
  count_verdicts(ledger.episodes, ledger.patches);
  return ledger;
}

Ledger read_ledger(const ResultFolder& folder) {
  if (!std::filesystem::is_directory(folder.path))
    throw InputError(folder.path.string() + ": there is no such folder");
  const auto files = find_states(folder);
  const auto model = read_model(folder.path, files.front());
  const Scene scene = read_run_scene(folder);
  const VerdictBounds bounds = make_bounds(scene.contact, read_state(files.front(), model)->thickness);
  SheetHistory sheet;
  for (const auto& file : files) {
    const SheetState* before = sheet.states.empty() ? nullptr : &sheet.states.back();
    sheet.states.push_back(read_sheet_state(file, model, before));
  }
  const int nodes = static_cast<int>(sheet.states.front().gap.size());
  sheet.neighbours = find_neighbours(model->quads, nodes);
  LogBounds known{nodes, {}};
  for (const SnapshotModel::Tool& tool : model->tools) known.tools.push_back(tool.name);
  ContactLog log = make_contact_log(CsvTable::read(folder.events()), CsvTable::read(folder.history()), known);
  Ledger ledger = make_ledger(std::move(log), std::move(sheet), bounds, make_noise_model(scene, *model),
                              gather_motions(scene, *model));
  ledger.title = model->title;
  ledger.tools = known.tools;
  return ledger;
}

}  // namespace hydroscope
