// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line.h"
#include "app/exit_code.h"

namespace hydroscope {

/// hydroscope render DIR --follow detachment.
ExitCode follow_results(const Arguments& arguments);

}  // namespace hydroscope
