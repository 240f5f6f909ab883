// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace hydroscope {

/// The shortest decimal that reads back as the very same `number`.
std::string format_exact(double number);

}  // namespace hydroscope
