// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/increment/model.h"

namespace hydroscope {

/// Refuses tools that the sheet cannot start from: sheet on the wrong side, sheet
/// through the tool by more than the allowance, units mistaken. Throws InputError
/// naming the tool, what was found and what to do.
void check_tools(const Model& model, const Scene& scene);

}  // namespace hydroscope
