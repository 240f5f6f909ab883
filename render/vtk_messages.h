// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hydroscope {

/// Sends VTK's errors and warnings to us instead of the terminal; safe to call
/// again. A picture drawn while VTK complained is not to be trusted.
void catch_vtk_messages();

/// Takes what VTK has reported on this thread since the last call, "" if nothing.
std::string take_vtk_messages();

}  // namespace hydroscope
