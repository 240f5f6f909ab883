// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/run_record.h"

#include <array>
#include <cstdio>

#include "app/results/json.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"
#include "solver/scene/scene_reader.h"

namespace hydroscope {

std::string calc_text_hash(const std::string& text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  std::array<char, 20> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
  return digits.data();
}

std::string calc_file_hash(const std::filesystem::path& file) {
  return calc_text_hash(read_whole_file(file));
}

std::string calc_run_key(const std::string& program_hash, const std::string& scene_file, const StudyRun& run,
                         int threads) {
  std::string all = program_hash + "\n" + calc_file_hash(scene_file) + "\n" + std::to_string(threads) + "\n";
  for (const SceneOverride& item : run.overrides) all += item.key + "=" + item.value + "\n";
  const Scene scene = read_scene(scene_file, run.overrides);
  const std::filesystem::path folder = scene.directory;
  for (const auto& [name, tool] : scene.tools)
    if (!tool.file.empty()) all += calc_file_hash(folder / tool.file) + "\n";
  if (scene.sheet == "mesh") all += calc_file_hash(folder / scene.mesh.file) + "\n";
  return calc_text_hash(all);
}

std::optional<RunEnd> read_run_end(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  try {
    const Json json = Json::parse(read_whole_file(file));
    return RunEnd{json.at("key").text(), static_cast<int>(json.at("exit_code").number()),
                  json.at("elapsed_s").number(), json.at("time_limit_s").number(), json.at("message").text()};
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void write_run_end(const std::filesystem::path& file, const RunEnd& end) {
  const Json json = Json::Object{{"key", end.key},
                                 {"exit_code", end.exit_code},
                                 {"elapsed_s", end.elapsed},
                                 {"time_limit_s", end.time_limit},
                                 {"message", end.message}};
  write_whole_file(file, json.write() + "\n");
}

}  // namespace hydroscope
