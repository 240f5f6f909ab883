// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hydroscope {

/// Sends VTK's errors and warnings to us instead of the terminal, and keeps VTK
/// from starting threads of its own; safe to call again. A picture drawn while VTK
/// complained is not to be trusted.
void set_up_vtk();

/// Takes what VTK has reported on this thread since the last call, "" if nothing.
std::string take_vtk_messages();

}  // namespace hydroscope
