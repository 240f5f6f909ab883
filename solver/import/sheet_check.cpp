// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/import/sheet_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace hydroscope {

namespace {

// Tools are seldom 100 times smaller than their sheet; metres make them 1000 times smaller.
constexpr double kMetres = 100.0;
constexpr double kInches = 12.0;
constexpr double kMicrometres = 1.0 / 200.0;
// Facets and curved sheets leave some penetration at the start; more than this part of the wall is a mistake.
constexpr double kDeep = 0.02;

template <class... Numbers>
std::string format(const char* text, Numbers... numbers) {
  char line[512];
  std::snprintf(line, sizeof line, text, numbers...);
  return line;
}

double calc_diagonal(const std::vector<Vec3>& points) {
  Vec3 low = points.front();
  Vec3 high = low;
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

struct PartCount {
  int points = 0, behind = 0;
};

void judge_side(const std::vector<PartCount>& parts, ToolReport& report) {
  int seen = 0;
  int turned = 0;
  for (const PartCount& part : parts) {
    if (part.points == 0) continue;
    ++seen;
    if (2 * part.behind > part.points) ++turned;
  }
  if (turned == 0) return;
  const double behind = 100.0 * (1.0 - report.place.free_fraction);
  // A tool that is too tight has the whole sheet a little behind it, too.
  const double deepest = std::max(0.0, -report.place.smallest_gap);
  if (turned == seen && report.sheet.thickness > 0.0 && deepest < report.sheet.thickness) {
    report.errors.push_back(format(
        "tool.%s: %.0f %% of the sheet's points begin behind the surface, up to %.3g mm: the tool is on the "
        "wrong side (set flip = true, or false if it is set) or too tight",
        report.name.c_str(), behind, deepest));
  } else if (turned == seen) {
    report.errors.push_back(
        format("tool.%s: the sheet is on the wrong side of the tool (%.0f %% of its points "
               "are behind the surface): set flip = true, or false if it is set",
               report.name.c_str(), behind));
  } else {
    report.errors.push_back(
        format("tool.%s: %d of the tool's %d parts that face the sheet are turned away from "
               "it: orient them alike in the file, or make them tools of their own with flip",
               report.name.c_str(), turned, seen));
  }
}

void judge_penetration(const SheetSample& sheet, ToolReport& report) {
  const SheetPlace& place = report.place;
  const double size = sheet.thickness > 0.0 ? sheet.thickness : 0.02 * calc_diagonal(sheet.points);
  if (place.largest_penetration <= 1e-3 * size) return;
  const Vec3& x = place.deepest_point;
  const std::string what =
      format("tool.%s: the sheet begins %.3g mm inside the tool (at %.2f, %.2f, %.2f mm)",
             report.name.c_str(), place.largest_penetration, x.x(), x.y(), x.z());
  if (place.largest_penetration > kDeep * size) {
    report.errors.push_back(what + ": move the tool, or change the sheet's radius or thickness");
  } else {
    report.warnings.push_back(what + ": it is pushed out in the first increment");
  }
}

}  // namespace

bool check_units(const TriangleMesh& mesh, const SheetSample& sheet, ToolReport& report) {
  if (sheet.points.empty()) return true;
  const double tool = calc_diagonal(mesh.points);
  const double sheet_size = calc_diagonal(sheet.points);
  const double ratio = sheet_size / tool;
  const std::string sizes = format("tool.%s: the tool is %.3g mm in size, the sheet %.3g mm",
                                   report.name.c_str(), tool, sheet_size);
  if (ratio > kMetres) {
    report.errors.push_back(sizes + ": metres taken for millimetres? Set unit_scale = 1000");
    return false;
  }
  if (ratio < kMicrometres) {
    report.errors.push_back(sizes + ": if the file is in micrometres, set unit_scale = 0.001");
    return false;
  }
  if (ratio > kInches) {
    report.warnings.push_back(sizes + ": if the file is in inches, set unit_scale = 25.4");
  }
  return true;
}

void check_sheet_side(const ToolSurface& tool, const SheetSample& sheet, ToolReport& report) {
  if (sheet.points.empty()) return;
  const std::vector<int> part_of_facet = tool.list_parts();
  const int part_count =
      part_of_facet.empty() ? 1 : 1 + *std::max_element(part_of_facet.begin(), part_of_facet.end());
  std::vector<PartCount> parts(static_cast<std::size_t>(part_count));
  const double reach = 2.0 * (calc_diagonal(sheet.points) + calc_diagonal(tool.display_mesh().points)) + 1e3;
  // A sheet that touches may lie behind by rounding, and by what is allowed.
  const double touch = std::max(kDeep * sheet.thickness, 1e-6);
  SheetPlace& place = report.place;
  place.smallest_gap = std::numeric_limits<double>::infinity();
  int behind = 0;
  SearchHint hint;
  for (const Vec3& x : sheet.points) {
    const auto foot = tool.find_foot_point(x, reach, reach, hint);
    // Points of a sheet that is longer than the tool say nothing about the side.
    if (!foot || foot->beyond_edge > std::max(1e-6, 0.1 * std::abs(foot->gap))) continue;
    const std::size_t part =
        part_of_facet.empty()
            ? 0
            : static_cast<std::size_t>(part_of_facet[static_cast<std::size_t>(foot->facet)]);
    ++place.points;
    ++parts[part].points;
    if (foot->gap < -touch) {
      ++behind;
      ++parts[part].behind;
    }
    if (foot->gap < place.smallest_gap) {
      place.smallest_gap = foot->gap;
      place.deepest_point = x;
    }
  }
  if (place.points == 0) {
    place.smallest_gap = 0.0;
    report.warnings.push_back("tool." + report.name + ": no point of the sheet faces the tool at the start");
    return;
  }
  place.free_fraction = 1.0 - static_cast<double>(behind) / place.points;
  judge_side(parts, report);
  if (!report.errors.empty()) return;
  place.largest_penetration = std::max(0.0, -place.smallest_gap);
  judge_penetration(sheet, report);
}

}  // namespace hydroscope
