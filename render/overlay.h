// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "render/draw_list.h"
#include "render/image/image.h"

namespace hydroscope {

/// Title, time label, legends, colour bars and the axes, over a drawn picture.
void draw_overlay(Image& image, const Legend& legend, const std::string& title, const std::string& time_label,
                  const CameraPose& camera, const Theme& theme);

}  // namespace hydroscope
