// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "render/image/image.h"

namespace hydroscope {

/// The picture as JPEG bytes; `quality` 1..100. Alpha is dropped. Throws EnvironmentError.
std::string make_jpeg(const Image& image, int quality);

}  // namespace hydroscope
