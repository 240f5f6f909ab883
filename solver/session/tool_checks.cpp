// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/tool_checks.h"

#include "solver/base/error.h"
#include "solver/import/tool_report.h"

namespace hydroscope {

namespace {

/// The face of the sheet that meets the tool, in the tool's own frame at the start (4.63).
SheetSample sample_sheet(const Model& model, const Tool& tool) {
  SheetSample sheet;
  sheet.element_size = model.element_size;
  sheet.thickness = model.thickness;
  const Vec3 translation = tool.calc_translation(0.0);
  for (std::size_t i = 0; i < model.x0.size(); ++i) {
    sheet.points.push_back(model.x0[i] + tool.side * 0.5 * model.thickness * model.triad0[i].v - translation);
  }
  return sheet;
}

}  // namespace

void check_tools(const Model& model, const Scene& scene) {
  for (const Tool& tool : model.tools) {
    const ToolReport report =
        inspect_start(*tool.surface, scene.tools.at(tool.name), tool.name, sample_sheet(model, tool));
    if (!report.errors.empty()) throw InputError(scene.file + ": " + report.errors.front());
  }
}

}  // namespace hydroscope
