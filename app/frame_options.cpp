// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame_options.h"

#include <sstream>

#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "solver/scene/scene_reader.h"

namespace hydroscope {
namespace {

std::string quote(const std::string& text) { return "\"" + text + "\""; }

std::string make_list(const std::string& comma_separated) {
  std::istringstream stream(comma_separated);
  std::string list;
  for (std::string item; std::getline(stream, item, ',');) list += (list.empty() ? "" : ", ") + quote(item);
  return "[" + list + "]";
}

/// The run's own overrides first, so that those of today have the last word.
std::vector<SceneOverride> gather_overrides(const ResultFolder& folder, const Arguments& arguments) {
  std::vector<SceneOverride> overrides;
  std::istringstream lines(read_whole_file(folder.overrides()));
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty()) overrides.push_back(make_override(line));
  }
  for (SceneOverride& item : make_overrides(arguments)) {
    if (!item.key.starts_with("frames.")) {
      throw InputError(item.shown + ": the run is over; only keys of [frames] can be changed here");
    }
    overrides.push_back(std::move(item));
  }
  return overrides;
}

}  // namespace

FramesScene read_frames_scene(const ResultFolder& folder, const Arguments& arguments) {
  const std::vector<SceneOverride> overrides = gather_overrides(folder, arguments);
  return parse_scene(read_whole_file(folder.scene()), folder.scene().string(), overrides).frames;
}

std::array<int, 2> parse_size(const std::string& option, const std::string& text) {
  const size_t cross = text.find('x');
  if (cross == std::string::npos) {
    throw InputError(option + " " + text + ": write it as WIDTHxHEIGHT, e.g. " + option + " 1280x720");
  }
  return {parse_whole_number(option, text.substr(0, cross), 64, 8192),
          parse_whole_number(option, text.substr(cross + 1), 64, 8192)};
}

std::vector<SceneOverride> make_overrides(const Arguments& arguments) {
  std::vector<SceneOverride> overrides;
  const auto add = [&](const std::string& option, const std::string& key, const std::string& value) {
    overrides.push_back({"frames." + key, value, option + " " + arguments.get(option)});
  };
  if (arguments.has("--views")) add("--views", "views", make_list(arguments.get("--views")));
  if (arguments.has("--frames")) {
    add("--frames", "pick", quote("number"));
    add("--frames", "number", arguments.get("--frames"));
  }
  if (arguments.has("--size")) {
    const auto [width, height] = parse_size("--size", arguments.get("--size"));
    add("--size", "size_px", "[" + std::to_string(width) + ", " + std::to_string(height) + "]");
  }
  if (arguments.has("--theme")) add("--theme", "theme", quote(arguments.get("--theme")));
  if (arguments.has("--animation")) add("--animation", "animation", quote(arguments.get("--animation")));
  if (arguments.has("--camera")) {
    const std::string camera = arguments.get("--camera");
    const size_t colon = camera.find(':');
    add("--camera", "camera", quote(camera.substr(0, colon)));
    if (colon != std::string::npos) add("--camera", "look_at_node", camera.substr(colon + 1));
  }
  for (const std::string& assignment : arguments.get_all("--set"))
    overrides.push_back(make_override(assignment));
  return overrides;
}

}  // namespace hydroscope
