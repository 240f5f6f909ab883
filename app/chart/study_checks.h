// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/chart/study.h"

namespace hydroscope {

/// Fills in labels that were not given, and checks what names what within a study.
void check_study(Study& study);
/// Reads every scene with every set of settings. Throws InputError that names the study's line.
void check_study_scenes(const Study& study);

}  // namespace hydroscope
