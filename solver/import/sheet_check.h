// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/import/tool_report.h"

namespace hydroscope {

/// Compares the boxes of tool and sheet: metres or inches taken for millimetres. Returns false after an
/// error, when other comparisons make no sense.
bool check_units(const SheetSample& sheet, ToolReport& report);

/// On which side of the tool the sheet lies and how deep it begins inside. `part_of_facet`: connected
/// part of each facet of a mesh; empty for analytic tools.
void check_sheet_side(const ToolSurface& tool, const std::vector<int>& part_of_facet,
                      const SheetSample& sheet, ToolReport& report);

}  // namespace hydroscope
