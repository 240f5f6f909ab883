// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "render/draw_list.h"
#include "render/image/image.h"
#include "render/image/pixel_box.h"

namespace hydroscope {

/// Title, time label, legends, colour bars and the axes, over a drawn picture.
/// Returns the boxes that hold all pixels it has changed.
std::vector<PixelBox> draw_overlay(Image& image, const Legend& legend, const std::string& title,
                                   const std::string& time_label, const CameraPose& camera,
                                   const Theme& theme);
/// The same for small pictures too: letters grow less than the picture shrinks, `letters` times their size,
/// and words that find no room are left out.
std::vector<PixelBox> draw_overlay(Image& image, const Legend& legend, const std::string& title,
                                   const std::string& time_label, const CameraPose& camera,
                                   const Theme& theme, double letters);

/// Lines of a report in a panel along the lower edge, in columns as given.
void draw_report(Image& image, const std::vector<std::string>& lines, const Theme& theme);
/// The share of the picture's height that it takes.
double calc_report_height(int lines);

}  // namespace hydroscope
