// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check/baseline.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include "render/frame_files.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

namespace fs = std::filesystem;

constexpr int kVersion = 1;  // of the folder's form

/// One table for both directions; `Io` reads or writes a member.
template <class Options, class Io>
void visit_options(Options& o, const Io& io) {
  io("smoothing", o.smoothing);
  io("theme", o.theme);
  io("camera", o.camera);
  io("azimuth_deg", o.azimuth);
  io("elevation_deg", o.elevation);
  io("zoom", o.zoom);
  io("orbit_deg", o.orbit);
  io("look_at_node", o.look_at_node);
  io("mirror", o.is_mirrored);
  io("facet_normals", o.facet_normals);
  io("element_edges", o.element_edges);
  io("tool_opacity", o.tool_opacity);
  io("cut_tools", o.is_tool_cut);
  io("most_arrows", o.most_arrows);
}

Json make_options(const FrameOptions& options) {
  Json::Object json;
  Json::Array views;
  for (const std::string& view : options.views) views.emplace_back(view);
  json.emplace_back("views", views);
  json.emplace_back("size_px", Json::Array{options.size[0], options.size[1]});
  visit_options(options,
                [&json](const char* key, const auto& value) { json.emplace_back(key, Json(value)); });
  return json;
}

struct OptionReader {
  const Json& json;
  void operator()(const char* key, int& value) const {
    value = static_cast<int>(std::lround(json.at(key).number()));
  }
  void operator()(const char* key, double& value) const { value = json.at(key).number(); }
  void operator()(const char* key, bool& value) const { value = json.at(key).flag(); }
  void operator()(const char* key, std::string& value) const { value = json.at(key).text(); }
};

FrameOptions read_options(const Json& json) {
  FrameOptions options;
  options.views.clear();
  for (const Json& view : json.at("views").items()) options.views.push_back(view.text());
  for (std::size_t k = 0; k < 2; ++k)
    options.size[k] = static_cast<int>(std::lround(json.at("size_px").items().at(k).number()));
  visit_options(options, OptionReader{json});
  return options;
}

Baseline parse(const Json& json) {
  Baseline baseline;
  if (json.at("version").number() != kVersion) throw InputError("a form of another version");
  baseline.options = read_options(json.at("options"));
  const Json& by = json.at("drawn_by");
  baseline.fingerprint = {{by.at("renderer").text(), by.at("opengl").text()},
                          by.at("font").text(),
                          by.at("probe").text(),
                          by.at("lettering_probe").text()};
  for (const Json& state : json.at("states").items()) {
    const Json::Array& items = state.items();
    if (items.size() != 2) throw InputError("a state has increment and time");
    baseline.states.push_back({static_cast<int>(baseline.states.size()),
                               static_cast<int>(std::lround(items[0].number())), items[1].number()});
  }
  for (const Json& frame : json.at("pictures").items())
    baseline.pictures.push_back(static_cast<int>(std::lround(frame.number())));
  return baseline;
}

bool is_kept(const Baseline& baseline, const fs::path& file) {
  const std::string view = file.parent_path().filename().string();
  const auto& views = baseline.options.views;
  if (std::find(views.begin(), views.end(), view) == views.end()) return false;
  const int frame = std::stoi(file.stem().string());
  return file.extension() == ".png" ? baseline.has_picture(frame)
                                    : frame >= 1 && frame <= static_cast<int>(baseline.states.size());
}

}  // namespace

bool Baseline::has_picture(int frame) const {
  return std::binary_search(pictures.begin(), pictures.end(), frame);
}

std::vector<int> pick_pictures(int frames, int most) {
  std::vector<int> picked;
  const int count = std::min(frames, most);
  for (int i = 0; i < count; ++i) picked.push_back(count == 1 ? frames : 1 + i * (frames - 1) / (count - 1));
  return picked;
}

bool has_baseline(const fs::path& folder) { return fs::exists(folder / "baseline.json"); }

Baseline read_baseline(const fs::path& folder) {
  const fs::path file = folder / "baseline.json";
  if (!fs::exists(file))
    throw InputError(file.string() + ": there is no baseline; --update makes one from these states");
  try {
    return parse(Json::parse(read_whole_file(file)));
  } catch (const InputError& error) {
    throw InputError(file.string() + ": " + error.what());
  }
}

fs::path make_baseline_name(const fs::path& folder, const std::string& view, int frame) {
  return make_frame_name(folder.string(), view, frame);
}

Json read_baseline_sidecar(const fs::path& folder, const std::string& view, int frame) {
  const std::string file = make_baseline_name(folder, view, frame).string() + ".json";
  try {
    return Json::parse(read_whole_file(file));
  } catch (const InputError& error) {
    throw InputError(file + ": " + error.what());
  }
}

PngPicture read_baseline_picture(const fs::path& folder, const std::string& view, int frame) {
  const std::string file = make_baseline_name(folder, view, frame).string() + ".png";
  if (!fs::exists(file)) throw InputError(file + ": the baseline's picture is missing");
  return read_png(file);
}

void write_baseline(const Baseline& baseline, const fs::path& folder) {
  Json::Array states, pictures;
  for (const StateStamp& state : baseline.states)
    states.emplace_back(Json::Array{state.increment, state.time});
  for (const int frame : baseline.pictures) pictures.emplace_back(frame);
  const RendererFingerprint& by = baseline.fingerprint;
  const Json json = Json::Object{{"version", kVersion},
                                 {"options", make_options(baseline.options)},
                                 {"drawn_by", Json::Object{{"renderer", by.renderer.renderer},
                                                           {"opengl", by.renderer.version},
                                                           {"font", by.font},
                                                           {"probe", by.probe},
                                                           {"lettering_probe", by.lettering_probe}}},
                                 {"states", states},
                                 {"pictures", pictures}};
  write_whole_file(folder / "baseline.json", json.write() + "\n");
  static const std::regex known(R"([a-z-]+/\d{5}\.(png|json))");
  std::vector<fs::path> stale;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    if (std::regex_match(name, known) && !is_kept(baseline, entry.path())) stale.push_back(entry.path());
  }
  for (const fs::path& file : stale) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw EnvironmentError(file.string() + ": cannot be removed: " + error.message());
  }
}

}  // namespace hydroscope
