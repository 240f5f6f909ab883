// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_record.h"

#include <cstdio>

#include "solver/base/error.h"
#include "solver/import/tool_report.h"

namespace hydroscope {
namespace {

/// Health of the tool meshes, said before the run: a poor mesh spoils a good scene.
std::map<std::string, std::string> inspect_tools(const Scene& scene) {
  std::map<std::string, std::string> texts;
  for (const auto& [name, tool] : scene.tools) {
    if (tool.shape != "mesh") continue;
    const ToolReport report = inspect_tool(tool, name, scene.directory, {});
    if (!report.errors.empty()) throw InputError(scene.file + ": " + report.errors.front());
    for (const std::string& warning : report.warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
    texts[name] = format_tool_report(report);
  }
  return texts;
}

}  // namespace

RunRecord make_scene_record(const Scene& scene, const std::vector<SceneOverride>& overrides, int threads) {
  RunRecord record;
  record.tool_reports = inspect_tools(scene);
  record.scene_file = scene.file;
  record.scene_text = read_whole_file(scene.file);
  for (const SceneOverride& item : overrides) record.overrides.push_back(item.key + "=" + item.value);
  record.threads = threads;
  record.end_time = scene.end_time();
  record.accuracy = scene.accuracy;
  record.choices = scene.choices;
  return record;
}

}  // namespace hydroscope
