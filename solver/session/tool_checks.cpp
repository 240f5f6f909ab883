// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/session/tool_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "solver/base/error.h"

namespace hydroscope {

namespace {

std::string place(const Vec3& x) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.3f, %.3f, %.3f) mm", x[0], x[1], x[2]);
  return text;
}

std::string number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", v);
  return text;
}

double calc_size(const std::vector<Vec3>& points) {
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (const Vec3& x : points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).maxCoeff();
}

void check_units(const std::string& where, const ToolScene& scene, double tool_size, double sheet_size) {
  if (scene.shape != "mesh") return;
  const double ratio = sheet_size / tool_size;
  if (ratio > 50.0) {
    throw InputError(where + ": the tool is only " + number(tool_size) + " mm large, the sheet " +
                     number(sheet_size) + " mm; is the file in metres? Set unit_scale = 1000 (inches: 25.4)");
  }
  if (ratio < 1.0 / 200.0) {
    throw InputError(where + ": the tool is " + number(tool_size) + " mm large, the sheet only " +
                     number(sheet_size) + " mm; is unit_scale = " + number(scene.unit_scale) + " meant?");
  }
}

struct Sides {
  int front = 0, behind = 0;
  double deepest = 0.0;
  Vec3 at = Vec3::Zero();
};

Sides count_sides(const Model& model, const Tool& tool, double reach) {
  Sides sides;
  const Vec3 translation = tool.calc_translation(0.0);
  for (std::size_t i = 0; i < model.x0.size(); ++i) {
    const Vec3 x = model.x0[i] + tool.side * 0.5 * model.thickness * model.triad0[i].v - translation;
    SearchHint hint;
    const auto foot = tool.surface->find_foot_point(x, reach, reach, hint);
    if (!foot || foot->beyond_edge > 0.0) continue;
    ++(foot->gap >= 0.0 ? sides.front : sides.behind);
    if (foot->gap < sides.deepest) {
      sides.deepest = foot->gap;
      sides.at = x + translation;
    }
  }
  return sides;
}

}  // namespace

void check_tools(const Model& model, const Scene& scene) {
  const double sheet_size = calc_size(model.x0);
  for (const Tool& tool : model.tools) {
    const ToolScene& settings = scene.tools.at(tool.name);
    const std::string where =
        scene.file + ": tool." + tool.name + (settings.file.empty() ? "" : " (" + settings.file + ")");
    check_units(where, settings, calc_size(tool.surface->display_mesh().points), sheet_size);
    const Sides sides = count_sides(model, tool, 0.5 * sheet_size);
    if (sides.behind > 3 * sides.front && -sides.deepest > model.thickness) {
      throw InputError(where + ": the sheet lies behind the tool at " + std::to_string(sides.behind) +
                       " of " + std::to_string(sides.behind + sides.front) +
                       " nodes; the tool's normals point away from it: " +
                       (settings.shape == "mesh" ? "set flip = true" : "check side, direction and face"));
    }
    const double allowed = 0.02 * model.thickness;
    if (-sides.deepest > allowed) {
      throw InputError(where + ": the sheet goes through the tool by " + number(-sides.deepest) + " mm at " +
                       place(sides.at) + " before the start; allowed " + number(allowed) +
                       " mm (2 % of the thickness). Move the tool (position_mm) or make room for the sheet");
    }
  }
}

}  // namespace hydroscope
