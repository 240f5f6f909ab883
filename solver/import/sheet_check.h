// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/import/tool_report.h"

namespace hydroscope {

/// Compares the sizes of a tool's mesh and of the sheet: metres or inches taken for millimetres. Returns
/// false after an error, when other comparisons make no sense.
bool check_units(const TriangleMesh& mesh, const SheetSample& sheet, ToolReport& report);

/// On which side of the tool the sheet lies and how deep it begins inside.
void check_sheet_side(const ToolSurface& tool, const SheetSample& sheet, ToolReport& report);

}  // namespace hydroscope
